#pragma once

#include "univariate_mod_p.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// Exponent vectors as rows of equal length, strictly decreasing in lex.
struct ExponentRows {
    std::size_t variables = 0;
    std::vector<std::uint64_t> entries; ///< row after row
    std::size_t count = 0;

    std::span<const std::uint64_t> row(std::size_t i) const {
        return std::span(entries).subspan(i * variables, variables);
    }
    void push_back(std::span<const std::uint64_t> row) {
        entries.insert(entries.end(), row.begin(), row.end());
        ++count;
    }
};

/// The terms of a polynomial over a finite field.
struct SparseImage {
    ExponentRows exponents;
    dense::Vector coefficients;

    void push_back(std::span<const std::uint64_t> row, dense::Element coefficient) {
        exponents.push_back(row);
        coefficients.push_back(coefficient);
    }
};

/// Powers of one element; small ones from a table.
template <class Field>
class PowerTable {
  public:
    PowerTable(const Field& field, dense::Element base, std::uint64_t max_exponent);
    dense::Element operator()(std::uint64_t exponent) const {
        return exponent < table_.size() ? table_[exponent] : field_.power(base_, exponent);
    }

  private:
    const Field& field_;
    dense::Element base_;
    dense::Vector table_;
};

std::uint64_t largest_exponent(const ExponentRows& rows, std::size_t variable);

/// The value of each row's monomial, without its power of the first variable, where variable i has the value
/// point[i].
template <class Field>
dense::Vector monomial_values(const Field& field, const ExponentRows& rows, const dense::Vector& point);

} // namespace eliminant::algebra
