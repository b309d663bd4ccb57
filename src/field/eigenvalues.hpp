/// \file
/// Eigenvalues of symmetric 3 × 3 matrices in closed form, for any real type.
#pragma once

#include <algorithm>
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
    Real result = 0;
    for (const Real* entry : {&a.xx, &a.xy, &a.xz, &a.yy, &a.yz, &a.zz})
        if (abs(*entry) > result) result = abs(*entry);
    return result;
}

/// The largest eigenvalue, plus `slack` · (size of the matrix) or a little more. With slack ≥ 64 units of
/// rounding the result is not below the true value.
///
/// With A = q·1 + p·B, q = tr A/3, ‖B‖² = 6, the eigenvalues of B are 2cos((acos(det B/2) + 2πi)/3) (Smith
/// 1961). They are functions of det B, rising for the largest one; so what rounding does to det B, which is
/// of order 1, is made good by raising it. Where two eigenvalues nearly agree that costs √slack.
template <class Real>
Real largest_eigenvalue(const Symmetric<Real>& matrix, const Real& slack) {
    using std::acos;
    using std::cos;
    using std::sqrt;
    const Real size = largest_entry(matrix);
    if (!(size > 0)) return size; // 0, or NaN
    const Symmetric<Real> a = Real(1 / size) * matrix;
    const Real q = (a.xx + a.yy + a.zz) / 3;
    const Real x = a.xx - q;
    const Real y = a.yy - q;
    const Real z = a.zz - q;
    const Real off = a.xy * a.xy + a.xz * a.xz + a.yz * a.yz;
    const Real p = sqrt((x * x + y * y + z * z + 2 * off) / 6);
    Real cosine = 1; // for p near 0 too: 2p then bounds the difference from q
    if (p > slack) {
        const Real det =
            x * (y * z - a.yz * a.yz) - a.xy * (a.xy * z - a.yz * a.xz) + a.xz * (a.xy * a.yz - y * a.xz);
        // det is of order p·1·1 with an absolute error of a few units, which the division by p³ magnifies.
        const Real ratio = det / (2 * p * p * p) + slack / (p * p * p);
        if (ratio < 1) cosine = ratio > -1 ? Real(cos(acos(ratio) / 3)) : Real(0.5);
    }
    return size * (q + 2 * p * cosine + slack);
}

/// The largest absolute value of an eigenvalue, in the same way.
template <class Real>
Real spectral_norm(const Symmetric<Real>& a, const Real& slack) {
    const Real high = largest_eigenvalue(a, slack);
    const Real low = largest_eigenvalue(Real(-1) * a, slack);
    return high > low ? high : low;
}

} // namespace eliminant::field
