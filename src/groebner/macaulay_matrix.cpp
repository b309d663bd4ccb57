#include "macaulay_matrix.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::groebner {

MacaulayMatrix::MacaulayMatrix(const algebra::PrimeField& field, std::size_t columns)
    : field_(field), square_(static_cast<std::uint64_t>(field.characteristic()) * field.characteristic()),
      columns_(columns) {}

std::span<MacaulayMatrix::Column> MacaulayMatrix::add(std::vector<Reference>& rows,
                                                      std::span<const Element> coefficients) {
    rows.push_back({pool_.size(), coefficients});
    pool_.resize(pool_.size() + coefficients.size());
    return std::span(pool_).last(coefficients.size());
}

std::span<MacaulayMatrix::Column> MacaulayMatrix::add_pivot(std::span<const Element> coefficients) {
    return add(pivots_, coefficients);
}

std::span<MacaulayMatrix::Column> MacaulayMatrix::add_row(std::span<const Element> coefficients) {
    return add(rows_, coefficients);
}

void MacaulayMatrix::scatter(std::span<const Column> columns, std::span<const Element> coefficients) {
    for (std::size_t i = 0; i < columns.size(); ++i) dense_[columns[i]] = coefficients[i];
}

MacaulayMatrix::Row MacaulayMatrix::reduce(std::size_t first) {
    Row result;
    used_.clear();
    for (std::size_t column = first; column < columns_; ++column) {
        if (dense_[column] == 0) continue;
        const Element value = field_.reduce(dense_[column]);
        dense_[column] = 0;
        if (value == 0) continue;
        const Pivot& pivot = by_column_[column];
        if (pivot.columns == nullptr) {
            result.columns.push_back(static_cast<Column>(column));
            result.coefficients.push_back(value);
            continue;
        }
        used_.push_back(static_cast<Column>(column));
        const std::uint64_t q = field_.negate(value);
        std::uint64_t* dense = dense_.data();
        for (std::size_t i = 1; i < pivot.size;
             ++i) { // products and entries are below p², so sums below 2^63
            const std::uint64_t sum = dense[pivot.columns[i]] + q * pivot.coefficients[i];
            dense[pivot.columns[i]] = sum >= square_ ? sum - square_ : sum;
        }
    }
    if (!result.coefficients.empty() && result.coefficients.front() != 1) {
        const Element inverse = field_.inverse(result.coefficients.front());
        for (Element& c : result.coefficients) c = field_.multiply(c, inverse);
    }
    return result;
}

std::vector<MacaulayMatrix::Row> MacaulayMatrix::echelon(base::Run& run, Transcript* transcript) {
    by_column_.assign(columns_, {});
    dense_.assign(columns_, 0);
    if (transcript) transcript->pivots.assign(columns_, false);
    for (const Reference& row : pivots_) {
        const Column* columns = pool_.data() + row.begin;
        by_column_[columns[0]] = {columns, row.coefficients.data(), row.coefficients.size()};
    }
    std::vector<Row> found;
    found.reserve(rows_.size()); // pivots point into it
    const auto become_pivot = [this](const Row& row) {
        by_column_[row.columns.front()] = {row.columns.data(), row.coefficients.data(), row.columns.size()};
    };
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Reference& row = rows_[i];
        run.poll();
        const std::span<const Column> columns(pool_.data() + row.begin, row.coefficients.size());
        scatter(columns, row.coefficients);
        Row reduced = reduce(columns.front());
        if (reduced.columns.empty()) continue;
        if (transcript) {
            for (const Column column : used_) transcript->pivots[column] = true;
            transcript->rows.push_back(i);
            transcript->leads.push_back(reduced.columns.front());
        }
        found.push_back(std::move(reduced));
        become_pivot(found.back());
    }
    // From the last leading column on, so that what a row is reduced by is reduced already.
    std::ranges::sort(found, {}, [](const Row& row) { return row.columns.front(); });
    for (std::size_t i = found.size(); i-- > 0;) {
        run.poll();
        Row& row = found[i];
        by_column_[row.columns.front()] = {};
        scatter(row.columns, row.coefficients);
        row = reduce(row.columns.front());
        become_pivot(row);
    }
    return found;
}

} // namespace eliminant::groebner
