/// \file
/// How a polynomial is evaluated, and why so.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace eliminant::field {

/// The forms in which value, gradient and Hessian of a polynomial can be computed.
enum class SchemeKind : std::uint8_t {
    horner,     ///< expanded, nested in the coordinates or common powers of them, in the best sequence
    taylor,     ///< the same in the coordinates from the center of a box
    structured, ///< sums, products and powers of smaller expanded polynomials, as written or as factored
};

/// `horner`, `taylor`, `structured`.
std::string_view to_string(SchemeKind kind);

/// A scheme that was considered, and what it was judged by.
struct EvaluationScheme {
    SchemeKind kind = SchemeKind::horner;
    /// Multiplications with an addition that value, gradient and Hessian take together.
    double operations = 0;
    /// Mean of min(1, error bound / |value|) over 64 points of the box, or of [−1, 1]³ without one: about the
    /// share of points whose sign doubles leave open.
    double uncertainty = 0;
    /// As `Horner in z^2, y, x` or `(Horner in x, y, z)^3`.
    std::string description = {};

    /// What a certain sign is expected to cost: an uncertain one is computed again in two doubles, which is
    /// taken to be 30 times as long.
    double expected_cost() const { return operations * (1 + 30 * uncertainty); }
};

} // namespace eliminant::field

namespace eliminant {
using field::EvaluationScheme;
using field::SchemeKind;
} // namespace eliminant
