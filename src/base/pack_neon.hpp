/// \file
/// Packs in the registers of 16 bytes of 64-bit Arm (pack.hpp).
#pragma once

#include "base/vector_unit.hpp"

#include <arm_neon.h>

#include <cstddef>
#include <cstdint>

namespace eliminant::base {
namespace {

inline constexpr VectorUnit this_unit = VectorUnit::neon;

/// A mask is all ones or all zeros in each lane.
struct Doubles {
    struct Mask {
        uint64x2_t bits;
        friend Mask operator&(Mask a, Mask b) { return {vandq_u64(a.bits, b.bits)}; }
        friend Mask operator|(Mask a, Mask b) { return {vorrq_u64(a.bits, b.bits)}; }
        friend Mask operator~(Mask a) {
            return {vreinterpretq_u64_u32(vmvnq_u32(vreinterpretq_u32_u64(a.bits)))};
        }
        friend bool any(Mask a) { return vmaxvq_u32(vreinterpretq_u32_u64(a.bits)) != 0; }
    };
    static constexpr std::size_t lanes = 2;
    float64x2_t v;

    static Doubles all(double x) { return {vdupq_n_f64(x)}; }
    static Doubles load(const double* p) { return {vld1q_f64(p)}; }
    static Mask nowhere() { return {vdupq_n_u64(0)}; }
    static bool test(Mask mask, std::size_t lane) { return mask.bits[lane] != 0; }
    static Mask opposite(Doubles a, Doubles b) {
        const uint64x2_t difference = veorq_u64(vreinterpretq_u64_f64(a.v), vreinterpretq_u64_f64(b.v));
        return {vcltzq_s64(vreinterpretq_s64_u64(difference))};
    }
    void store(double* p) const { vst1q_f64(p, v); }
    double lane(std::size_t i) const { return v[i]; }

    friend Doubles operator+(Doubles a, Doubles b) { return {vaddq_f64(a.v, b.v)}; }
    friend Doubles operator-(Doubles a, Doubles b) { return {vsubq_f64(a.v, b.v)}; }
    friend Doubles operator*(Doubles a, Doubles b) { return {vmulq_f64(a.v, b.v)}; }
    friend Doubles operator/(Doubles a, Doubles b) { return {vdivq_f64(a.v, b.v)}; }
    friend Mask operator>(Doubles a, Doubles b) { return {vcgtq_f64(a.v, b.v)}; }
    friend Mask operator==(Doubles a, Doubles b) { return {vceqq_f64(a.v, b.v)}; }
    friend Doubles fma(Doubles a, Doubles b, Doubles c) { return {vfmaq_f64(c.v, a.v, b.v)}; }
    friend Doubles fused(Doubles a, Doubles b, Doubles c) { return fma(a, b, c); }
    // Not vmaxq_f64 and vminq_f64, which return the number that is none.
    friend Doubles max(Doubles a, Doubles b) { return select(a > b, a, b); }
    friend Doubles min(Doubles a, Doubles b) { return select(b > a, a, b); }
    friend Doubles sqrt(Doubles a) { return {vsqrtq_f64(a.v)}; }
    friend Doubles abs(Doubles a) { return {vabsq_f64(a.v)}; }
    friend Doubles select(Mask mask, Doubles a, Doubles b) { return {vbslq_f64(mask.bits, a.v, b.v)}; }
};

struct Floats {
    static constexpr std::size_t lanes = 4;
    float32x4_t v;

    static Floats all(float x) { return {vdupq_n_f32(x)}; }
    static Floats load(const float* p) { return {vld1q_f32(p)}; }
    void store(float* p) const { vst1q_f32(p, v); }

