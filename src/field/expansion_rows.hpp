/// \file
/// Taylor expansions at several points at once: what the guaranteed distance is made of.
#pragma once

#include "field/taylor_scheme.hpp"

#include "base/vector_unit.hpp"

#include <cstddef>
#include <cstdint>

namespace eliminant::field {

/// A TaylorScheme with coefficients as kernels see it, without containers.
struct ExpansionView {
    std::size_t degree;
    std::size_t size;   ///< entries
    int coordinates[3]; ///< which of x, y, z are u, v, w
    const double* entries;
    const TaylorScheme::Line* lines;
    const TaylorScheme::Line* lines_end;
    const TaylorScheme::Step* steps;
    const TaylorScheme::Step* steps_end;
    const std::uint32_t* low;                  ///< TaylorScheme::low
    const TaylorScheme::Component* components; ///< of the parts of order 3, 4, …, one after the other
    const std::uint32_t* component_ends;       ///< [k − 3]
    const double* majorant;                    ///< degree + 1, see CompiledData
    double error_factor;
};

/// What a kernel writes for each point: ten entries of order up to 2, the squares of the norms of the parts
/// of order k ≥ 3, the errors of order k ≥ 0.
struct ExpansionRows {
    static constexpr std::size_t low = 10;

    static std::size_t square(std::size_t k) { return low + k - 3; }
    static std::size_t error(std::size_t degree, std::size_t k) {
        return low + (degree < 3 ? 0 : degree - 2) + k;
    }
    static std::size_t count(std::size_t degree) { return error(degree, degree) + 1; }
};

/// Expands at `lanes` points.
struct Expander {
    /// \param points lanes numbers for each of x, y, z
    /// \param workspace (size + degree + 1) · lanes
    /// \param rows ExpansionRows::count(degree) rows of lanes
    void (*expand)(const ExpansionView& f, const double* const* points, double* workspace, double* rows);
    std::size_t lanes;
};
/// Defined for each unit by expansion_rows_per_unit.cpp.
template <base::VectorUnit unit>
Expander expander_of();

inline Expander expander(base::VectorUnit unit) {
    return base::with_unit(unit, [](auto u) { return expander_of<u()>(); });
}

} // namespace eliminant::field
