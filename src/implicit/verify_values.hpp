// Values of one polynomial at many points modulo a prime.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/algebra/prime_field.hpp"
#include "implicit/verify_sums.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::implicit {

/// A polynomial over GF(p), p below 2^30, as a tree: level k has a node for each vector of exponents of the
/// first k variables, its children are those with one exponent more, and the leaves are coefficients.
///
///     x²y³ + 5x²y + 7          root ─┬─ x² ─┬─ y³ : 1
///                                    │      └─ y¹ : 5
///                                    └─ x⁰ ─── y⁰ : 7
///
/// A value is the sum, at each node, of power·(value of the child): little more than one multiplication a
/// term. Several points are evaluated at a time, so that the sums are of short vectors.
class ValuesModulo {
  public:
    using Element = algebra::PrimeField::Element;
    static constexpr std::uint64_t prime_bound = std::uint64_t{1} << 30;
    static constexpr std::size_t lanes = 8;
    using Lanes = std::array<Element, lanes>;

    ValuesModulo(const algebra::Polynomial& f, const algebra::PrimeField& field);

    /// \param points for each variable its values at `lanes` points
    Lanes operator()(std::span<const Lanes> points);

  private:
    struct Level {
        std::vector<std::uint32_t> exponents; ///< of a node, what its edge adds
        std::vector<std::size_t>
            first_child; ///< one more than there are nodes; children are on the next level
    };

    void sum_children(const Level& parents, const Level& children, const std::vector<Lanes>& powers,
                      const std::vector<Lanes>& values, std::vector<Lanes>& sums) const;

    algebra::PrimeField field_;
    std::vector<std::size_t> order_; ///< the variable of each level
    ProductSums sum_ = product_sums(base::best_vector_unit());
    std::vector<Level> levels_; ///< 0 is the root alone
    std::vector<Element> coefficients_;
    std::vector<std::uint32_t> degrees_; ///< at each level
    std::vector<Lanes> values_;
    std::vector<Lanes> sums_;
    std::vector<Lanes> powers_;
};

} // namespace eliminant::implicit
