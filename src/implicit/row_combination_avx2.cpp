#include "implicit/row_combination.hpp"

#include <immintrin.h>

namespace eliminant::implicit {

void combine_rows_avx2(std::uint64_t* sums, const std::uint32_t* const rows[4],
                       const std::uint32_t factors[4], std::size_t count) {
    __m256i f[4];
    for (int i = 0; i < 4; ++i) f[i] = _mm256_set1_epi64x(factors[i]);
    std::size_t j = 0;
    for (; j + 4 <= count; j += 4) {
        auto* target = reinterpret_cast<__m256i*>(sums + j);
        __m256i sum = _mm256_loadu_si256(target);
        for (int i = 0; i < 4; ++i) {
            const __m256i row =
                _mm256_cvtepu32_epi64(_mm_loadu_si128(reinterpret_cast<const __m128i*>(rows[i] + j)));
            sum = _mm256_add_epi64(sum, _mm256_mul_epu32(row, f[i]));
        }
        _mm256_storeu_si256(target, sum);
    }
    for (; j < count; ++j)
        for (int i = 0; i < 4; ++i) sums[j] += std::uint64_t{factors[i]} * rows[i][j];
}

} // namespace eliminant::implicit
