#pragma once

#include "double_double.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

/// Doubles as what they are: integers times powers of two.
namespace eliminant::field {

/// Exponent e such that every finite value is an integer times 2^e; the largest such e, 0 if all are 0.
inline long common_exponent(std::span<const double> values) {
    long least = std::numeric_limits<long>::max();
    for (const double value : values) {
        if (value == 0.0) continue;
        int exponent = 0;
        auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
        exponent -= 53;
        while (mantissa % 2 == 0) {
            mantissa /= 2;
            ++exponent;
        }
        least = std::min(least, static_cast<long>(exponent));
    }
    return least == std::numeric_limits<long>::max() ? 0 : least;
}

/// value / 2^exponent, which is an integer when `exponent` is common_exponent of values that include it.
inline mpz_class scaled_integer(double value, long exponent) {
    if (value == 0.0) return 0;
    int own = 0;
    const auto mantissa = static_cast<long>(std::ldexp(std::frexp(value, &own), 53));
    const long shift = own - 53 - exponent;
    mpz_class result = mantissa;
    if (shift >= 0)
        mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
    else
        mpz_tdiv_q_2exp(result.get_mpz_t(), result.get_mpz_t(), static_cast<mp_bitcnt_t>(-shift));
    return result;
}

/// value / 2^exponent to about 106 bits; below 2^-1000 in magnitude it may become 0.
inline DoubleDouble to_double_double(const mpz_class& value, long exponent) {
    const auto truncated = [exponent](const mpz_class& x) {
        long own = 0;
        const double mantissa = mpz_get_d_2exp(&own, x.get_mpz_t());
        return std::ldexp(mantissa, static_cast<int>(own - exponent));
    };
    const std::size_t bits = mpz_sizeinbase(value.get_mpz_t(), 2);
    mpz_class rest = 0; // what is below the 53 leading bits
    if (bits > 53) mpz_tdiv_r_2exp(rest.get_mpz_t(), value.get_mpz_t(), bits - 53);
    return fast_two_sum(truncated(value), rest == 0 ? 0.0 : truncated(rest));
}

} // namespace eliminant::field
