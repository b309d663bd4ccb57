/// \file
/// What a CompiledPolynomial holds.
#pragma once

#include "eliminant/algebra/polynomial.hpp"

#include "field/double_double.hpp"
#include "field/nested_scheme.hpp"

#include <gmpxx.h>

#include <memory>
#include <utility>
#include <vector>

namespace eliminant::field {

struct WideCoefficients; ///< of 256 bits; reliable_value.cpp

struct CompiledData {
    explicit CompiledData(algebra::Polynomial f) : exact(std::move(f)) {}

    algebra::Polynomial exact; ///< in a ring x, y, z
    int degree = -1;
    NestedScheme scheme;
    SchemeView view{}; ///< of `scheme`

    // By slot of the scheme, of f·2^−scale_exponent.
    int scale_exponent = 0;
    std::vector<double> coefficients;
    std::vector<double> magnitudes; ///< their absolute values
    std::vector<DoubleDouble> double_doubles;
    std::shared_ptr<const WideCoefficients> wide;
    int scale_exponent_float = 0;
    std::vector<float> floats;

    /// majorant[j] ≥ Σ |c| over the terms of degree j: with r = max(|x|, |y|, |z|), the polynomial M of these
    /// coefficients bounds |f| by M(r), the sum of the absolute first derivatives by M'(r), that of all nine
    /// second ones by M''(r), term by term. Enlarged by 2^−960, see error_factor.
    std::vector<double> majorant;
    /// γₙ of the scheme with room for the rounding of the bounds themselves. Times 2^−960 · max(1, r)^degree
    /// it exceeds all that underflows.
    double error_factor = 0;
};

std::shared_ptr<const WideCoefficients> make_wide_coefficients(const NestedScheme& scheme,
                                                               const std::vector<mpq_class>& terms);

/// Adds 2^−960 · max(1, r)^degree, the share of underflow, to a sum of absolute values.
double with_underflow(double sum, double r, int degree);

} // namespace eliminant::field
