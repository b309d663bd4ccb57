#pragma once

#include <immintrin.h>

#include <cstddef>

// To be included by one *_avx2.cpp only: hence the unnamed namespace.
namespace {

/// Four doubles. A mask is the sign bits of four.
struct Pack4 {
    struct Mask {
        __m256d bits;
        friend Mask operator&(Mask a, Mask b) { return {_mm256_and_pd(a.bits, b.bits)}; }
        friend Mask operator|(Mask a, Mask b) { return {_mm256_or_pd(a.bits, b.bits)}; }
        friend Mask operator~(Mask a) {
            return {_mm256_xor_pd(a.bits, _mm256_castsi256_pd(_mm256_set1_epi64x(-1)))};
        }
        friend bool any(Mask a) { return _mm256_movemask_pd(a.bits) != 0; }
    };
    static constexpr std::size_t lanes = 4;
    static constexpr int most_pieces = 48;
    static constexpr double shortest_piece = 0x1p-22;
    __m256d v;

    static Pack4 all(double x) { return {_mm256_set1_pd(x)}; }
    static Pack4 load(const double* p) { return {_mm256_loadu_pd(p)}; }
    static Mask nowhere() { return {_mm256_setzero_pd()}; }
    static bool test(Mask mask, std::size_t lane) {
        return ((_mm256_movemask_pd(mask.bits) >> lane) & 1) != 0;
    }
    static Mask opposite(Pack4 a, Pack4 b) { return {_mm256_xor_pd(a.v, b.v)}; }
    void store(double* p) const { _mm256_storeu_pd(p, v); }
    double lane(std::size_t i) const { return v[i]; }

    friend Pack4 operator+(Pack4 a, Pack4 b) { return {_mm256_add_pd(a.v, b.v)}; }
    friend Pack4 operator-(Pack4 a, Pack4 b) { return {_mm256_sub_pd(a.v, b.v)}; }
    friend Pack4 operator*(Pack4 a, Pack4 b) { return {_mm256_mul_pd(a.v, b.v)}; }
    friend Pack4 operator/(Pack4 a, Pack4 b) { return {_mm256_div_pd(a.v, b.v)}; }
    friend Mask operator>(Pack4 a, Pack4 b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_GT_OQ)}; }
    friend Mask operator==(Pack4 a, Pack4 b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_EQ_OQ)}; }
    friend Pack4 fma(Pack4 a, Pack4 b, Pack4 c) { return {_mm256_fmadd_pd(a.v, b.v, c.v)}; }
    friend Pack4 fused(Pack4 a, Pack4 b, Pack4 c) { return fma(a, b, c); }
    friend Pack4 max(Pack4 a, Pack4 b) { return {_mm256_max_pd(a.v, b.v)}; }
    friend Pack4 sqrt(Pack4 a) { return {_mm256_sqrt_pd(a.v)}; }
    friend Pack4 min(Pack4 a, Pack4 b) { return {_mm256_min_pd(a.v, b.v)}; }
    friend Pack4 abs(Pack4 a) { return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v)}; }
    friend Pack4 select(Mask mask, Pack4 a, Pack4 b) { return {_mm256_blendv_pd(b.v, a.v, mask.bits)}; }
};

} // namespace
