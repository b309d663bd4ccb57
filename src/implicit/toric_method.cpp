#include "implicit/toric_method.hpp"

#include "eliminant/base/error.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace eliminant::implicit {

using algebra::Integer;
using algebra::Polynomial;

namespace {

using Row = std::vector<mpq_class>;

/// Brings a matrix to reduced echelon form. \returns the columns of its pivots, one for each of the first
/// rows
std::vector<std::size_t> reduce(std::vector<Row>& rows, std::size_t columns) {
    std::vector<std::size_t> pivots;
    for (std::size_t column = 0; column < columns && pivots.size() < rows.size(); ++column) {
        const std::size_t rank = pivots.size();
        std::size_t pivot = rank;
        while (pivot < rows.size() && rows[pivot][column] == 0) ++pivot;
        if (pivot == rows.size()) continue;
        std::swap(rows[pivot], rows[rank]);
        const mpq_class leading = rows[rank][column];
        for (mpq_class& entry : rows[rank]) entry /= leading;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const mpq_class factor = rows[i][column];
            if (i == rank || factor == 0) continue;
            for (std::size_t j = column; j < columns; ++j) rows[i][j] -= factor * rows[rank][j];
        }
        pivots.push_back(column);
    }
    return pivots;
}

/// The integers without common factor that are proportional to the entries.
std::vector<mpz_class> primitive(const Row& row) {
    mpz_class denominator = 1;
    for (const mpq_class& entry : row) denominator = lcm(denominator, entry.get_den());
    std::vector<mpz_class> result;
    mpz_class common = 0;
    for (const mpq_class& entry : row) {
        result.emplace_back(entry.get_num() * (denominator / entry.get_den()));
        common = gcd(common, result.back());
    }
    for (mpz_class& entry : result) entry /= common;
    return result;
}

/// The primitive u with Σ uᵢ·aᵢ = 0; nullopt if it is not unique up to its sign.
std::optional<std::vector<mpz_class>> only_relation(const TermMap& map) {
    const std::size_t n = map.exponents.size();
    std::vector<Row> rows(map.exponents.front().size(), Row(n));
    for (std::size_t v = 0; v < rows.size(); ++v)
        for (std::size_t i = 0; i < n; ++i) rows[v][i] = map.exponents[i][v];
    const std::vector<std::size_t> pivots = reduce(rows, n);
    if (pivots.size() + 1 != n) return std::nullopt;
    std::size_t free = 0;
    while (free < pivots.size() && pivots[free] == free) ++free;
    Row relation(n);
    relation[free] = 1;
    for (std::size_t i = 0; i < pivots.size(); ++i) relation[pivots[i]] = -rows[i][free];
    return primitive(relation);
}

std::uint64_t as_exponent(const mpz_class& value) {
    if (mpz_sizeinbase(value.get_mpz_t(), 2) > 63)
        throw base::OverflowError("the equation, a binomial, has the exponent " + value.get_str() +
                                  "; exponents up to 2^63 - 1 are possible");
    return value.get_ui();
}

/// Euclid's algorithm on the rows from `first` on: all but that one become 0 in the column. \returns its
/// entry
mpz_class reduce_column(std::vector<std::vector<mpz_class>>& rows, std::size_t first, std::size_t column) {
    for (std::size_t i = first + 1; i < rows.size(); ++i) {
        while (rows[i][column] != 0) {
            const mpz_class quotient = rows[first][column] / rows[i][column];
            for (std::size_t j = column; j < rows[i].size(); ++j) rows[first][j] -= quotient * rows[i][j];
            std::swap(rows[first], rows[i]);
        }
    }
    return abs(rows[first][column]);
}

} // namespace

std::optional<std::uint64_t> toric_degree(const TermMap& terms, const RationalMap& map) {
    if (map.parameters.empty()) return std::nullopt;
    std::vector<std::vector<mpz_class>> rows;
    for (std::size_t i = 0; i + map.constants.size() < terms.exponents.size(); ++i) {
        auto& row = rows.emplace_back();
        for (const std::size_t parameter : map.parameters) row.push_back(terms.exponents[i][parameter]);
    }
    mpz_class index = 1;
    for (std::size_t column = 0; column < map.parameters.size(); ++column)
        index *= column < rows.size() ? reduce_column(rows, column, column) : mpz_class(0);
    if (index == 0 || mpz_sizeinbase(index.get_mpz_t(), 2) > 64) return std::nullopt;
    return index.get_ui();
}

std::optional<Polynomial> toric_equation(const TermMap& map, const algebra::Ring& ring) {
    const auto u = only_relation(map);
    if (!u) return std::nullopt;
    std::vector<std::uint64_t> positive;
    std::vector<std::uint64_t> negative;
    for (const mpz_class& entry : *u) {
        positive.push_back(entry > 0 ? as_exponent(entry) : 0);
        negative.push_back(entry < 0 ? as_exponent(-entry) : 0);
    }
    const mpq_class value = product_of_powers(map.coefficients, *u);
    algebra::PolynomialBuilder builder(ring);
    builder.add(Integer(value.get_den()), positive);
    builder.add(Integer(mpz_class(-value.get_num())), negative);
    return builder.build().primitive_part();
}

} // namespace eliminant::implicit
