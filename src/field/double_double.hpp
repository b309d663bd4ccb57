/// \file
/// Numbers of about 106 bits as unevaluated sums of two doubles.
#pragma once

#include <cmath>

namespace eliminant::field {

/// high + low with |low| at most half a unit in the last place of high.
///
/// Sums and products have relative errors below 3u² and 5u², u = 2^−53, where nothing over- or underflows
/// (Joldes, Muller, Popescu 2017, algorithms 6 and 12); an overflow gives an infinity or NaN.
struct DoubleDouble {
    double high = 0;
    double low = 0;

    DoubleDouble() = default;
    DoubleDouble(double value) : high(value) {} // NOLINT(google-explicit-constructor): a double is one
    DoubleDouble(double h, double l) : high(h), low(l) {}

    /// Relative error of each operation, with room to spare.
    static constexpr double unit = 0x1p-103;
};

/// a + b exactly, for |a| ≥ |b|.
inline DoubleDouble fast_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// a + b exactly.
inline DoubleDouble two_sum(double a, double b) {
    const double sum = a + b;
    const double b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble high = two_sum(a.high, b.high);
    const DoubleDouble low = two_sum(a.low, b.low);
    const DoubleDouble sum = fast_two_sum(high.high, high.low + low.high);
    return fast_two_sum(sum.high, low.low + sum.low);
}

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const double high = a.high * b.high;
    const double error = std::fma(a.high, b.high, -high);
    const double cross = std::fma(a.low, b.high, std::fma(a.high, b.low, a.low * b.low));
    return fast_two_sum(high, error + cross);
}

} // namespace eliminant::field
