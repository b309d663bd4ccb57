/// \file
/// Packs in registers of 32 bytes (pack.hpp).
#pragma once

#include "base/vector_unit.hpp"

#include <immintrin.h>

#include <cstddef>
#include <cstdint>

namespace eliminant::base {
namespace {

inline constexpr VectorUnit this_unit = VectorUnit::avx2;

/// A mask is the sign bits of four.
struct Doubles {
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
    __m256d v;

    static Doubles all(double x) { return {_mm256_set1_pd(x)}; }
    static Doubles load(const double* p) { return {_mm256_loadu_pd(p)}; }
    static Mask nowhere() { return {_mm256_setzero_pd()}; }
    static bool test(Mask mask, std::size_t lane) {
        return ((_mm256_movemask_pd(mask.bits) >> lane) & 1) != 0;
    }
    static Mask opposite(Doubles a, Doubles b) { return {_mm256_xor_pd(a.v, b.v)}; }
    void store(double* p) const { _mm256_storeu_pd(p, v); }
    double lane(std::size_t i) const { return v[i]; }

    friend Doubles operator+(Doubles a, Doubles b) { return {_mm256_add_pd(a.v, b.v)}; }
    friend Doubles operator-(Doubles a, Doubles b) { return {_mm256_sub_pd(a.v, b.v)}; }
    friend Doubles operator*(Doubles a, Doubles b) { return {_mm256_mul_pd(a.v, b.v)}; }
    friend Doubles operator/(Doubles a, Doubles b) { return {_mm256_div_pd(a.v, b.v)}; }
    friend Mask operator>(Doubles a, Doubles b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_GT_OQ)}; }
    friend Mask operator==(Doubles a, Doubles b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_EQ_OQ)}; }
    friend Doubles fma(Doubles a, Doubles b, Doubles c) { return {_mm256_fmadd_pd(a.v, b.v, c.v)}; }
    friend Doubles fused(Doubles a, Doubles b, Doubles c) { return fma(a, b, c); }
    friend Doubles max(Doubles a, Doubles b) { return {_mm256_max_pd(a.v, b.v)}; }
    friend Doubles min(Doubles a, Doubles b) { return {_mm256_min_pd(a.v, b.v)}; }
    friend Doubles sqrt(Doubles a) { return {_mm256_sqrt_pd(a.v)}; }
    friend Doubles abs(Doubles a) { return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v)}; }
    friend Doubles select(Mask mask, Doubles a, Doubles b) { return {_mm256_blendv_pd(b.v, a.v, mask.bits)}; }
};

struct Floats {
    static constexpr std::size_t lanes = 8;
    __m256 v;

    static Floats all(float x) { return {_mm256_set1_ps(x)}; }
    static Floats load(const float* p) { return {_mm256_loadu_ps(p)}; }
    void store(float* p) const { _mm256_storeu_ps(p, v); }

    friend Floats operator+(Floats a, Floats b) { return {_mm256_add_ps(a.v, b.v)}; }
    friend Floats operator*(Floats a, Floats b) { return {_mm256_mul_ps(a.v, b.v)}; }
    friend Floats fma(Floats a, Floats b, Floats c) { return {_mm256_fmadd_ps(a.v, b.v, c.v)}; }
};

/// In the low half of each word, as multiplication wants them; the high halves may hold anything.
struct Halves {
    using Lane = std::uint32_t;
    static constexpr std::size_t lanes = 4;
    __m256i v;

    static Halves all(std::uint32_t x) { return {_mm256_set1_epi64x(x)}; }
    static Halves load(const std::uint32_t* p) {
        return {_mm256_cvtepu32_epi64(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p)))};
    }
    void store(std::uint32_t* p) const {
        const __m256i even = _mm256_setr_epi32(0, 2, 4, 6, 0, 2, 4, 6);
        _mm_storeu_si128(reinterpret_cast<__m128i*>(p),
                         _mm256_castsi256_si128(_mm256_permutevar8x32_epi32(v, even)));
    }

    friend Halves operator+(Halves a, Halves b) { return {_mm256_add_epi32(a.v, b.v)}; }
    /// The other of the two differences wraps to something larger.
    friend Halves subtract_if_not_less(Halves a, Halves b) {
        return {_mm256_min_epu32(a.v, _mm256_sub_epi32(a.v, b.v))};
    }
};

struct Words {
    using Lane = std::uint64_t;
    static constexpr std::size_t lanes = Halves::lanes;
    __m256i v;

    static Words all(std::uint64_t x) { return {_mm256_set1_epi64x(static_cast<long long>(x))}; }
    static Words load(const std::uint64_t* p) {
        return {_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p))};
    }
    void store(std::uint64_t* p) const { _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), v); }

    friend Words operator+(Words a, Words b) { return {_mm256_add_epi64(a.v, b.v)}; }
    friend Words operator-(Words a, Words b) { return {_mm256_sub_epi64(a.v, b.v)}; }
    friend Words operator>>(Words a, Words bits) { return {_mm256_srlv_epi64(a.v, bits.v)}; }
    friend Halves halves(Words a) { return {a.v}; }
    friend Halves upper_halves(Words a) { return {_mm256_srli_epi64(a.v, 32)}; }
    /// a, or a + m where a is negative as a signed number.
    friend Words add_if_negative(Words a, Words m) {
        const __m256i negative = _mm256_cmpgt_epi64(_mm256_setzero_si256(), a.v);
        return {_mm256_add_epi64(a.v, _mm256_and_si256(negative, m.v))};
    }
    friend Words subtract_if_not_less(Words a, Words b) { return add_if_negative(a - b, b); }
    friend Words subtract_modulo(Words a, Words b, Words m) { return add_if_negative(a - b, m); }
    friend unsigned nonzero_lanes(Words a) {
        const __m256i is_zero = _mm256_cmpeq_epi64(a.v, _mm256_setzero_si256());
        return static_cast<unsigned>(_mm256_movemask_pd(_mm256_castsi256_pd(is_zero))) ^ 15U;
    }
};

inline Words words(Halves a) { return {_mm256_and_si256(a.v, _mm256_set1_epi64x(0xffffffff))}; }
inline Words operator*(Halves a, Halves b) { return {_mm256_mul_epu32(a.v, b.v)}; }

} // namespace
} // namespace eliminant::base
