#include "lane_kernels.hpp"

#include <immintrin.h>

namespace eliminant::groebner {
namespace {

using Vector = __m512i;

inline Vector zero() { return _mm512_setzero_si512(); }
inline Vector load(const LaneSum& x) { return _mm512_load_si512(x.lane); }
inline void store(LaneSum& x, Vector v) { _mm512_store_si512(x.lane, v); }
inline Vector load(const LaneEntry& x) {
    return _mm512_cvtepu32_epi64(_mm256_load_si256(reinterpret_cast<const __m256i*>(x.lane)));
}
inline void store(LaneEntry& x, Vector v) {
    _mm256_store_si256(reinterpret_cast<__m256i*>(x.lane), _mm512_cvtepi64_epi32(v));
}
inline Vector load(const std::uint32_t& x) { return _mm512_set1_epi64(x); }
inline unsigned nonzero_lanes(Vector v) { return _mm512_test_epi64_mask(v, v); }
inline Vector subtract(Vector a, Vector b) { return _mm512_sub_epi64(a, b); }
inline Vector multiply_low_halves(Vector a, Vector b) { return _mm512_mul_epu32(a, b); }
inline Vector shift_down(Vector a, Vector bits) { return _mm512_srlv_epi64(a, bits); }
/// a < b ? a : a − b: the other difference wraps to something larger.
inline Vector subtract_if_not_less(Vector a, Vector b) { return _mm512_min_epu64(a, _mm512_sub_epi64(a, b)); }
/// a − b modulo m for a, b < m.
inline Vector subtract_modulo(Vector a, Vector b, Vector m) {
    const Vector difference = _mm512_sub_epi64(a, b);
    return _mm512_min_epu64(difference, _mm512_add_epi64(difference, m));
}

} // namespace
} // namespace eliminant::groebner

#include "lane_kernels_body.hpp"

namespace eliminant::groebner {
extern const LaneKernels lane_kernels_avx512;
const LaneKernels lane_kernels_avx512 = kernels;
} // namespace eliminant::groebner
