#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace eliminant::field {

/// An interval that holds a real number, by arithmetic that rounds outward (Moore, Kearfott and Cloud,
/// Introduction to Interval Analysis, 2009). Sound as long as nothing overflows, which callers see to.
struct Bounds {
    double lower = 0.0;
    double upper = 0.0;

    bool excludes_zero() const { return lower > 0.0 || upper < 0.0; }
    int sign() const { return lower > 0.0 ? 1 : upper < 0.0 ? -1 : 0; } ///< 0 if it is not known
    double middle() const { return 0.5 * lower + 0.5 * upper; }
    double width() const { return upper - lower; }
};

/// More than an operation to nearest may err: an ulp, or what underflow loses.
inline double rounding(double result) { return std::abs(result) * 0x1p-52 + 0x1p-1000; }
inline Bounds outward(double lower, double upper) {
    return {lower - rounding(lower), upper + rounding(upper)};
}

inline Bounds operator+(Bounds a, Bounds b) { return outward(a.lower + b.lower, a.upper + b.upper); }
inline Bounds operator-(Bounds a, Bounds b) { return outward(a.lower - b.upper, a.upper - b.lower); }
inline Bounds operator*(Bounds a, Bounds b) {
    const double ll = a.lower * b.lower;
    const double lu = a.lower * b.upper;
    const double ul = a.upper * b.lower;
    const double uu = a.upper * b.upper;
    return outward(std::min(std::min(ll, lu), std::min(ul, uu)),
                   std::max(std::max(ll, lu), std::max(ul, uu)));
}
/// b excludes zero.
inline Bounds operator/(Bounds a, Bounds b) { return a * outward(1.0 / b.upper, 1.0 / b.lower); }

/// Both must hold the same number.
inline Bounds intersection(Bounds a, Bounds b) {
    return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

/// x^exponent.
inline Bounds power(Bounds x, std::size_t exponent) {
    if (exponent == 0) return {1.0, 1.0};
    // By squaring, the result is within exponent − 1 roundings. Where a factor underflows so does the result.
    const double relative = static_cast<double>(exponent) * 0x1p-52;
    const auto raised = [exponent](double base) {
        double result = 1.0;
        for (std::size_t e = exponent;; base *= base) {
            if (e % 2 != 0) result *= base;
            e /= 2;
            if (e == 0) return result;
        }
    };
    const auto below = [&](double base) {
        const double p = raised(base);
        return std::max(p - (p * relative + 0x1p-1000), 0.0);
    };
    const auto above = [&](double base) {
        const double p = raised(base);
        return p + (p * relative + 0x1p-1000);
    };
    const bool is_even = exponent % 2 == 0;
    if (x.lower >= 0.0) return {below(x.lower), above(x.upper)};
    if (x.upper <= 0.0)
        return is_even ? Bounds{below(-x.upper), above(-x.lower)}
                       : Bounds{-above(-x.lower), -below(-x.upper)};
    return is_even ? Bounds{0.0, above(std::max(-x.lower, x.upper))}
                   : Bounds{-above(-x.lower), above(x.upper)};
}

} // namespace eliminant::field
