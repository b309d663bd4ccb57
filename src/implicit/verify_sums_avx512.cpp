#include "implicit/verify_sums.hpp"

// GCC 12 takes the deliberately undefined operand inside its own intrinsics for a mistake of ours.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif
#include <immintrin.h>

namespace eliminant::implicit {

void product_sums_avx512(std::uint64_t* sums, const std::uint32_t* powers, const std::uint32_t* exponents,
                         const std::uint32_t* values, std::size_t count) {
    const auto load = [](const std::uint32_t* from) {
        return _mm512_cvtepu32_epi64(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(from)));
    };
    __m512i sum = _mm512_loadu_si512(sums);
    for (std::size_t i = 0; i < count; ++i)
        sum = _mm512_add_epi64(
            sum, _mm512_mul_epu32(load(powers + std::size_t{8} * exponents[i]), load(values + 8 * i)));
    _mm512_storeu_si512(sums, sum);
}

} // namespace eliminant::implicit
