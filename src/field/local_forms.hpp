/// \file
/// The Taylor expansion of a polynomial at a point by the sizes of its homogeneous parts, and what follows
/// from it.
#pragma once

#include "eliminant/field/distance.hpp"

#include "field/eigenvalues.hpp"
#include "field/small_buffer.hpp"

#include <cmath>
#include <cstddef>

namespace eliminant::field {

/// f(p + q) = F_0 + F_1(q) + F_2(q) + … by the sizes of its parts. `errors[k]` bounds the sum of the absolute
/// errors of the coefficients of F_k: hence also the error of its norm, and of any value on the unit sphere.
template <class Real>
struct LocalForms {
    explicit LocalForms(int total_degree)
        : degree(total_degree), norms(static_cast<std::size_t>(total_degree) + 1),
          errors(static_cast<std::size_t>(total_degree) + 1) {}

    int degree;
    Real value = 0;
    Real gradient[3] = {0, 0, 0};
    Symmetric<Real> half_hessian = {0, 0, 0, 0, 0, 0};
    SmallBuffer<Real, 33> norms; ///< Bombieri's, from k = 3
    SmallBuffer<Real, 33> errors;

    std::size_t size() const { return static_cast<std::size_t>(degree) + 1; }
    Real error(std::size_t k) const { return k < size() ? errors[k] : Real(0); }
};

/// The length of the gradient.
template <class Real>
Real gradient_norm(const LocalForms<Real>& forms) {
    using std::sqrt;
    const Real* g = forms.gradient;
    return sqrt(Real(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]));
}

template <class Real>
Real frobenius_norm(const Symmetric<Real>& a) {
    using std::sqrt;
    return sqrt(
        Real(a.xx * a.xx + a.yy * a.yy + a.zz * a.zz + 2 * (a.xy * a.xy + a.xz * a.xz + a.yz * a.yz)));
}

/// An estimate of the distance, and how much of it may be due to `errors`, relatively.
template <class Real>
struct Estimate {
    Real value;
    Real uncertainty;
};

/// The root of |f| = g·ρ + m·ρ², as 2|f| / (g + √(g² + 4m|f|)), where m = 0 for the first order.
/// `norm` is the spectral norm, a function of Symmetric<Real>.
template <class Real, class Norm>
Estimate<Real> estimate(const LocalForms<Real>& forms, DistanceLevel level, const Norm& norm) {
    using std::abs;
    using std::sqrt;
    const Real size = abs(forms.value);
    const Real g = gradient_norm(forms);
    Real m = 0;
    if (level == DistanceLevel::second_order) m = norm(forms.half_hessian);
    if (level == DistanceLevel::second_order_frobenius) m = frobenius_norm(forms.half_hessian);
    const Real divisor = g + sqrt(Real(g * g + 4 * m * size));
    const Real rho = 2 * size / divisor;
    const Real second = level == DistanceLevel::first_order ? Real(0) : Real(forms.error(2) * rho);
    return {rho, forms.error(0) / size + 2 * (forms.error(1) + second) / divisor};
}

template <class Real>
Estimate<Real> estimate(const LocalForms<Real>& forms, DistanceLevel level) {
    return estimate(forms, level, [](const Symmetric<Real>& a) { return spectral_norm(a); });
}

/// The guaranteed bound, and how much of |f| the `errors` take up there, relatively. The bound is valid in
/// any case.
Estimate<double> guaranteed_bound(const LocalForms<double>& forms);

/// The coefficients of a polynomial with nonnegative coefficients at r + t, as a polynomial in t, times a
/// factor: what the errors of each order are bounded by.
template <class Real>
void shifted_majorant(const double* majorant, std::size_t size, const Real& r, const Real& factor,
                      Real* result) {
    for (std::size_t k = 0; k < size; ++k) result[k] = Real(majorant[k]);
    for (std::size_t done = 0; done + 1 < size; ++done)
        for (std::size_t k = size - 1; k > done; --k) result[k - 1] = result[k - 1] + r * result[k];
    for (std::size_t k = 0; k < size; ++k) result[k] = result[k] * factor;
}

} // namespace eliminant::field
