// Computing in ℚ[x₁, …, xₙ]/I, I of dimension zero.
#pragma once

#include "eliminant/algebra/integer.hpp"
#include "groebner/staircase.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// QuotientAlgebra over ℚ: slower by the size of the numbers, and therefore used only where a proof needs it.
class RationalQuotient {
  public:
    /// Numerators over one positive denominator, in lowest terms.
    struct Vector {
        std::vector<algebra::Integer> numerators;
        algebra::Integer denominator = algebra::Integer(1);
    };

    /// `basis` is the reduced basis over ℚ that the staircase is of. All arguments must outlive it.
    RationalQuotient(const Staircase& staircase, std::span<const algebra::Polynomial> basis, base::Run& run);

    std::size_t size() const { return staircase_.size(); }
    /// The standard monomial b.
    Vector unit(std::uint32_t b) const;
    Vector times_variable(std::size_t variable, const Vector& element);
    /// The normal form of x_variable·b for the standard monomial b.
    Vector product(std::size_t variable, std::uint32_t b);

  private:
    const Vector& border_normal_form(std::uint32_t i);
    Vector tail_normal_form(std::uint32_t element) const;

    const Staircase& staircase_;
    std::span<const algebra::Polynomial> basis_;
    base::Run& run_;
    std::vector<Vector> border_; ///< without numerators while unknown
};

} // namespace eliminant::groebner
