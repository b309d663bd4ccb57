#pragma once

#include "first_root.hpp"

#include "base/vector_unit.hpp"

#include <cstddef>
#include <cstdint>

namespace eliminant::field {

/// One row of rays of a beam: v is fixed, u varies. Lanes are padded to a multiple of `padding`; a lane whose
/// lower > upper has no root.
struct BeamRow {
    static constexpr std::size_t padding = 8;
    /// Entries in each of the two tables of the largest degree.
    static constexpr std::size_t most_coefficients = (max_kernel_degree + 1) * (max_kernel_degree + 1);

    // The polynomial: the coefficient of u^a·w^k at [k·(degree + 1) + a], and its derivative by v.
    std::size_t degree = 0;
    const double* coefficients = nullptr;
    const double* v_derivative = nullptr;
    const double* bernstein = nullptr; ///< bernstein_matrix(degree)
    double error = 0.0;                ///< as in first_root(), beam_row_rounding() included

    // The rays: u, and the interval of w, within [−1, 1].
    std::size_t count = 0;
    const double* u = nullptr;
    const double* lower = nullptr;
    const double* upper = nullptr;

    // The answers.
    RayState* state = nullptr;
    double* root = nullptr;
    double* du = nullptr; ///< partial derivatives at the root
    double* dv = nullptr;
    double* dw = nullptr;
    std::int8_t* side = nullptr; ///< sign of the value at `lower`, 0 if not certain
    std::uint8_t* steps = nullptr;
};

/// All roundings from the coefficients of the beam on, as a multiple of the sum of their absolute values:
/// Horner's schemes in v and u, and the search.
inline double beam_row_rounding(std::size_t degree) {
    return (4.0 * static_cast<double>(degree) + first_root_rounding(degree)) * 0x1p-53;
}

/// The first root of each ray of the row; defined for each unit by beam_rows_per_unit.cpp.
template <base::VectorUnit unit>
void solve_beam_row(const BeamRow& row);

using BeamRowSolver = void (*)(const BeamRow& row);
inline BeamRowSolver beam_row_solver(base::VectorUnit unit) {
    return base::with_unit(unit, [](auto u) -> BeamRowSolver { return solve_beam_row<u()>; });
}

} // namespace eliminant::field
