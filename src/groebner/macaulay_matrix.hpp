#pragma once

#include "lane_kernels.hpp"

#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/run.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// A sparse matrix over GF(p) whose columns are monomials in decreasing order, in the shape that F4 meets:
///
///              pivot columns   others
///     pivots  [ 1 * * * *    |  * * ]     known: monic multiples of basis elements, one a pivot column, as
///             [   1 * * *    |  * * ]     they come
///     rows    [ * * * * *    |  * * ]     to be reduced by the pivots, then by one another
///
/// Columns are ascending. They belong to the caller, as do the coefficients, which all multiples of an
/// element share.
class MacaulayMatrix {
  public:
    using Element = std::uint32_t;
    using Column = std::uint32_t;

    MacaulayMatrix(const algebra::PrimeField& field, std::size_t columns)
        : field_(field), columns_(columns) {}

    /// Adds a row with one or more entries. A pivot is monic, and no two have the same leading column. What
    /// the row refers to must live as long as the matrix.
    void add_pivot(const SparseRow<Element>& row) { add(pivots_, row); }
    void add_row(const SparseRow<Element>& row) { add(rows_, row); }

    std::size_t row_count() const { return pivots_.size() + rows_.size(); }
    std::size_t column_count() const { return columns_; }
    std::size_t entry_count() const { return entries_; }

    struct Row {
        std::vector<Column> columns;
        std::vector<Element> coefficients;
    };
    /// What an elimination made use of: a second one that is given no more finds the same.
    struct Transcript {
        std::vector<bool> pivots;      ///< per column: whether the pivot given for it was subtracted
        std::vector<std::size_t> rows; ///< numbers of the rows that did not reduce to zero, as they came
        std::vector<Column> leads;     ///< the leading columns of what they became
        /// Asked for: whether the rows that reduced to zero, and the pivots that they needed, are written
        /// too.
        bool keeps_zero_rows = false;
        std::vector<std::size_t> zero_rows; ///< their numbers, if so
    };
    struct Echelon {
        std::vector<Row> rows;
        double failure_bound = 0; ///< probability that a row is missing is at most this
    };
    struct EchelonOptions {
        /// Where to write what was used; null for nowhere. Excludes `combine`.
        Transcript* transcript = nullptr;
        /// Reduce random combinations of rows instead of the rows wherever that seems to be less work, until
        /// some vanish. The field must be large enough (can_combine).
        bool combine = false;
        /// How many rows there are to be found, where that is known: the elimination ends with the last one.
        std::optional<std::size_t> rank = {};
        std::uint64_t seed = 0; ///< of the random combinations
        base::VectorUnit unit = base::best_vector_unit();
    };
    /// A basis of what the rows add to the span of the pivots: monic, ascending by leading column, no entry
    /// in a pivot column, neither of the given pivots nor of each other. It is unique, so it depends neither
    /// on the kernels nor on the threads. O(Σ length of the pivots used). Polls the run.
    Echelon echelon(const EchelonOptions& options, base::Run& run) const;

    /// Whether the field has enough elements for random combinations to prove something.
    static bool can_combine(const algebra::PrimeField& field) { return field.characteristic() >= 1U << 16U; }

  private:
    friend class Elimination;

    void add(std::vector<SparseRow<Element>>& rows, const SparseRow<Element>& row) {
        rows.push_back(row);
        entries_ += row.size;
    }

    algebra::PrimeField field_;
    std::size_t columns_;
    std::size_t entries_ = 0;
    std::vector<SparseRow<Element>> pivots_;
    std::vector<SparseRow<Element>> rows_;
};

} // namespace eliminant::groebner
