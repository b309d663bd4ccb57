#pragma once

// GCC 12 takes its own _mm512_undefined_pd() for a mistake of ours (its bug 105593).
#if !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <immintrin.h>

#include <cstddef>

// To be included by one *_avx512.cpp only: hence the unnamed namespace.
namespace {

/// Eight doubles. A mask is one bit a lane.
struct Pack8 {
    struct Mask {
        __mmask8 bits;
        friend Mask operator&(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits & b.bits)}; }
        friend Mask operator|(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits | b.bits)}; }
        friend Mask operator~(Mask a) { return {static_cast<__mmask8>(~a.bits)}; }
        friend bool any(Mask a) { return a.bits != 0; }
    };
    static constexpr std::size_t lanes = 8;
    static constexpr int most_pieces = 48;
    static constexpr double shortest_piece = 0x1p-22;
    __m512d v;

    static Pack8 all(double x) { return {_mm512_set1_pd(x)}; }
    static Pack8 load(const double* p) { return {_mm512_loadu_pd(p)}; }
    static Mask nowhere() { return {0}; }
    static bool test(Mask mask, std::size_t lane) { return ((mask.bits >> lane) & 1) != 0; }
    static Mask opposite(Pack8 a, Pack8 b) {
        return {_mm512_movepi64_mask(_mm512_castpd_si512(_mm512_xor_pd(a.v, b.v)))};
    }
    void store(double* p) const { _mm512_storeu_pd(p, v); }
    double lane(std::size_t i) const { return v[i]; }

    friend Pack8 operator+(Pack8 a, Pack8 b) { return {_mm512_add_pd(a.v, b.v)}; }
    friend Pack8 operator-(Pack8 a, Pack8 b) { return {_mm512_sub_pd(a.v, b.v)}; }
    friend Pack8 operator*(Pack8 a, Pack8 b) { return {_mm512_mul_pd(a.v, b.v)}; }
    friend Pack8 operator/(Pack8 a, Pack8 b) { return {_mm512_div_pd(a.v, b.v)}; }
    friend Mask operator>(Pack8 a, Pack8 b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ)}; }
    friend Mask operator==(Pack8 a, Pack8 b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ)}; }
    friend Pack8 fma(Pack8 a, Pack8 b, Pack8 c) { return {_mm512_fmadd_pd(a.v, b.v, c.v)}; }
    friend Pack8 fused(Pack8 a, Pack8 b, Pack8 c) { return fma(a, b, c); }
    friend Pack8 max(Pack8 a, Pack8 b) { return {_mm512_max_pd(a.v, b.v)}; }
    friend Pack8 sqrt(Pack8 a) { return {_mm512_sqrt_pd(a.v)}; }
    friend Pack8 min(Pack8 a, Pack8 b) { return {_mm512_min_pd(a.v, b.v)}; }
    friend Pack8 abs(Pack8 a) { return {_mm512_abs_pd(a.v)}; }
    friend Pack8 select(Mask mask, Pack8 a, Pack8 b) { return {_mm512_mask_blend_pd(mask.bits, b.v, a.v)}; }
};

} // namespace
