/// \file
/// The scheme that a CompiledPolynomial evaluates in floating point.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include "field/formula.hpp"
#include "field/nested_scheme.hpp"
#include "field/program_kernel.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace eliminant::field {

/// Expanded polynomials and the steps that combine them, with their coefficients and the bounds of their
/// rounding errors.
struct JetProgram {
    std::vector<NestedScheme> schemes; ///< of the leaves
    std::vector<ProgramLeaf> leaves;
    std::vector<JetStep> steps; ///< none for a single leaf
    std::array<double, 3> center{};

    // By the slots of the leaves, one after the other, and then the factors of `scale`.
    std::vector<double> coefficients;
    std::vector<double> magnitudes; ///< their absolute values
    std::vector<float> floats;

    /// majorant[j] ≥ Σ |c| over the terms of degree j that multiplication without cancellation would give:
    /// with r = max(|x|, |y|, |z|) from the center, the polynomial M of these coefficients bounds |f| by
    /// M(r), the sum of the absolute first derivatives by M'(r), that of all nine second ones by M''(r), term
    /// by term. Enlarged by 2^−900, see error_factor.
    std::vector<double> majorant;
    /// γₙ of the program with room for the rounding of the bounds themselves. Times 2^−900 · max(1, r)^degree
    /// it exceeds all that underflows.
    double error_factor = 0;
    /// How much the others may magnify the underflow of one part: 1 for a single leaf.
    double amplification = 1;
    std::size_t operations = 0;
    std::string description;

    ProgramView view() const;
    /// Farther from the center something may overflow that no part of the majorant shows.
    double safe_radius() const;
};

/// The expanded polynomial with coefficients times 2^−scale and, as floats, 2^−scale_float.
JetProgram expanded_program(const algebra::Polynomial& f, int scale, int scale_float, const base::Run& run);

/// The cheapest program for a formula in three variables: each part is kept as written or expanded, whichever
/// takes fewer operations. Nothing if all of it is to be expanded, or if its numbers might leave the range of
/// doubles or floats.
std::optional<JetProgram> structured_program(const Formula& formula, base::Run& run);

} // namespace eliminant::field
