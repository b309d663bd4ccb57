// Vectors of long integers modulo eight primes at a time.
#pragma once

#include "lane_kernels.hpp"

#include "eliminant/algebra/integer.hpp"
#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/run.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// Integers cut into digits of 30 bits, the form in which vector kernels reduce them modulo primes. It takes
/// little more memory than their bits.
class DigitVector {
  public:
    static constexpr unsigned digit_bits = 30;

    explicit DigitVector(std::span<const algebra::Integer> integers);

    std::size_t size() const { return lengths_.size(); }
    /// Bits of the largest absolute value.
    std::size_t bits() const { return bits_; }
    bool is_negative(std::size_t i) const { return negative_[i]; }
    /// Of each integer, how many digits its absolute value has.
    std::span<const std::uint32_t> lengths() const { return lengths_; }
    /// The digits of one integer after the other, the lowest first.
    std::span<const std::uint32_t> digits() const { return digits_; }

  private:
    std::vector<std::uint32_t> lengths_;
    std::vector<std::uint32_t> digits_;
    std::vector<bool> negative_;
    std::size_t bits_ = 0;
};

/// Eight primes above 2^30, and images of integers modulo all of them: an eighth of the time of a division
/// for each.
class PrimePack {
  public:
    explicit PrimePack(const LaneEntry& primes);

    const LanePrimes& lanes() const { return lanes_; }
    const algebra::PrimeField& field(std::size_t lane) const { return fields_[lane]; }

    /// The residues of the integers, in their sequence. Polls `run`.
    std::vector<LaneEntry> residues(const DigitVector& integers, base::Run& run);

    /// The inverses of nonzero residues; 0 in the lanes in which the residue is 0.
    LaneEntry inverse(const LaneEntry& c) const;

  private:
    LanePrimes lanes_;
    std::vector<algebra::PrimeField> fields_;
    std::vector<LaneEntry> powers_; ///< −2^(30·i), as far as needed
};

} // namespace eliminant::groebner
