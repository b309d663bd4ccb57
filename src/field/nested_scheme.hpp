/// \file
/// How a polynomial in three variables is laid out for Horner's scheme.
#pragma once

#include "field/nested_horner.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::field {

using Exponents = std::array<std::uint32_t, 3>;

/// A polynomial as a polynomial in u, whose coefficients are polynomials in v, whose coefficients are
/// polynomials in w, for one sequence u, v, w of the coordinates; each level by Horner's scheme:
///
///     rows     u^I … u^1 u^0      a row is a polynomial in v and w
///     lines    v^J … v^1 v^0      a line is a polynomial in w
///     slots    w^K … w^1 w^0      places of coefficients, contiguous in a line, 0 where there is no term
///
/// What comes before the first w in a row, and before the first v or w at all, are runs of constants, which
/// are summed like a line. Rows and lines are dense: a gap costs less than the branch that would skip it.
/// Where all exponents of a coordinate are multiples of g > 1, the letter stands for its power x^g, so that
/// an even polynomial has half the levels.
struct NestedScheme {
    using Line = SchemeLine;
    using Row = SchemeRow;

    std::array<std::uint8_t, 3> coordinates = {0, 1, 2}; ///< which of x, y, z are u, v, w
    std::array<std::uint32_t, 3> powers = {1, 1, 1};     ///< g for u, v, w
    std::vector<Row> rows;                               ///< by descending powers of u
    std::vector<Line> lines;                             ///< of each row by descending powers of v
    std::uint32_t constants = 0;                         ///< rows without v and w that come first
    std::vector<std::uint32_t> slots;                    ///< of each term
    std::size_t size = 0;                                ///< number of slots

    SchemeView view() const;
    /// Multiplications and additions of one evaluation of value, gradient and Hessian, in pairs.
    std::size_t cost() const;
    /// Roundings, at most, between a coefficient and any of value, gradient and Hessian, including the two of
    /// a coefficient that was truncated to the working precision.
    std::size_t roundings() const;
};

/// The scheme of least cost among the six sequences of coordinates. Polls nothing: O(size).
///
/// \throws OverflowError if it would have more than 2^24 slots, lines or rows
NestedScheme make_nested_scheme(std::span<const Exponents> terms);

} // namespace eliminant::field
