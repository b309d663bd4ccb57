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
inline Vector load(const std::uint32_t& x) {
    const __m256i all = _mm256_set1_epi64x(x);
    return {all, all};
}
inline unsigned nonzero_lanes(__m256i v) {
    const __m256i is_zero = _mm256_cmpeq_epi64(v, _mm256_setzero_si256());
    return static_cast<unsigned>(_mm256_movemask_pd(_mm256_castsi256_pd(is_zero))) ^ 15U;
}
inline unsigned nonzero_lanes(Vector v) { return nonzero_lanes(v.low) | nonzero_lanes(v.high) << 4U; }
inline Vector subtract(Vector a, Vector b) {
    return {_mm256_sub_epi64(a.low, b.low), _mm256_sub_epi64(a.high, b.high)};
}
inline Vector multiply_low_halves(Vector a, Vector b) {
    return {_mm256_mul_epu32(a.low, b.low), _mm256_mul_epu32(a.high, b.high)};
}
inline Vector shift_down(Vector a, Vector bits) {
    return {_mm256_srlv_epi64(a.low, bits.low), _mm256_srlv_epi64(a.high, bits.high)};
}
/// a, or a + m where a is negative as a signed number.
inline __m256i add_if_negative(__m256i a, __m256i m) {
    const __m256i negative = _mm256_cmpgt_epi64(_mm256_setzero_si256(), a);
    return _mm256_add_epi64(a, _mm256_and_si256(negative, m));
}
/// a < b ? a : a − b for a, b < 2^63.
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
