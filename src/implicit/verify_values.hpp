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

/// The exponents of a polynomial as a tree: level k has a node for each vector of exponents of the first k
/// variables, its children are those with one exponent more, and the leaves are the terms.
///
///     x²y³ + 5x²y + 7          root ─┬─ x² ─┬─ y³ : 1
///                                    │      └─ y¹ : 5
///                                    └─ x⁰ ─── y⁰ : 7
///
/// A value is the sum, at each node, of power·(value of the child): little more than one multiplication a
/// term. The variables that are `fixed` are the last ones, so the nodes where they begin hold the
/// coefficients of a polynomial in the others.
class ExponentTree {
  public:
    /// \param fixed which variables are; none by default
    explicit ExponentTree(const algebra::Polynomial& f, const std::vector<bool>& fixed = {});

    std::size_t depth() const { return order_.size(); }
    /// The level where the fixed variables begin.
    std::size_t cut() const { return cut_; }
    /// The variable whose powers lead from this level to the next.
    std::size_t variable(std::size_t level) const { return order_[level]; }
    std::uint32_t degree(std::size_t level) const { return degrees_[level]; }
    std::size_t node_count(std::size_t level) const { return exponents_[level].size(); }
    /// From this level to the next.
    TreeEdges edges(std::size_t level) const {
        return {first_child_[level].data(), node_count(level), exponents_[level + 1].data()};
    }
    /// The coefficients modulo p, p no divisor of their denominator, in the sequence of the leaves.
    std::vector<algebra::PrimeField::Element> leaves(const algebra::Polynomial& f,
                                                     const algebra::PrimeField& field) const;

  private:
    std::vector<std::size_t> order_; ///< the variable of each level
    std::size_t cut_;
    std::vector<std::size_t> terms_;                      ///< by leaf
    std::vector<std::vector<std::uint32_t>> exponents_;   ///< by level and node, what its edge adds
    std::vector<std::vector<std::uint32_t>> first_child_; ///< by level, one more than there are nodes
    std::vector<std::uint32_t> degrees_;                  ///< by level
};

/// A polynomial over GF(p), p odd and below 2^30, to be evaluated at several points at a time, so that the
/// sums are of short vectors.
class ValuesModulo {
  public:
    using Element = algebra::PrimeField::Element;
    static constexpr std::uint64_t prime_bound = std::uint64_t{1} << 30;
    static constexpr std::size_t lanes = evaluation_lanes;
    using Lanes = std::array<Element, lanes>;

    /// \param tree of f; it must outlive this
    ValuesModulo(const ExponentTree& tree, const algebra::Polynomial& f, const algebra::PrimeField& field);

    /// Gives the fixed variables values. \param points for each variable its values at `lanes` points
    void fix(std::span<const Lanes> points);
    /// The values where the other variables have these values.
    Lanes operator()(std::span<const Lanes> points);

  private:
    void climb_from(std::size_t level, const std::vector<Lanes>& values, std::vector<Lanes>& sums,
                    std::span<const Lanes> points);

    const ExponentTree* tree_;
    MontgomeryModulus modulus_;
    EvaluationLoops loops_ = evaluation_loops(base::best_vector_unit());
    std::vector<Element> leaves_;
    std::vector<Lanes> fixed_values_; ///< of the nodes at the cut, if there is anything fixed
    std::vector<Lanes> values_;
    std::vector<Lanes> sums_;
    std::vector<std::uint64_t> powers_;
};

} // namespace eliminant::implicit
