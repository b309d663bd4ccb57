#include "eliminant/algebra/monomial_order.hpp"

#include "eliminant/base/error.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <utility>

namespace eliminant::algebra {

namespace {

using Key = MonomialOrder::Key;

/// Weights are summed in packed fields, so a single one may not come near the width of a word.
constexpr std::uint64_t max_weight = std::uint64_t{1} << 31;

Key unit_key(std::size_t variable_count, std::size_t index, bool reversed) {
    Key key{std::vector<std::uint64_t>(variable_count, 0), reversed};
    key.weights[index] = 1;
    return key;
}

/// Degree of the listed variables, then reverse lex among them. The first variable's exponent is what
/// remains.
void append_degrevlex(std::vector<Key>& keys, std::size_t variable_count,
                      std::span<const std::size_t> block) {
    Key degree{std::vector<std::uint64_t>(variable_count, 0), false};
    for (const std::size_t index : block) degree.weights[index] = 1;
    keys.push_back(std::move(degree));
    for (std::size_t i = block.size(); i-- > 1;) keys.push_back(unit_key(variable_count, block[i], true));
}

void append_lex(std::vector<Key>& keys, std::size_t variable_count) {
    for (std::size_t i = 0; i < variable_count; ++i) keys.push_back(unit_key(variable_count, i, false));
}

std::vector<std::size_t> indices_below(std::size_t count) {
    std::vector<std::size_t> result(count);
    for (std::size_t i = 0; i < count; ++i) result[i] = i;
    return result;
}

/// Rank over ℚ by fraction-free elimination.
std::size_t rank_of(const std::vector<std::vector<std::int64_t>>& rows) {
    std::vector<std::vector<mpz_class>> a;
    for (const auto& row : rows) {
        auto& copy = a.emplace_back();
        for (const std::int64_t entry : row) copy.emplace_back(static_cast<long>(entry));
    }
    std::size_t rank = 0;
    const std::size_t columns = a.empty() ? 0 : a.front().size();
    for (std::size_t column = 0; column < columns && rank < a.size(); ++column) {
        std::size_t pivot = rank;
        while (pivot < a.size() && a[pivot][column] == 0) ++pivot;
        if (pivot == a.size()) continue;
        std::swap(a[pivot], a[rank]);
        for (std::size_t i = rank + 1; i < a.size(); ++i) {
            const mpz_class factor = a[i][column];
            for (std::size_t j = column; j < columns; ++j)
                a[i][j] = a[i][j] * a[rank][column] - factor * a[rank][j];
        }
        ++rank;
    }
    return rank;
}

std::vector<Key> matrix_keys(const std::vector<std::vector<std::int64_t>>& rows, std::size_t variable_count) {
    std::vector<Key> keys;
    std::vector<mpz_class> column_sums(variable_count, 0); // of the non-negative rows made so far
    for (const auto& row : rows) {
        mpz_class multiple = 0;
        for (std::size_t j = 0; j < variable_count; ++j) {
            if (row[j] >= 0) continue;
            mpz_class needed;
            const mpz_class deficit = -mpz_class(static_cast<long>(row[j]));
            mpz_cdiv_q(needed.get_mpz_t(), deficit.get_mpz_t(), column_sums[j].get_mpz_t());
            multiple = std::max(multiple, needed);
        }
        Key key;
        for (std::size_t j = 0; j < variable_count; ++j) {
            const mpz_class entry = static_cast<long>(row[j]) + multiple * column_sums[j];
            if (entry > max_weight)
                throw DomainError("the order matrix needs an entry of " + entry.get_str() +
                                  " once its rows are made non-negative; the limit is 2^31");
            key.weights.push_back(entry.get_ui());
        }
        for (std::size_t j = 0; j < variable_count; ++j)
            column_sums[j] += static_cast<unsigned long>(key.weights[j]);
        keys.push_back(std::move(key));
    }
    return keys;
}

} // namespace

MonomialOrder MonomialOrder::lex() { return MonomialOrder(Kind::lex); }
MonomialOrder MonomialOrder::deglex() { return MonomialOrder(Kind::deglex); }
MonomialOrder MonomialOrder::degrevlex() { return MonomialOrder(Kind::degrevlex); }

MonomialOrder MonomialOrder::weighted(std::vector<std::uint64_t> weights, TieBreak tie_break) {
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (weights[i] > max_weight)
            throw DomainError("weight " + std::to_string(i + 1) + " of the order exceeds 2^31");
        if (weights[i] == 0 && tie_break == TieBreak::revlex)
            throw DomainError(
                "weight " + std::to_string(i + 1) +
                " of the order is 0: with the tie-break revlex 1 would be larger than that variable, "
                "so the order is not admissible");
    }
    MonomialOrder order(Kind::weighted);
    order.weights_ = std::move(weights);
    order.tie_break_ = tie_break;
    return order;
}

MonomialOrder MonomialOrder::elimination(std::vector<std::size_t> eliminated) {
    return blocks({std::move(eliminated)});
}

