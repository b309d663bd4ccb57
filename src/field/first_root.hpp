#pragma once

#include "double_double.hpp"

#include "base/vector_unit.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

/// The first root of polynomials on intervals in floating point, certified or given up.
///
/// Polynomials are in powers of x ∈ [−1, 1]. Rounding is accounted for by one number, a bound of the sum of
/// the absolute errors of the coefficients: it bounds the error of every value and of every Bernstein
/// coefficient on every part of [−1, 1] (a monomial's Bernstein coefficients there are at most 1 in
/// magnitude).
namespace eliminant::field {

/// Larger degrees are left to exact arithmetic. Up to here the integers of bernstein_matrix(), which are at
/// most binomial(n, n/2), and the sums that form them are below 2^53.
constexpr std::size_t max_kernel_degree = 56;

/// A root is undecided if its position is not certain to within this.
constexpr double root_precision = 1e-9;

/// Entry [i·(degree + 1) + j] is the coefficient of x^i in the Bernstein basis of [−1, 1] at B_j times
/// binomial(n, j), an integer. Row 0 are the binomials themselves.
const double* bernstein_matrix(std::size_t degree);

/// The roundings of finding a root, as a multiple of the sum of the absolute values of the coefficients over
/// the unit roundoff: synthetic division and scaling, change of basis; Horner's scheme.
inline double first_root_rounding(std::size_t degree) { return 5.0 * static_cast<double>(degree) + 10.0; }

/// What became of one ray.
enum class RayState : std::uint8_t {
    no_root,   ///< Certainly none.
    root,      ///< Certainly one, crossed by the sign, known to within root_precision.
    undecided, ///< This arithmetic does not tell.
};

struct FirstRootAnswer {
    RayState state = RayState::no_root;
    double root = 0.0;
    int side = 0; ///< sign at `lower`, 0 if not certain
    int steps = 0;
};

/// One polynomial. \param error bounds the sum of the errors of the coefficients as given
FirstRootAnswer first_root(std::span<const double> coefficients, double error, double lower, double upper);
/// The same in 106 bits.
FirstRootAnswer first_root(std::span<const DoubleDouble> coefficients, double error, double lower,
                           double upper);

/// Many polynomials of one degree: coefficient k of polynomial i at [k·count + i]. `count` is a multiple of
/// batch_padding.
struct FirstRootBatch {
    static constexpr std::size_t padding = 8;
    std::size_t degree = 0;
    std::size_t count = 0;
    const double* coefficients = nullptr;
    const double* bernstein = nullptr; ///< bernstein_matrix(degree)
    double error = 0.0;                ///< of any polynomial, first_root_rounding() included
    const double* lower = nullptr;
    const double* upper = nullptr;
    double* root = nullptr;
    RayState* state = nullptr;
};
/// Defined for each unit by beam_rows_per_unit.cpp.
template <base::VectorUnit unit>
void first_roots(const FirstRootBatch& batch);

using FirstRootSolver = void (*)(const FirstRootBatch&);
inline FirstRootSolver first_root_solver(base::VectorUnit unit) {
    return base::with_unit(unit, [](auto u) -> FirstRootSolver { return first_roots<u()>; });
}

} // namespace eliminant::field
