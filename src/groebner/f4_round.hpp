#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eliminant::groebner {

/// What one matrix of F4 did, as plain data: enough to do the same to other coefficients, and no more. Rows
/// that reduced to zero, pivots that were not subtracted and columns that neither touches are left out.
///
/// A row is a multiple of an *operand*: the generators come first, then the elements as they were found. Its
/// coefficients are the operand's, its columns are here:
///
///     columns_of_rows   | columns of pivots[0] | … | columns of rows[0] | … |      ascending in each row
///     support           | columns of found element 0 | of element 1 | … |          ascending in each
struct F4Round {
    struct Row {
        std::uint32_t operand;
        std::size_t begin; ///< in columns_of_rows
    };

    std::size_t column_count = 0;
    std::vector<Row> pivots; ///< monic; no two have the same leading column
    std::vector<Row> rows;   ///< in the sequence in which they were reduced
    std::vector<std::uint32_t> columns_of_rows;
    std::vector<std::uint32_t> leads; ///< per row: the leading column of what it became
    /// Rows that reduced to zero, their columns behind the others', if they were asked for: there are the
    /// pivots that they needed as well then.
    std::vector<Row> zero_rows;
    bool keeps_zero_rows = false;
    /// Of the element found i: support[found[i]], …, support[found[i + 1] − 1], the leading column first.
    std::vector<std::size_t> found = {0};
    std::vector<std::uint32_t> support;

    std::size_t found_count() const { return found.size() - 1; }
};

} // namespace eliminant::groebner
