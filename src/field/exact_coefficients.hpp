/// \file
/// From rational coefficients to those of floating point.
#pragma once

#include "field/double_double.hpp"

#include <gmpxx.h>

namespace eliminant::field {

/// e with 2^(e−1) ≤ |q| < 2^(e+1).
inline long binary_exponent(const mpq_class& q) {
    return static_cast<long>(mpz_sizeinbase(q.get_num_mpz_t(), 2)) -
           static_cast<long>(mpz_sizeinbase(q.get_den_mpz_t(), 2));
}

inline mpq_class times_power_of_two(const mpq_class& q, long exponent) {
    mpq_class result;
    if (exponent >= 0)
        mpq_mul_2exp(result.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
    else
        mpq_div_2exp(result.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
    return result;
}

/// Within DoubleDouble::unit; its upper half is the nearest double, or one of two that are nearly so.
inline DoubleDouble to_double_double(const mpq_class& q) {
    const double high = q.get_d(); // truncated
    const double low = mpq_class(q - high).get_d();
    return fast_two_sum(high, low);
}

} // namespace eliminant::field