    friend Floats operator+(Floats a, Floats b) { return {vaddq_f32(a.v, b.v)}; }
    friend Floats operator*(Floats a, Floats b) { return {vmulq_f32(a.v, b.v)}; }
    friend Floats fma(Floats a, Floats b, Floats c) { return {vfmaq_f32(c.v, a.v, b.v)}; }
};

/// One register of 32-bit lanes: its two ends are multiplied apart.
struct Halves {
    using Lane = std::uint32_t;
    static constexpr std::size_t lanes = 4;
    uint32x4_t v;

    static Halves all(std::uint32_t x) { return {vdupq_n_u32(x)}; }
    static Halves load(const std::uint32_t* p) { return {vld1q_u32(p)}; }
    void store(std::uint32_t* p) const { vst1q_u32(p, v); }

    friend Halves operator+(Halves a, Halves b) { return {vaddq_u32(a.v, b.v)}; }
    /// The other of the two differences wraps to something larger.
    friend Halves subtract_if_not_less(Halves a, Halves b) { return {vminq_u32(a.v, vsubq_u32(a.v, b.v))}; }
};

struct Words {
    using Lane = std::uint64_t;
    static constexpr std::size_t lanes = Halves::lanes;
    uint64x2_t low;
    uint64x2_t high;

    static Words all(std::uint64_t x) { return {vdupq_n_u64(x), vdupq_n_u64(x)}; }
    static Words load(const std::uint64_t* p) { return {vld1q_u64(p), vld1q_u64(p + 2)}; }
    void store(std::uint64_t* p) const {
        vst1q_u64(p, low);
        vst1q_u64(p + 2, high);
    }

    friend Words operator+(Words a, Words b) { return {vaddq_u64(a.low, b.low), vaddq_u64(a.high, b.high)}; }
    friend Words operator-(Words a, Words b) { return {vsubq_u64(a.low, b.low), vsubq_u64(a.high, b.high)}; }
    friend Words operator>>(Words a, Words bits) {
        return {shift_down(a.low, bits.low), shift_down(a.high, bits.high)};
    }
    friend Halves halves(Words a) { return {vmovn_high_u64(vmovn_u64(a.low), a.high)}; }
    friend Halves upper_halves(Words a) { return {vshrn_high_n_u64(vshrn_n_u64(a.low, 32), a.high, 32)}; }
    friend Words subtract_if_not_less(Words a, Words b) {
        return {subtract_if_not_less(a.low, b.low), subtract_if_not_less(a.high, b.high)};
    }
    friend Words subtract_modulo(Words a, Words b, Words m) {
        return {subtract_modulo(a.low, b.low, m.low), subtract_modulo(a.high, b.high, m.high)};
    }
    friend unsigned nonzero_lanes(Words a) {
        const uint64x2_t low_set = vtstq_u64(a.low, a.low);
        const uint64x2_t high_set = vtstq_u64(a.high, a.high);
        const uint32x4_t place = {1, 2, 4, 8};
        return vaddvq_u32(vandq_u32(vmovn_high_u64(vmovn_u64(low_set), high_set), place));
    }

  private:
    /// There is only a shift up, by numbers of either sign.
    static uint64x2_t shift_down(uint64x2_t a, uint64x2_t bits) {
        return vshlq_u64(a, vnegq_s64(vreinterpretq_s64_u64(bits)));
    }
    static uint64x2_t subtract_if_not_less(uint64x2_t a, uint64x2_t b) {
        return vsubq_u64(a, vandq_u64(vcgeq_u64(a, b), b));
    }
    static uint64x2_t subtract_modulo(uint64x2_t a, uint64x2_t b, uint64x2_t m) {
        return vaddq_u64(vsubq_u64(a, b), vandq_u64(vcgtq_u64(b, a), m));
    }
};

inline Words words(Halves a) { return {vmovl_u32(vget_low_u32(a.v)), vmovl_high_u32(a.v)}; }
inline Words operator*(Halves a, Halves b) {
    return {vmull_u32(vget_low_u32(a.v), vget_low_u32(b.v)), vmull_high_u32(a.v, b.v)};
}

} // namespace
} // namespace eliminant::base
