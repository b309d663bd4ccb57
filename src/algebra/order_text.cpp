#include "eliminant/algebra/parse.hpp"
#include "eliminant/base/error.hpp"

#include "number_text.hpp"
#include "scanner.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace eliminant::algebra {

namespace {

std::int64_t read_integer(Scanner& scanner, bool may_be_negative) {
    const bool minus = may_be_negative && scanner.accept(TokenKind::minus);
    const Token token =
        scanner.require(TokenKind::number, may_be_negative ? "an integer" : "a non-negative integer");
    const auto value = read_exponent(scanner.text_of(token));
    if (!value) {
        std::string found("'");
        found.append(scanner.text_of(token)).append("'");
        scanner.source().fail(token.begin, "an integer below 2^63", std::move(found));
    }
    return minus ? -*value : *value;
}

/// `(a,b;c,d)` as rows; `item` reads one entry.
template <class Item>
auto read_rows(Scanner& scanner, Item&& item) {
    std::vector<std::vector<decltype(item())>> rows;
    scanner.require(TokenKind::left, "'('");
    do {
        auto& row = rows.emplace_back();
        do {
            row.push_back(item());
        } while (scanner.accept(TokenKind::comma));
    } while (scanner.accept(TokenKind::semicolon));
    scanner.require(TokenKind::right, "',', ';' or ')'");
    return rows;
}

MonomialOrder read_weights(Scanner& scanner) {
    std::vector<std::uint64_t> weights;
    auto tie_break = MonomialOrder::TieBreak::revlex;
    scanner.require(TokenKind::left, "'('");
    do {
        weights.push_back(static_cast<std::uint64_t>(read_integer(scanner, false)));
    } while (scanner.accept(TokenKind::comma));
    if (scanner.accept(TokenKind::semicolon)) {
        const std::string_view word = scanner.text_of(scanner.peek());
        if (word != "lex" && word != "revlex") scanner.fail("lex or revlex");
        if (word == "lex") tie_break = MonomialOrder::TieBreak::lex;
        scanner.take();
    }
    scanner.require(TokenKind::right, "',' or ')'");
    return MonomialOrder::weighted(std::move(weights), tie_break);
}

MonomialOrder read_blocks(Scanner& scanner, std::span<const std::string> names) {
    return MonomialOrder::blocks(read_rows(scanner, [&] {
        const Token name = scanner.require(TokenKind::name, "a variable");
        const auto found = std::ranges::find(names, scanner.text_of(name));
        if (found == names.end()) scanner.source().fail(name.begin, "a variable of the ring");
        return static_cast<std::size_t>(found - names.begin());
    }));
}

MonomialOrder read_order(Scanner& scanner, std::span<const std::string> names) {
    const char* const expected = "lex, deglex, degrevlex, weight(…), elim(…) or matrix(…)";
    const Token word = scanner.peek();
    if (word.kind != TokenKind::name) scanner.fail(expected);
    const std::string_view kind = scanner.text_of(scanner.take());
    if (kind == "lex") return MonomialOrder::lex();
    if (kind == "deglex") return MonomialOrder::deglex();
    if (kind == "degrevlex") return MonomialOrder::degrevlex();
    if (kind == "weight") return read_weights(scanner);
    if (kind == "elim") return read_blocks(scanner, names);
    if (kind == "matrix")
        return MonomialOrder::matrix(read_rows(scanner, [&] { return read_integer(scanner, true); }));
    scanner.source().fail(word.begin, expected);
}

} // namespace

MonomialOrder parse_order(const base::SourceText& source, std::span<const std::string> names) {
    source.check_encoding();
    Scanner scanner(source);
    const std::size_t begin = scanner.peek().begin;
    try {
        MonomialOrder order = read_order(scanner, names);
        scanner.require(TokenKind::end, "the end of the order");
        static_cast<void>(order.keys(names.size())); // also rejects matrices with entries that grow too large
        return order;
    } catch (const base::DomainError& reason) {
        source.fail(begin, "an admissible order of the variables", reason.what());
    }
}

CoefficientField parse_field(const base::SourceText& source) {
    source.check_encoding();
    Scanner scanner(source);
    const char* const expected = "QQ or GF(p)";
    const Token word = scanner.peek();
    auto field = CoefficientField::rationals();
    if (scanner.text_of(word) == "GF") {
        scanner.take();
        scanner.require(TokenKind::left, "'('");
        const Token number = scanner.require(TokenKind::number, "a prime");
        const auto p = read_exponent(scanner.text_of(number));
        try {
            field = CoefficientField::prime(p ? static_cast<std::uint64_t>(*p) : 0);
        } catch (const base::DomainError&) {
            source.fail(number.begin, "a prime below 2^31");
        }
        scanner.require(TokenKind::right, "')'");
    } else {
        if (scanner.text_of(word) != "QQ") scanner.fail(expected);
        scanner.take();
    }
    scanner.require(TokenKind::end, "the end of the field");
    return field;
}

} // namespace eliminant::algebra
