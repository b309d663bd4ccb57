// The Chinese remainder theorem for up to four primes.
#pragma once

#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/wide.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// x modulo the characteristic, for every x.
inline PrimeField::Element reduced(base::UInt128 x, const PrimeField& field) {
    std::uint64_t rest = field.reduce(static_cast<std::uint64_t>(x >> 64));
    rest = field.reduce(rest << 32 | (static_cast<std::uint64_t>(x) >> 32));
    return field.reduce(rest << 32 | (static_cast<std::uint64_t>(x) & 0xffffffffU));
}

/// Makes numbers of their residues modulo at most four primes below 2^31 by H. Garner's mixed radix (IRE
/// Trans. Electronic Computers 8, 1959).
class WordRemainders {
  public:
    static constexpr std::size_t max_primes = 4;

    explicit WordRemainders(std::span<const std::uint32_t> primes) {
        for (const std::uint32_t p : primes) {
            Digit digit{PrimeField(p), modulus_, 1};
            digit.inverse = digit.field.inverse(reduced(modulus_, digit.field));
            digits_.push_back(digit);
            modulus_ *= p;
        }
    }
    base::UInt128 modulus() const { return modulus_; }

    /// The number in [0, modulus()) with the residues residue(0), residue(1), …
    template <class Residue>
    base::UInt128 value(Residue&& residue) const {
        base::UInt128 x = residue(std::size_t{0});
        for (std::size_t i = 1; i < digits_.size(); ++i) {
            const Digit& digit = digits_[i];
            const PrimeField::Element gap = digit.field.subtract(residue(i), reduced(x, digit.field));
            x += digit.weight * digit.field.multiply(gap, digit.inverse);
        }
        return x;
    }

  private:
    struct Digit {
        PrimeField field;
        base::UInt128 weight; ///< product of the primes before
        PrimeField::Element inverse;
    };

    std::vector<Digit> digits_;
    base::UInt128 modulus_ = 1;
};

} // namespace eliminant::algebra
