#include "implicit/verify_sums.hpp"

#include <immintrin.h>

namespace eliminant::implicit {

void product_sums_avx2(std::uint64_t* sums, const std::uint32_t* powers, const std::uint32_t* exponents,
                       const std::uint32_t* values, std::size_t count) {
    const auto load = [](const std::uint32_t* from) {
        return _mm256_cvtepu32_epi64(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from)));
    };
    auto* low = reinterpret_cast<__m256i*>(sums);
    auto* high = reinterpret_cast<__m256i*>(sums + 4);
    __m256i first = _mm256_loadu_si256(low);
    __m256i second = _mm256_loadu_si256(high);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t* power = powers + std::size_t{8} * exponents[i];
        const std::uint32_t* value = values + 8 * i;
        first = _mm256_add_epi64(first, _mm256_mul_epu32(load(power), load(value)));
        second = _mm256_add_epi64(second, _mm256_mul_epu32(load(power + 4), load(value + 4)));
    }
    _mm256_storeu_si256(low, first);
    _mm256_storeu_si256(high, second);
}

} // namespace eliminant::implicit
