#pragma once

#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/run.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace eliminant::algebra {

/// GF(p^k) for small p: the evaluation points that GF(2) and GF(3) lack.
///
/// Elements are logarithms to a generator g, shifted so that 0 and 1 are themselves:
///
///     0 ↔ 0        i + 1 ↔ g^i  for 0 ≤ i < p^k − 1
///
/// A product is a sum modulo p^k − 1. A sum is a product too, g^i + g^j = g^i·(1 + g^(j−i)), with a table of
/// Zech's logarithms of 1 + g^i. The table costs 4 bytes an element and a few nanoseconds each to make.
class GaloisField {
  public:
    using Element = std::uint32_t;
    static constexpr std::uint64_t max_size = std::uint64_t{1} << 24;

    /// p^k is at most max_size.
    GaloisField(std::uint32_t p, unsigned k, base::Run& run);

    /// The least extension of GF(p) with at least `size` elements; nothing if that is above max_size.
    static std::optional<unsigned> degree_for(std::uint32_t p, std::uint64_t size);

    std::uint32_t size() const { return group_ + 1; }
    std::uint32_t characteristic() const { return static_cast<std::uint32_t>(embedded_.size()); }

    Element add(Element a, Element b) const {
        if (a == 0) return b;
        if (b == 0) return a;
        return times_power(successor_[b >= a ? b - a : b + group_ - a], a - 1);
    }
    Element negate(Element a) const { return times_power(a, log_minus_one_); }
    Element subtract(Element a, Element b) const { return add(a, negate(b)); }
    Element multiply(Element a, Element b) const { return b == 0 ? 0 : times_power(a, b - 1); }
    /// a is not 0.
    Element inverse(Element a) const { return a == 1 ? 1 : group_ + 2 - a; }
    Element power(Element base, std::uint64_t exponent) const {
        if (base == 0) return exponent == 0 ? 1 : 0;
        return static_cast<Element>((base - 1) * (exponent % group_) % group_) + 1;
    }

    /// The image of a residue in [0, p).
    Element embed(std::uint32_t residue) const { return embedded_[residue]; }
    /// The residue that an element is the image of, if it is.
    std::optional<std::uint32_t> residue(Element a) const;

  private:
    /// a·g^exponent, exponent < group_.
    Element times_power(Element a, std::uint32_t exponent) const {
        if (a == 0) return 0;
        const std::uint32_t sum = a + exponent; // at most 2·group_
        return sum > group_ ? sum - group_ : sum;
    }

    std::uint32_t group_;                 ///< p^k − 1, the order of g
    std::uint32_t log_minus_one_;         ///< g^log_minus_one_ = −1
    std::vector<Element> successor_;      ///< successor_[i] = 1 + g^i
    std::vector<Element> embedded_;       ///< images of 0 … p − 1
    std::vector<std::uint32_t> residues_; ///< the inverse: of the j-th power of a generator of GF(p)*
};

/// The image of a coefficient, an integer or a residue of the prime field.
inline std::uint32_t image_in(const PrimeField& field, const Integer& c) { return field.from_integer(c); }
inline std::uint32_t image_in(const PrimeField& /*field*/, std::uint32_t c) { return c; }
inline std::uint32_t image_in(const GaloisField& field, const Integer& c) {
    return field.embed(static_cast<std::uint32_t>(c.residue(field.characteristic())));
}
inline std::uint32_t image_in(const GaloisField& field, std::uint32_t c) { return field.embed(c); }

/// Number of elements, the same name for both kinds of field.
inline std::uint32_t field_size(const PrimeField& field) { return field.characteristic(); }
inline std::uint32_t field_size(const GaloisField& field) { return field.size(); }

} // namespace eliminant::algebra