MonomialOrder MonomialOrder::blocks(std::vector<std::vector<std::size_t>> blocks) {
    std::vector<std::size_t> all;
    for (const auto& block : blocks) all.insert(all.end(), block.begin(), block.end());
    std::ranges::sort(all);
    if (std::ranges::adjacent_find(all) != all.end())
        throw DomainError("a variable occurs twice in the blocks of the order");
    std::erase_if(blocks, [](const auto& block) { return block.empty(); });
    MonomialOrder order(Kind::elimination);
    order.blocks_ = std::move(blocks);
    return order;
}

MonomialOrder MonomialOrder::matrix(std::vector<std::vector<std::int64_t>> rows) {
    if (rows.empty() || rows.front().empty()) throw DomainError("the order matrix is empty");
    const std::size_t columns = rows.front().size();
    for (const auto& row : rows) {
        if (row.size() != columns) throw DomainError("the rows of the order matrix have different lengths");
    }
    for (std::size_t j = 0; j < columns; ++j) {
        const auto first = std::ranges::find_if(rows, [j](const auto& row) { return row[j] != 0; });
        if (first == rows.end() || (*first)[j] < 0)
            throw DomainError(
                "the order matrix is not admissible: the first nonzero entry of column " +
                std::to_string(j + 1) + " is " +
                (first == rows.end() ? "missing" : "negative, so 1 would be larger than that variable"));
    }
    if (rank_of(rows) < columns)
        throw DomainError("the order matrix is not admissible: its rank is less than its " +
                          std::to_string(columns) + " columns, so distinct monomials would compare equal");
    MonomialOrder order(Kind::matrix);
    order.rows_ = std::move(rows);
    return order;
}

void MonomialOrder::check(std::size_t variable_count) const {
    const auto expect = [&](std::size_t found, const char* what) {
        if (found != variable_count)
            throw DomainError("the order has " + std::to_string(found) + " " + what + ", the ring has " +
                              std::to_string(variable_count) + " variables");
    };
    if (kind_ == Kind::weighted) expect(weights_.size(), "weights");
    if (kind_ == Kind::matrix) expect(rows_.front().size(), "matrix columns");
    for (const auto& block : blocks_) {
        for (const std::size_t index : block) {
            if (index >= variable_count)
                throw DomainError("the order names a variable that the ring does not have");
        }
    }
}

std::vector<MonomialOrder::Key> MonomialOrder::keys(std::size_t variable_count) const {
    check(variable_count);
    std::vector<Key> keys;
    const std::vector<std::size_t> all = indices_below(variable_count);
    switch (kind_) {
    case Kind::lex:
        append_lex(keys, variable_count);
        break;
    case Kind::deglex:
        keys.push_back({std::vector<std::uint64_t>(variable_count, 1), false});
        append_lex(keys, variable_count);
        break;
    case Kind::degrevlex:
        if (variable_count != 0) append_degrevlex(keys, variable_count, all);
        break;
    case Kind::weighted:
        keys.push_back({weights_, false});
        if (tie_break_ == TieBreak::lex) append_lex(keys, variable_count);
        // With positive weights the first variable's exponent is decided by the degree and all others.
        for (std::size_t i = variable_count; tie_break_ == TieBreak::revlex && i-- > 1;)
            keys.push_back(unit_key(variable_count, i, true));
        break;
    case Kind::elimination: {
        std::vector<bool> named(variable_count, false);
        for (const auto& block : blocks_) {
            append_degrevlex(keys, variable_count, block);
            for (const std::size_t index : block) named[index] = true;
        }
        std::vector<std::size_t> rest;
        std::ranges::copy_if(all, std::back_inserter(rest), [&](std::size_t i) { return !named[i]; });
        if (!rest.empty()) append_degrevlex(keys, variable_count, rest);
        break;
    }
    case Kind::matrix:
        keys = matrix_keys(rows_, variable_count);
        break;
    }
    return keys;
}

std::string MonomialOrder::to_string(std::span<const std::string> names) const {
    std::string text;
    const auto join = [&text](const auto& items, auto&& print) {
        for (std::size_t i = 0; i < items.size(); ++i) {
            if (i != 0) text += ',';
            print(items[i]);
        }
    };
    const auto number = [&text](auto value) { text += std::to_string(value); };
    switch (kind_) {
    case Kind::lex:
        return "lex";
    case Kind::deglex:
        return "deglex";
    case Kind::degrevlex:
        return "degrevlex";
    case Kind::weighted:
        text = "weight(";
        join(weights_, number);
        return text + (tie_break_ == TieBreak::lex ? ";lex)" : ";revlex)");
    case Kind::elimination:
        text = "elim(";
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            if (i != 0) text += ';';
            join(blocks_[i], [&](std::size_t index) { text += names[index]; });
        }
        return text + ")";
    case Kind::matrix:
        text = "matrix(";
        for (std::size_t i = 0; i < rows_.size(); ++i) {
            if (i != 0) text += ';';
            join(rows_[i], number);
        }
        return text + ")";
    }
    return text;
}

} // namespace eliminant::algebra
