/// \file
/// What a CompiledPolynomial holds.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/field/evaluation_scheme.hpp"

#include "field/double_double.hpp"
#include "field/jet_program.hpp"
#include "field/nested_scheme.hpp"
#include "field/wide_float.hpp"

#include <gmpxx.h>

#include <utility>
#include <vector>

namespace eliminant::field {

/// Coefficients of 256 bits.
struct WideCoefficients {
    std::vector<Wide> values;
    std::vector<Wide> magnitudes;
};

struct CompiledData {
    explicit CompiledData(algebra::Polynomial f) : exact(std::move(f)) {}

    algebra::Polynomial exact; ///< in a ring x, y, z
    int degree = -1;
    NestedScheme scheme; ///< of the expanded polynomial, for more precise numbers than doubles
    SchemeView view{};   ///< of `scheme`

    // What doubles and floats evaluate.
    JetProgram program;
    ProgramView program_view{};
    std::vector<EvaluationScheme> schemes; ///< that of `program` first, then the others by expected cost

    // By slot of the scheme, of f·2^−scale_exponent.
    int scale_exponent = 0;
    std::vector<double> coefficients;
    std::vector<double> magnitudes; ///< their absolute values
    std::vector<DoubleDouble> double_doubles;
    WideCoefficients wide;
    int scale_exponent_float = 0;

    /// majorant[j] ≥ Σ |c| over the terms of degree j: with r = max(|x|, |y|, |z|), the polynomial M of these
    /// coefficients bounds |f| by M(r), the sum of the absolute first derivatives by M'(r), that of all nine
    /// second ones by M''(r), term by term. Enlarged by 2^−900, see error_factor.
    std::vector<double> majorant;
    /// γₙ of the scheme with room for the rounding of the bounds themselves. Times 2^−900 · max(1, r)^degree
    /// it exceeds all that underflows.
    double error_factor = 0;
};

/// Adds 2^−900 · max(1, r)^degree, the share of underflow, to a sum of absolute values.
double with_underflow(double sum, double r, int degree);

} // namespace eliminant::field
