#include "orders.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace eliminant::exporting {

namespace {

using algebra::MonomialOrder;
using algebra::Ring;
using Kind = MonomialOrder::Kind;
using Row = std::vector<std::int64_t>;

template <class Items, class Print>
std::string joined(const Items& items, Print&& print) {
    std::string text;
    for (const auto& item : items) {
        if (!text.empty()) text += ',';
        text += print(item);
    }
    return text;
}

std::string enclosed(std::string_view left, std::string_view middle, std::string_view right) {
    std::string text(left);
    return text.append(middle).append(right);
}

template <class Number>
std::string numbers(const std::vector<Number>& row) {
    return joined(row, [](Number value) { return std::to_string(value); });
}

std::string strings(std::span<const std::string> items) {
    return joined(items, [](const std::string& item) { return item; });
}

/// The order as a square matrix: its keys without those that depend on the ones before and so decide nothing.
/// As the order is total, as many remain as there are variables.
std::vector<Row> square_matrix(const Ring& ring) {
    const std::size_t n = ring.variable_count();
    std::vector<Row> rows;
    std::vector<std::vector<mpq_class>> echelon;
    for (const MonomialOrder::Key& key : ring.order().keys(n)) {
        if (rows.size() == n) break;
        Row row;
        for (const std::uint64_t w : key.weights)
            row.push_back(key.reversed ? -static_cast<std::int64_t>(w) : static_cast<std::int64_t>(w));
        std::vector<mpq_class> rest;
        for (const std::int64_t w : row) rest.emplace_back(static_cast<long>(w));
        for (const auto& reduced : echelon) {
            const auto pivot =
                std::ranges::find_if(reduced, [](const mpq_class& c) { return c != 0; }) - reduced.begin();
            const mpq_class factor =
                rest[static_cast<std::size_t>(pivot)] / reduced[static_cast<std::size_t>(pivot)];
            for (std::size_t j = 0; j < n; ++j) rest[j] -= factor * reduced[j];
        }
        if (std::ranges::all_of(rest, [](const mpq_class& c) { return c == 0; })) continue;
        echelon.push_back(std::move(rest));
        rows.push_back(std::move(row));
    }
    return rows;
}

/// The sizes of an elimination order's blocks, the last one included, if each takes up the variables where
/// the one before left off.
std::optional<std::vector<std::size_t>> consecutive_blocks(const Ring& ring) {
    std::vector<std::size_t> sizes;
    std::size_t next = 0;
    for (const auto& block : ring.order().blocks()) {
        for (const std::size_t index : block) {
            if (index != next++) return std::nullopt;
        }
        sizes.push_back(block.size());
    }
    if (next < ring.variable_count()) sizes.push_back(ring.variable_count() - next);
    return sizes;
}

bool has_zero_weight(const MonomialOrder& order) {
    return std::ranges::find(order.weights(), std::uint64_t{0}) != order.weights().end();
}

} // namespace

std::string singular_order(const Ring& ring) {
    const MonomialOrder& order = ring.order();
    const auto matrix = [&] {
        return enclosed("M(", joined(square_matrix(ring), &numbers<std::int64_t>), ")");
    };
    switch (order.kind()) {
    case Kind::lex:
        return "lp";
    case Kind::deglex:
        return "Dp";
    case Kind::degrevlex:
        return "dp";
    case Kind::weighted:
        if (order.tie_break() == MonomialOrder::TieBreak::revlex)
            return enclosed("wp(", numbers(order.weights()), ")");
        if (has_zero_weight(order)) return enclosed("(a(", numbers(order.weights()), "),lp)");
        return enclosed("Wp(", numbers(order.weights()), ")");
    case Kind::elimination:
        if (const auto sizes = consecutive_blocks(ring))
            return enclosed(
                "(", joined(*sizes, [](std::size_t k) { return enclosed("dp(", std::to_string(k), ")"); }),
                ")");
        return matrix();
    case Kind::matrix:
        return matrix();
    }
    return {};
}

std::string macaulay2_order(const Ring& ring) {
    const MonomialOrder& order = ring.order();
    const auto weights = [](const auto& row) { return enclosed("Weights=>{", numbers(row), "}"); };
    const auto matrix = [&] { return enclosed("{", joined(square_matrix(ring), weights), ",Lex}"); };
    switch (order.kind()) {
    case Kind::lex:
        return "Lex";
    case Kind::deglex:
        return "GLex";
    case Kind::degrevlex:
        return "GRevLex";
    case Kind::weighted:
        if (order.tie_break() == MonomialOrder::TieBreak::lex)
            return enclosed("{", weights(order.weights()), ",Lex}");
        return enclosed("{GRevLex=>{", numbers(order.weights()), "}}");
    case Kind::elimination:
        if (const auto sizes = consecutive_blocks(ring))
            return enclosed(
                "{",
                joined(*sizes, [](std::size_t k) { return enclosed("GRevLex=>", std::to_string(k), ""); }),
                "}");
        return matrix();
    case Kind::matrix:
        return matrix();
    }
    return {};
}

std::string sage_order(const Ring& ring) {
    const MonomialOrder& order = ring.order();
    const auto matrix = [&] {
        const std::string n = std::to_string(ring.variable_count());
        std::string text = "TermOrder(matrix(";
        text.append(n).append(",").append(n);
        return text.append(",[").append(joined(square_matrix(ring), &numbers<std::int64_t>)).append("]))");
    };
    switch (order.kind()) {
    case Kind::lex:
        return "'lex'";
    case Kind::deglex:
        return "'deglex'";
    case Kind::degrevlex:
        return "'degrevlex'";
    case Kind::weighted: {
        if (has_zero_weight(order)) return matrix();
        const bool is_lex = order.tie_break() == MonomialOrder::TieBreak::lex;
        const std::string comma = order.weights().size() == 1 ? "," : "";
        return std::string("TermOrder('")
            .append(is_lex ? "wdeglex" : "wdegrevlex")
            .append("',(")
            .append(numbers(order.weights()))
            .append(comma)
            .append("))");
    }
    case Kind::elimination:
        if (const auto sizes = consecutive_blocks(ring)) {
            std::string text;
            for (const std::size_t k : *sizes)
                text.append(text.empty() ? "" : "+")
                    .append("TermOrder('degrevlex',")
                    .append(std::to_string(k))
                    .append(")");
            return text;
        }
        return matrix();
    case Kind::matrix:
        return matrix();
    }
    return {};
}

std::string maple_order(const Ring& ring, std::span<const std::string> names) {
    const MonomialOrder& order = ring.order();
    switch (order.kind()) {
    case Kind::lex:
        return enclosed("plex(", strings(names), ")");
    case Kind::deglex:
        return enclosed("grlex(", strings(names), ")");
    case Kind::degrevlex:
        return enclosed("tdeg(", strings(names), ")");
    case Kind::elimination: {
        const auto sizes = consecutive_blocks(ring);
        if (!sizes || sizes->size() != 2) break;
        const auto first = names.first(sizes->front());
        return enclosed("lexdeg([", strings(first), "],")
            .append(enclosed("[", strings(names.subspan(first.size())), "])"));
    }
    default:
        break;
    }
    const auto row = [](const Row& entries) { return enclosed("[", numbers(entries), "]"); };
    return enclosed("'matrix'([", joined(square_matrix(ring), row), "],")
        .append(enclosed("[", strings(names), "])"));
}

} // namespace eliminant::exporting
