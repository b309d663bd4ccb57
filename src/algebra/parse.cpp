#include "eliminant/algebra/parse.hpp"

#include "expression_parser.hpp"
#include "polynomial_reader.hpp"
#include "scanner.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace eliminant::algebra {

namespace {

const char* const end_expected = "an operator or the end of the formula";

} // namespace

Expression parse_expression(const base::SourceText& source, const Vocabulary& vocabulary, base::Run& run) {
    source.check_encoding();
    Scanner scanner(source);
    ExpressionParser parser(scanner, vocabulary, Dialect::eliminant, run);
    Expression result = parser.parse_sum();
    scanner.require(TokenKind::end, end_expected);
    return result;
}

Polynomial parse_polynomial(const Ring& ring, const base::SourceText& source, base::Run& run) {
    source.check_encoding();
    std::size_t position = 0;
    Polynomial f = PolynomialReader(ring, source, Dialect::eliminant, run).read(position);
    if (position != source.size()) source.fail(position, end_expected);
    return f;
}

Polynomial parse_polynomial(const Ring& ring, const base::SourceText& source) {
    base::Run run;
    return parse_polynomial(ring, source, run);
}

Polynomial parse_equation(const Ring& ring, const base::SourceText& source, base::Run& run) {
    source.check_encoding();
    std::size_t position = 0;
    Polynomial f = PolynomialReader(ring, source, Dialect::eliminant, run).read_equation(position);
    if (position != source.size()) source.fail(position, end_expected);
    return f;
}

mpq_class parse_rational(const base::SourceText& source) {
    base::Run run;
    const Expression expression = parse_expression(source, {}, run);
    return evaluate_constant(expression.view(), "a number", run);
}

std::vector<std::string> names_in(const base::SourceText& source) {
    source.check_encoding();
    std::vector<std::string> names;
    std::unordered_set<std::string_view> known; // views into the text
    Scanner scanner(source);
    while (scanner.peek().kind != TokenKind::end) {
        const Token token = scanner.take();
        if (token.kind != TokenKind::name) continue;
        const std::string_view name = scanner.text_of(token);
        if (known.insert(source.text().substr(token.begin, name.size())).second) names.emplace_back(name);
    }
    return names;
}

std::vector<std::string> parse_names(const base::SourceText& source) {
    source.check_encoding();
    Scanner scanner(source);
    std::vector<std::string> names;
    std::unordered_set<std::string_view> known;
    do {
        const Token name =
            scanner.require(TokenKind::name, "a name: a letter, then letters, digits, underscores");
        if (!known.insert(scanner.text_of(name)).second)
            source.fail(name.begin, "a name that is not yet in the list");
        names.emplace_back(scanner.text_of(name));
    } while (scanner.accept(TokenKind::comma));
    scanner.require(TokenKind::end, "',' or the end of the list");
    return names;
}

} // namespace eliminant::algebra
