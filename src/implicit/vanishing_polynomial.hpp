// Polynomials over GF(p) that vanish at points, by linear algebra.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/run.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::implicit {

/// Monomials in a few coordinates, as rows of exponents.
class Support {
  public:
    explicit Support(std::size_t coordinates) : coordinates_(coordinates) {}

    std::size_t coordinates() const { return coordinates_; }
    std::size_t size() const { return size_; }
    std::span<const std::uint32_t> operator[](std::size_t i) const {
        return std::span(exponents_).subspan(i * coordinates_, coordinates_);
    }
    void add(std::span<const std::uint32_t> exponents);
    /// Those whose coefficients are not zero; there may be fewer coefficients than monomials.
    Support where_nonzero(std::span<const std::uint32_t> coefficients) const;

    /// The same monomials in more coordinates: coordinate i becomes places[i].
    Support embedded(std::size_t coordinates, std::span<const std::size_t> places) const;

    /// The monomials of weighted degree at most `degree`, ascending by weighted degree; weights are positive.
    static Support up_to(std::span<const std::uint64_t> weights, std::uint64_t degree);
    /// How many up_to() has, or `limit` if they are more.
    static std::size_t count_up_to(std::span<const std::uint64_t> weights, std::uint64_t degree,
                                   std::size_t limit);

    /// All monomials at a point, one value a coordinate.
    void evaluate(const algebra::PrimeField& field, std::span<const std::uint32_t> point,
                  std::span<std::uint32_t> values) const;

  private:
    std::size_t coordinates_;
    std::size_t size_ = 0;
    std::vector<std::uint32_t> exponents_;
};

/// Where the next point comes from; nullopt if none could be found.
using PointSource = std::function<std::optional<std::vector<std::uint32_t>>()>;

/// A linear combination of the first monomials of a support, the last coefficient of which is 1.
using Coefficients = std::vector<std::uint32_t>;

/// The combination divided by its leading coefficient, in a ring over GF(p).
algebra::Polynomial monic_polynomial(const algebra::Ring& ring, const Support& support,
                                     const Coefficients& coefficients);

/// The combination of as few of the first monomials as possible that vanishes at the points of a source, if
/// these are general points of an irreducible set: with monomials in the sequence of an admissible order, the
/// element of least leading monomial. It was found to vanish at more points than it has coefficients.
/// nullopt if all monomials are independent, or points run out.
std::optional<Coefficients> first_vanishing(const algebra::PrimeField& field, const Support& support,
                                            const PointSource& points, base::Run& run);

} // namespace eliminant::implicit
