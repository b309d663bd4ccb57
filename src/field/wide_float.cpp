#include "field/wide_float.hpp"

#include <limits>

namespace eliminant::field {

Wide to_wide(const mpq_class& value) {
    if (sgn(value) == 0) return Wide(0);
    const auto exponent = static_cast<long>(mpz_sizeinbase(value.get_num_mpz_t(), 2)) -
                          static_cast<long>(mpz_sizeinbase(value.get_den_mpz_t(), 2));
    mpq_class rest = value; // brought near 1, then taken apart into doubles, the largest first
    if (exponent >= 0)
        mpq_div_2exp(rest.get_mpq_t(), rest.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
    else
        mpq_mul_2exp(rest.get_mpq_t(), rest.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
    Wide sum = 0;
    for (int part = 0; part < 6 && sgn(rest) != 0; ++part) {
        const double leading = rest.get_d();
        sum += leading;
        rest -= leading;
    }
    return ldexp(sum, static_cast<int>(exponent));
}

double to_double(const Wide& value) {
    constexpr double largest = std::numeric_limits<double>::max();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (value > largest) return infinity;
    if (value < -largest) return -infinity;
    return value.convert_to<double>();
}

} // namespace eliminant::field
