#include "polynomial_reader.hpp"

#include "eliminant/base/error.hpp"

#include "polynomial_arithmetic.hpp"

#include <utility>

namespace eliminant::algebra {

namespace {

/// Polynomials in which some names are defined.
struct DefinedArithmetic : PolynomialArithmetic {
    DefinedArithmetic(const Ring& ring, const base::SourceText& source, base::Run& run,
                      const PolynomialReader::Definitions* defined)
        : PolynomialArithmetic(ring, source, run), definitions(defined) {}
    Value name(std::string_view name, std::size_t offset) const {
        if (definitions != nullptr) {
            const auto found = definitions->find(name);
            if (found != definitions->end()) return value(found->second);
        }
        return PolynomialArithmetic::name(name, offset);
    }
    const PolynomialReader::Definitions* definitions;
};

bool is_stop(TokenKind kind) {
    return kind == TokenKind::end || kind == TokenKind::equals || kind == TokenKind::comma ||
           kind == TokenKind::semicolon;
}

} // namespace

PolynomialReader::PolynomialReader(const Ring& ring, const base::SourceText& source, Dialect dialect,
                                   base::Run& run)
    : ring_(ring), source_(source), dialect_(dialect), run_(run), terms_(ring, source.text(), dialect) {
    vocabulary_.is_variable = [this](std::string_view name) {
        return ring_.index_of(name).has_value() || (definitions_ != nullptr && definitions_->contains(name));
    };
}

std::size_t PolynomialReader::read_general_term(std::size_t position, PolynomialBuilder& sum) {
    Scanner scanner(source_, position);
    ExpressionParser parser(scanner, vocabulary_, dialect_, run_);
    const Expression term = parser.parse_product();
    const TokenKind next = scanner.peek().kind;
    if (next != TokenKind::plus && next != TokenKind::minus && !is_stop(next))
        scanner.fail("an operator or the end of the formula");
    DefinedArithmetic arithmetic(ring_, source_, run_, definitions_);
    const auto value = evaluate(term.view(), arithmetic);
    try {
        arithmetic.append(sum, value);
    } catch (const base::OverflowError&) {
        source_.fail(position, "exponents and weighted degrees below 2^63");
    }
    return scanner.peek().begin;
}

Polynomial PolynomialReader::read(std::size_t& position) {
    PolynomialBuilder sum(ring_);
    do {
        run_.poll();
        if (!terms_.read(position, sum)) position = read_general_term(position, sum);
        // Both readers leave the position at a sign, a character that ends the sum, or the end.
    } while (position < source_.size() &&
             std::string_view("=,;").find(source_.text()[position]) == std::string_view::npos);
    return sum.build();
}

Polynomial PolynomialReader::read_equation(std::size_t& position) {
    Polynomial f = read(position);
    if (position < source_.size() && source_.text()[position] == '=') {
        ++position;
        f -= read(position);
    }
    return f;
}

} // namespace eliminant::algebra
