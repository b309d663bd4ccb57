/// \file
/// How long a falling polynomial stays positive.
#pragma once

#include <span>

namespace eliminant::field {

/// φ(ρ) = value − linear·ρ − quadratic·ρ² − Σ higher[i] ρ^(3+i), where value > 0, linear ≥ 0, higher[i] ≥ 0,
/// and `quadratic` has any sign.
struct FallingPolynomial {
    double value = 0;
    double linear = 0;
    double quadratic = 0;
    std::span<const double> higher;
};

/// A number ρ ≥ 0, rounding included, such that φ > 0 on [0, ρ], close to the largest with that property if
/// quadratic ≥ 0; else it may stop at the minimum of the quadratic part or go on from there by its value
/// alone. +∞ if φ is positive everywhere; 0 if a coefficient is infinite or NaN.
double positive_until(const FallingPolynomial& phi);

} // namespace eliminant::field
