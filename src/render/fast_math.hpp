/// \file
/// Elementary functions in float that compilers turn into vector code: no calls, no tables, and no branches
/// where floating-point traps do not matter (-fno-trapping-math).
#pragma once

#include <bit>
#include <cstdint>

namespace eliminant::render {

/// log₂ x for normal positive x, to 2e-7.
inline float fast_log2(float x) {
    // x = 2^e · m with m in [√½, √2), and log m = 2 artanh((m − 1) / (m + 1)); the next term of the series is
    // below 0.172^9 / 9 = 1.5e-8.
    constexpr std::uint32_t sqrt_half = 0x3f3504f3;
    const std::uint32_t shifted = std::bit_cast<std::uint32_t>(x) - sqrt_half;
    const auto exponent = static_cast<float>(static_cast<std::int32_t>(shifted) >> 23);
    const auto m = std::bit_cast<float>((shifted & 0x007fffffU) + sqrt_half);
    const float y = (m - 1) / (m + 1);
    const float y2 = y * y;
    constexpr float two_over_ln2 = 2.88539008F;
    return exponent + two_over_ln2 * y * (1 + y2 * (1.0F / 3 + y2 * (1.0F / 5 + y2 * (1.0F / 7))));
}

/// 2^max(x, −126) for x ≤ 0, to 3e-7 relative.
inline float fast_exp2(float x) {
    const float clamped = x > -126 ? x : -126;
    const auto whole = static_cast<std::int32_t>(clamped - 0.5F); // rounds to nearest, as x ≤ 0
    const float f = (clamped - static_cast<float>(whole)) * 0.69314718F;
    const float series =
        1 + f * (1 + f * (1.0F / 2 + f * (1.0F / 6 + f * (1.0F / 24 + f * (1.0F / 120 + f * (1.0F / 720))))));
    const auto power = std::bit_cast<float>(static_cast<std::uint32_t>(whole + 127) << 23);
    return power * series;
}

/// x^s, or 1e-38 if that is more, for x in [0, 1] and s ≥ 0; 0^0 = 1 as for std::pow.
inline float fast_power(float x, float s) {
    constexpr float least = 1e-30F;
    return fast_exp2(s * fast_log2(x > least ? x : least));
}

} // namespace eliminant::render
