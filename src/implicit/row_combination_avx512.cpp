#include "implicit/row_combination.hpp"

// GCC 12 takes the deliberately undefined operand inside its own intrinsics for a mistake of ours.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif
#include <immintrin.h>

namespace eliminant::implicit {

void combine_rows_avx512(std::uint64_t* sums, const std::uint32_t* const rows[4],
                         const std::uint32_t factors[4], std::size_t count) {
    __m512i f[4];
    for (int i = 0; i < 4; ++i) f[i] = _mm512_set1_epi64(factors[i]);
    std::size_t j = 0;
    for (; j + 8 <= count; j += 8) {
        auto* target = reinterpret_cast<__m512i*>(sums + j);
        __m512i sum = _mm512_loadu_si512(target);
        for (int i = 0; i < 4; ++i) {
            const __m512i row =
                _mm512_cvtepu32_epi64(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(rows[i] + j)));
            sum = _mm512_add_epi64(sum, _mm512_mul_epu32(row, f[i]));
        }
        _mm512_storeu_si512(target, sum);
    }
    for (; j < count; ++j)
        for (int i = 0; i < 4; ++i) sums[j] += std::uint64_t{factors[i]} * rows[i][j];
}

} // namespace eliminant::implicit
