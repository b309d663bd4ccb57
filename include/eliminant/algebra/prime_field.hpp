#pragma once

#include "eliminant/algebra/integer.hpp"

#include <cstdint>

namespace eliminant::algebra {

/// Whether n is prime; deterministic for every 64-bit n (Miller–Rabin with the first twelve prime bases,
/// sufficient below 3.3·10^24: Sorenson and Webster, Math. Comp. 86 (2017)). Microseconds.
bool is_prime(std::uint64_t n);

/// The largest prime below `bound`, which is at least 3.
std::uint64_t previous_prime(std::uint64_t bound);

/// Arithmetic of GF(p) for a prime p < 2^31, on residues in [0, p) held in 32 bits.
///
/// Products of two residues stay below 2^62, so a kernel may add four of them in an unsigned 64-bit word
/// before it reduces. reduce() is Barrett's method with a 64-bit reciprocal: one high multiplication and one
/// correction, 3–4 times faster than the division instruction.
class PrimeField {
  public:
    using Element = std::uint32_t;
    static constexpr std::uint64_t max_characteristic = (std::uint64_t{1} << 31) - 1;

    /// Throws DomainError if p is not a prime below 2^31.
    explicit PrimeField(std::uint64_t p);

    std::uint32_t characteristic() const { return p_; }

    /// Any 64-bit value modulo p.
    Element reduce(std::uint64_t x) const {
        // reciprocal = ⌊(2^64 − 1)/p⌋ gives a quotient at most one too small for every x < 2^64.
        const auto q = static_cast<std::uint64_t>((static_cast<base::UInt128>(x) * reciprocal_) >> 64);
        std::uint64_t r = x - q * p_;
        if (r >= p_) r -= p_;
        return static_cast<Element>(r >= p_ ? r - p_ : r);
    }
    Element from_integer(const Integer& value) const { return static_cast<Element>(value.residue(p_)); }
    /// Image of n/d; throws DomainError if p divides d.
    Element from_fraction(const Integer& n, const Integer& d) const;

    Element add(Element a, Element b) const {
        const std::uint32_t sum = a + b; // below 2^32
        return sum >= p_ ? sum - p_ : sum;
    }
    Element subtract(Element a, Element b) const { return a >= b ? a - b : a + (p_ - b); }
    Element negate(Element a) const { return a == 0 ? 0 : p_ - a; }
    Element multiply(Element a, Element b) const { return reduce(static_cast<std::uint64_t>(a) * b); }
    /// Inverse of a nonzero residue; throws DomainError for 0. Extended Euclid, about 100 ns.
    Element inverse(Element a) const;
    Element power(Element base, std::uint64_t exponent) const;

    friend bool operator==(const PrimeField& a, const PrimeField& b) { return a.p_ == b.p_; }

  private:
    std::uint32_t p_;
    std::uint64_t reciprocal_;
};

} // namespace eliminant::algebra

namespace eliminant {
using algebra::PrimeField;
} // namespace eliminant
