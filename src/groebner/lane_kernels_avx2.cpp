#include "lane_kernels.hpp"

#include <immintrin.h>

namespace eliminant::groebner {
namespace {

struct Vector {
    __m256i low;
    __m256i high;
};

inline Vector zero() { return {_mm256_setzero_si256(), _mm256_setzero_si256()}; }
inline Vector load(const LaneSum& x) {
    const auto* halves = reinterpret_cast<const __m256i*>(x.lane);
    return {_mm256_load_si256(halves), _mm256_load_si256(halves + 1)};
}
inline void store(LaneSum& x, Vector v) {
    auto* halves = reinterpret_cast<__m256i*>(x.lane);
    _mm256_store_si256(halves, v.low);
    _mm256_store_si256(halves + 1, v.high);
}
inline Vector load(const LaneEntry& x) {
    const auto* halves = reinterpret_cast<const __m128i*>(x.lane);
    return {_mm256_cvtepu32_epi64(_mm_load_si128(halves)), _mm256_cvtepu32_epi64(_mm_load_si128(halves + 1))};
}
inline void store(LaneEntry& x, Vector v) {
    const __m256i even = _mm256_setr_epi32(0, 2, 4, 6, 0, 2, 4, 6);
    auto* halves = reinterpret_cast<__m128i*>(x.lane);
    _mm_store_si128(halves, _mm256_castsi256_si128(_mm256_permutevar8x32_epi32(v.low, even)));
    _mm_store_si128(halves + 1, _mm256_castsi256_si128(_mm256_permutevar8x32_epi32(v.high, even)));
}
inline bool is_zero(Vector v) {
    const __m256i any = _mm256_or_si256(v.low, v.high);
    return _mm256_testz_si256(any, any) != 0;
}
inline Vector add(Vector a, Vector b) {
    return {_mm256_add_epi64(a.low, b.low), _mm256_add_epi64(a.high, b.high)};
}
inline Vector multiply_low_halves(Vector a, Vector b) {
    return {_mm256_mul_epu32(a.low, b.low), _mm256_mul_epu32(a.high, b.high)};
}
inline Vector high_halves(Vector a) { return {_mm256_srli_epi64(a.low, 32), _mm256_srli_epi64(a.high, 32)}; }
/// a, or a + m where a is negative as a signed number.
inline __m256i add_if_negative(__m256i a, __m256i m) {
    const __m256i negative = _mm256_cmpgt_epi64(_mm256_setzero_si256(), a);
    return _mm256_add_epi64(a, _mm256_and_si256(negative, m));
}
/// a < b ? a : a − b for a < 2b < 2^63.
inline Vector subtract_if_not_less(Vector a, Vector b) {
    return {add_if_negative(_mm256_sub_epi64(a.low, b.low), b.low),
            add_if_negative(_mm256_sub_epi64(a.high, b.high), b.high)};
}
/// a − b modulo m for a, b < m < 2^63.
inline Vector subtract_modulo(Vector a, Vector b, Vector m) {
    return {add_if_negative(_mm256_sub_epi64(a.low, b.low), m.low),
            add_if_negative(_mm256_sub_epi64(a.high, b.high), m.high)};
}

} // namespace
} // namespace eliminant::groebner

#include "lane_kernels_body.hpp"

namespace eliminant::groebner {
extern const LaneKernels lane_kernels_avx2;
const LaneKernels lane_kernels_avx2 = kernels;
} // namespace eliminant::groebner
