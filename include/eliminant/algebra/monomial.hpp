#pragma once

#include "eliminant/algebra/ring.hpp"

#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace eliminant::algebra {

/// A power product of the variables of a ring: an owning value. Kernels work on packed words directly
/// (MonomialLayout); this type is their readable face.
///
/// Operations on monomials of different rings throw RingMismatchError, exponents from 2^63 on OverflowError.
class Monomial {
  public:
    /// The monomial 1.
    explicit Monomial(Ring ring);
    /// One exponent a variable; throws DomainError if their number is not that of the variables.
    Monomial(Ring ring, std::span<const std::uint64_t> exponents);
    /// Copies a packed monomial of one of the ring's layouts.
    Monomial(Ring ring, const MonomialLayout& layout, const MonomialLayout::Word* packed);

    const Ring& ring() const { return ring_; }
    std::uint64_t exponent(std::size_t variable) const { return layout_->exponent(words_.data(), variable); }
    std::vector<std::uint64_t> exponents() const;
    /// Sum of the exponents.
    std::uint64_t total_degree() const { return layout_->total_degree(words_.data()); }
    bool is_one() const { return layout_->is_one(words_.data()); }

    bool divides(const Monomial& other) const;
    friend Monomial operator*(const Monomial& a, const Monomial& b);
    /// Throws DomainError if b does not divide a.
    friend Monomial operator/(const Monomial& a, const Monomial& b);
    friend Monomial lcm(const Monomial& a, const Monomial& b);
    friend Monomial gcd(const Monomial& a, const Monomial& b);
    friend bool operator==(const Monomial& a, const Monomial& b);
    /// In the ring's order.
    friend std::strong_ordering operator<=>(const Monomial& a, const Monomial& b);

    /// `x^2*y`, or `1`.
    std::string to_string() const;

    const MonomialLayout& layout() const { return *layout_; }
    const MonomialLayout::Word* words() const { return words_.data(); }

  private:
    Ring ring_;
    const MonomialLayout* layout_; ///< narrowest that fits, so equal monomials have equal words
    std::vector<MonomialLayout::Word> words_;
};

} // namespace eliminant::algebra

namespace eliminant {
using algebra::Monomial;
} // namespace eliminant
