// The first linear dependence between the columns of a matrix that is made row by row.
#pragma once

#include "eliminant/algebra/prime_field.hpp"
#include "implicit/row_combination.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::implicit {

/// Rows over GF(p) in echelon form, row r beginning with a 1 in column r:
///
///     1 * * * * *
///     0 1 * * * *        three rows; the columns behind the last pivot are
///     0 0 1 * * *        those of which not all dependences are excluded yet
///
/// Rows are added until one reduces to zero in the next pivot's column: the columns up to that one are then
/// dependent, if rows are general. p is below 2^29, so that products are added up in 64 bits sixty times
/// between two reductions.
class Echelon {
  public:
    using Element = algebra::PrimeField::Element;
    static constexpr std::uint64_t prime_bound = std::uint64_t{1} << 29;

    Echelon(const algebra::PrimeField& field, std::size_t columns);

    std::size_t columns() const { return columns_; }
    std::size_t rank() const { return rank_; }

    /// Reduces a row. \returns whether it made the next pivot; if not, its entry in column rank() is zero
    /// after reduction, and it is forgotten.
    bool add(std::span<const Element> row);

    /// The vector v of length rank() + 1, last entry 1, with Σ v[j]·(column j) = 0 in all rows added.
    /// O(rank²).
    std::vector<Element> dependence() const;

  private:
    const Element* row(std::size_t i) const { return &rows_[i * columns_]; }

    algebra::PrimeField field_;
    std::size_t columns_;
    std::size_t rank_ = 0;
    std::vector<Element> rows_;
    std::vector<std::uint64_t> sums_;
    RowCombination combine_;
};

} // namespace eliminant::implicit
