// The inner loop of dense elimination modulo a prime, for each vector unit.
#pragma once

#include "base/vector_unit.hpp"

#include <cstddef>
#include <cstdint>

namespace eliminant::implicit {

/// sums[j] += Σ factors[i]·rows[i][j] for 0 ≤ j < count and four rows; the caller knows that no sum
/// overflows.
using RowCombination = void (*)(std::uint64_t* sums, const std::uint32_t* const rows[4],
                                const std::uint32_t factors[4], std::size_t count);

/// Defined for each unit by row_combination_per_unit.cpp.
template <base::VectorUnit unit>
void combine_rows(std::uint64_t* sums, const std::uint32_t* const rows[4], const std::uint32_t factors[4],
                  std::size_t count);

inline RowCombination row_combination(base::VectorUnit unit) {
    return base::with_unit(unit, [](auto u) -> RowCombination { return combine_rows<u()>; });
}

} // namespace eliminant::implicit
