// Products by evaluation and interpolation.
#pragma once

#include "eliminant/algebra/integer.hpp"
#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/algebra/term_list.hpp"
#include "eliminant/base/run.hpp"

#include "exponent_set.hpp"
#include "product_box.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// The product of two polynomials from their values at a set of points that holds the product's exponents
/// (PointTransform): the part of their ProductBox below the sum of the total degrees. With N points of mean
/// degree d it takes O(N·d) operations a prime, which are few instructions on vectors, where term by term it
/// takes #a·#b. Fateman's product of 10626 by 10626 terms has N = 135751 and d = 32: a twentieth of the
/// operations.
///
/// Coefficients in ℤ are found modulo as many primes as it takes; those in GF(p) modulo p, or as integers if
/// p does not exceed the exponents.
class PointProduct {
  public:
    using Word = MonomialLayout::Word;

    /// nullopt where exponents are too large, or the points too many beside the products of terms, for this
    /// to be of use.
    static std::optional<PointProduct> plan(const MonomialLayout& target, const MonomialLayout& layout_a,
                                            std::span<const Word> a, const MonomialLayout& layout_b,
                                            std::span<const Word> b);

    /// Nanoseconds that it is expected to take, where coefficients of the product have so many bits …
    double cost(std::size_t bits) const;
    /// … before they are reduced modulo the characteristic of a field.
    double cost(std::size_t bits, const PrimeField& field) const;

    /// The product of factors with the monomials of the plan. \param bits such that no coefficient, in GF(p)
    /// before reduction, exceeds 2^bits in size
    IntegerTerms multiply(std::span<const Integer> a, std::span<const Integer> b, std::size_t bits,
                          const base::Run& run) const;
    ResidueTerms multiply(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b,
                          std::size_t bits, const PrimeField& field, const base::Run& run) const;

  private:
    explicit PointProduct(ProductBox box);
    bool suits(const PrimeField& field) const;
    double cost_of_images(std::size_t primes) const;

    ProductBox box_;
    ExponentSet::Census census_;
};

} // namespace eliminant::algebra
