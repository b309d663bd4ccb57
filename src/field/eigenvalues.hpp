/// \file
/// Eigenvalues of symmetric 3 × 3 matrices in closed form, for any real type.
#pragma once

#include <cmath>

namespace eliminant::field {

/// The upper triangle.
template <class Real>
struct Symmetric {
    Real xx, xy, xz, yy, yz, zz;
};

template <class Real>
Symmetric<Real> operator*(const Real& factor, const Symmetric<Real>& a) {
    return {factor * a.xx, factor * a.xy, factor * a.xz, factor * a.yy, factor * a.yz, factor * a.zz};
}

template <class Real>
Real largest_entry(const Symmetric<Real>& a) {
    using std::abs;
    // Without branches: which entry is the largest cannot be predicted.
    const auto larger = [](const Real& x, const Real& y) { return x > y ? x : y; };
    Real result = 0;
    for (const Real* entry : {&a.xx, &a.xy, &a.xz, &a.yy, &a.yz, &a.zz})
        result = larger(Real(abs(*entry)), result);
    return result;
}

/// A = size·(q·1 + p·B) with tr B = 0 and ‖B‖² = 6, after which the eigenvalues of B are 2cos(φ + 2πi/3) for
/// 3φ = acos(det B/2) (Smith 1961).
template <class Real>
struct Deviator {
    Real size, q, p;
    Real half_det; ///< det B/2; of no meaning where p is 0
};

template <class Real>
Deviator<Real> deviator(const Symmetric<Real>& matrix) {
    using std::sqrt;
    Deviator<Real> result{largest_entry(matrix), 0, 0, 0};
    if (!(result.size > 0)) return result; // 0, or NaN
    const Symmetric<Real> a = Real(1 / result.size) * matrix;
    result.q = (a.xx + a.yy + a.zz) / 3;
    const Real x = a.xx - result.q;
    const Real y = a.yy - result.q;
    const Real z = a.zz - result.q;
    const Real off = a.xy * a.xy + a.xz * a.xz + a.yz * a.yz;
    result.p = sqrt(Real((x * x + y * y + z * z + 2 * off) / 6));
    const Real det =
        x * (y * z - a.yz * a.yz) - a.xy * (a.xy * z - a.yz * a.xz) + a.xz * (a.xy * a.yz - y * a.xz);
    result.half_det = det / (2 * result.p * result.p * result.p);
    return result;
}

/// A number that is not below the largest eigenvalue, rounding included, and above it by little more than
/// `slack` times the size of the matrix; `slack` is at least 64 units of rounding.
///
/// The eigenvalue rises with det B; so what rounding does to det B is made good by raising it: det A has an
/// error of a few units, which the division by p³ magnifies. Where the two largest eigenvalues nearly agree
/// that costs √slack.
template <class Real>
Real largest_eigenvalue_bound(const Symmetric<Real>& matrix, const Real& slack) {
    using std::acos;
    using std::cos;
    const Deviator<Real> a = deviator(matrix);
    if (!(a.size > 0)) return a.size;
    Real cosine = 1; // 2p bounds the difference from q in any case
    if (a.p > slack) {
        const Real raised = a.half_det + slack / (a.p * a.p * a.p);
        if (raised < 1) cosine = raised > -1 ? Real(cos(acos(raised) / 3)) : Real(0.5);
    }
    return a.size * (a.q + 2 * a.p * cosine + slack);
}

/// The largest absolute value of an eigenvalue; where eigenvalues nearly agree it has half the digits of
/// Real.
template <class Real>
Real spectral_norm(const Symmetric<Real>& matrix) {
    using std::abs;
    using std::acos;
    using std::cos;
    using std::sin;
    using std::sqrt;
    const Deviator<Real> a = deviator(matrix);
    if (!(a.size > 0)) return a.size;
    if (!(a.p > 0)) return a.size * abs(a.q);
    const Real clamped = a.half_det > 1 ? Real(1) : a.half_det < -1 ? Real(-1) : a.half_det;
    const Real angle = acos(clamped) / 3;
    const Real cosine = cos(angle);
    const Real largest = a.q + 2 * a.p * cosine;
    const Real smallest = a.q - a.p * (cosine + sqrt(Real(3)) * sin(angle));
    return a.size * (abs(largest) > abs(smallest) ? abs(largest) : abs(smallest));
}

/// cos(acos(c)/3) to 5e-14, without the library's slow inverse: a polynomial of degree 14 in cos(acos(c)/2) =
/// √((1 + c)/2), of which it is an analytic function, by interpolation at Chebyshev's points.
inline double cosine_of_third(double c) {
    constexpr double coefficients[] = {
        -1.6660756817891934e-09, 5.57368994407056e-09,   -1.256148502793046e-08, 4.322704582465098e-08,
        -1.6016856846336993e-07, 5.662279014472145e-07,  -2.035608400069633e-06, 7.540213446314012e-06,
        -2.8919991854676792e-05, 0.00011642563659140684, -0.0005041246859587917, 0.0024663527979788807,
        -0.015509188436625082,   0.24740906632331244,    0.766044443118978};
    const double t = 2 * std::sqrt(c > -1 ? 0.5 + 0.5 * c : 0.0) - 1;
    double sum = 0;
    for (const double coefficient : coefficients) sum = sum * t + coefficient;
    return sum;
}

/// spectral_norm() to 1e-12, for many matrices one after the other: a third of its time.
inline double fast_spectral_norm(const Symmetric<double>& matrix) {
    const Deviator<double> a = deviator(matrix);
    if (!(a.size > 0)) return a.size;
    if (!(a.p > 0)) return a.size * std::abs(a.q);
    const double clamped = a.half_det > 1 ? 1.0 : a.half_det < -1 ? -1.0 : a.half_det;
    const double largest = std::abs(a.q + 2 * a.p * cosine_of_third(clamped));
    const double smallest = std::abs(a.q - 2 * a.p * cosine_of_third(-clamped));
    return a.size * (largest > smallest ? largest : smallest);
}

} // namespace eliminant::field
