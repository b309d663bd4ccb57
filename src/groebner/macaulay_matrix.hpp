#pragma once

#include "lane_kernels.hpp"

#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/run.hpp"

#include <cstddef>
#include <cstdint>
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
/// Coefficients belong to the caller and are shared by all multiples of an element; columns are ascending.
class MacaulayMatrix {
  public:
    using Element = std::uint32_t;
    using Column = std::uint32_t;

    MacaulayMatrix(const algebra::PrimeField& field, std::size_t columns)
        : field_(field), columns_(columns) {}

    /// Tells how many entries there will be, which saves memory.
    void reserve(std::size_t entries) { pool_.reserve(entries); }
    /// Room for the columns of a row with the coefficients given (one or more), to be filled in before
    /// echelon(). A pivot is monic, and no two have the same leading column. The room is valid until the next
    /// row is added.
    std::span<Column> add_pivot(std::span<const Element> coefficients);
    std::span<Column> add_row(std::span<const Element> coefficients);

    std::size_t row_count() const { return pivots_.size() + rows_.size(); }
    std::size_t column_count() const { return columns_; }
    std::size_t entry_count() const { return pool_.size(); }

    struct Row {
        std::vector<Column> columns;
        std::vector<Element> coefficients;
    };
    /// What an elimination made use of: a second one that is given no more finds the same.
    struct Transcript {
        std::vector<bool> pivots;      ///< per column: whether the pivot given for it was subtracted
        std::vector<std::size_t> rows; ///< numbers of the rows that did not reduce to zero, as they came
        std::vector<Column> leads;     ///< the leading columns of what they became
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

    struct Reference { ///< to columns in pool_
        std::size_t begin;
        std::span<const Element> coefficients;
    };
    std::span<Column> add(std::vector<Reference>& rows, std::span<const Element> coefficients);
    SparseRow<Element> row(const Reference& reference) const {
        return {pool_.data() + reference.begin, reference.coefficients.data(), reference.coefficients.size()};
    }

    algebra::PrimeField field_;
    std::size_t columns_;
    std::vector<Column> pool_;
    std::vector<Reference> pivots_;
    std::vector<Reference> rows_;
};

} // namespace eliminant::groebner
