/// \file
/// Packs in registers of 64 bytes (pack.hpp).
#pragma once

#include "base/vector_unit.hpp"

#include <immintrin.h>

#include <cstddef>
#include <cstdint>

namespace eliminant::base {
namespace {

inline constexpr VectorUnit this_unit = VectorUnit::avx512;

/// A mask is one bit a lane.
struct Doubles {
    struct Mask {
        __mmask8 bits;
        friend Mask operator&(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits & b.bits)}; }
        friend Mask operator|(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits | b.bits)}; }
        friend Mask operator~(Mask a) { return {static_cast<__mmask8>(~a.bits)}; }
        friend bool any(Mask a) { return a.bits != 0; }
    };
    static constexpr std::size_t lanes = 8;
    __m512d v;

    static Doubles all(double x) { return {_mm512_set1_pd(x)}; }
    static Doubles load(const double* p) { return {_mm512_loadu_pd(p)}; }
    static Mask nowhere() { return {0}; }
    static bool test(Mask mask, std::size_t lane) { return ((mask.bits >> lane) & 1) != 0; }
    static Mask opposite(Doubles a, Doubles b) {
        return {_mm512_movepi64_mask(_mm512_castpd_si512(_mm512_xor_pd(a.v, b.v)))};
    }
    void store(double* p) const { _mm512_storeu_pd(p, v); }
    double lane(std::size_t i) const { return v[i]; }

    friend Doubles operator+(Doubles a, Doubles b) { return {_mm512_add_pd(a.v, b.v)}; }
    friend Doubles operator-(Doubles a, Doubles b) { return {_mm512_sub_pd(a.v, b.v)}; }
    friend Doubles operator*(Doubles a, Doubles b) { return {_mm512_mul_pd(a.v, b.v)}; }
    friend Doubles operator/(Doubles a, Doubles b) { return {_mm512_div_pd(a.v, b.v)}; }
    friend Mask operator>(Doubles a, Doubles b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_GT_OQ)}; }
    friend Mask operator==(Doubles a, Doubles b) { return {_mm512_cmp_pd_mask(a.v, b.v, _CMP_EQ_OQ)}; }
    friend Doubles fma(Doubles a, Doubles b, Doubles c) { return {_mm512_fmadd_pd(a.v, b.v, c.v)}; }
    friend Doubles fused(Doubles a, Doubles b, Doubles c) { return fma(a, b, c); }
    friend Doubles max(Doubles a, Doubles b) { return {_mm512_max_pd(a.v, b.v)}; }
    friend Doubles min(Doubles a, Doubles b) { return {_mm512_min_pd(a.v, b.v)}; }
    friend Doubles sqrt(Doubles a) { return {_mm512_sqrt_pd(a.v)}; }
    friend Doubles abs(Doubles a) { return {_mm512_abs_pd(a.v)}; }
    friend Doubles select(Mask mask, Doubles a, Doubles b) {
        return {_mm512_mask_blend_pd(mask.bits, b.v, a.v)};
    }
};

struct Floats {
    static constexpr std::size_t lanes = 16;
    __m512 v;

    static Floats all(float x) { return {_mm512_set1_ps(x)}; }
    static Floats load(const float* p) { return {_mm512_loadu_ps(p)}; }
    void store(float* p) const { _mm512_storeu_ps(p, v); }

    friend Floats operator+(Floats a, Floats b) { return {_mm512_add_ps(a.v, b.v)}; }
    friend Floats operator*(Floats a, Floats b) { return {_mm512_mul_ps(a.v, b.v)}; }
    friend Floats fma(Floats a, Floats b, Floats c) { return {_mm512_fmadd_ps(a.v, b.v, c.v)}; }
};

/// In the low half of each word, as multiplication wants them; the high halves may hold anything.
struct Halves {
    using Lane = std::uint32_t;
    static constexpr std::size_t lanes = 8;
    __m512i v;

    static Halves all(std::uint32_t x) { return {_mm512_set1_epi64(x)}; }
    static Halves load(const std::uint32_t* p) {
        return {_mm512_cvtepu32_epi64(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p)))};
    }
    void store(std::uint32_t* p) const {
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), _mm512_cvtepi64_epi32(v));
    }

    friend Halves operator+(Halves a, Halves b) { return {_mm512_add_epi32(a.v, b.v)}; }
    /// The other of the two differences wraps to something larger.
    friend Halves subtract_if_not_less(Halves a, Halves b) {
        return {_mm512_min_epu32(a.v, _mm512_sub_epi32(a.v, b.v))};
    }
};

struct Words {
    using Lane = std::uint64_t;
    static constexpr std::size_t lanes = Halves::lanes;
    __m512i v;

    static Words all(std::uint64_t x) { return {_mm512_set1_epi64(static_cast<long long>(x))}; }
    static Words load(const std::uint64_t* p) { return {_mm512_loadu_si512(p)}; }
    void store(std::uint64_t* p) const { _mm512_storeu_si512(p, v); }

    friend Words operator+(Words a, Words b) { return {_mm512_add_epi64(a.v, b.v)}; }
    friend Words operator-(Words a, Words b) { return {_mm512_sub_epi64(a.v, b.v)}; }
    friend Words operator>>(Words a, Words bits) { return {_mm512_srlv_epi64(a.v, bits.v)}; }
    friend Halves halves(Words a) { return {a.v}; }
    friend Halves upper_halves(Words a) { return {_mm512_srli_epi64(a.v, 32)}; }
    /// The other of the two differences wraps to something larger; so it does below.
    friend Words subtract_if_not_less(Words a, Words b) { return {_mm512_min_epu64(a.v, (a - b).v)}; }
    friend Words subtract_modulo(Words a, Words b, Words m) {
        const Words difference = a - b;
        return {_mm512_min_epu64(difference.v, (difference + m).v)};
    }
    friend unsigned nonzero_lanes(Words a) { return _mm512_test_epi64_mask(a.v, a.v); }
};

inline Words words(Halves a) { return {_mm512_and_si512(a.v, _mm512_set1_epi64(0xffffffff))}; }
inline Words operator*(Halves a, Halves b) { return {_mm512_mul_epu32(a.v, b.v)}; }

} // namespace
} // namespace eliminant::base
