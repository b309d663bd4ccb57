#pragma once

#include "eliminant/algebra/integer.hpp"
#include "eliminant/base/error.hpp"

#include <cstdint>

namespace eliminant::algebra {

/// base^exponent; throws OverflowError where it would not fit in memory, since GMP ends the process there.
inline Integer checked_power(const Integer& base, std::uint64_t exponent) {
    constexpr std::uint64_t max_bits = std::uint64_t{1} << 37; // 16 GB
    const std::uint64_t bits = base.bit_length();
    if (bits <= 1) return exponent == 0 ? Integer(1) : exponent % 2 == 0 ? base * base : base; // 0, 1, −1
    if (exponent > max_bits / bits) throw OverflowError("a power of a number is too large to compute");
    return pow(base, exponent);
}

} // namespace eliminant::algebra
