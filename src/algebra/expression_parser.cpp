#include "expression_parser.hpp"

#include "eliminant/algebra/parse.hpp"

#include "number_text.hpp"
#include "polynomial_arithmetic.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::algebra {

Expression ExpressionParser::take_result() {
    name_indices_.clear();
    return std::exchange(result_, Expression(scanner_.source()));
}

Expression ExpressionParser::parse_sum() {
    sum();
    return take_result();
}

Expression ExpressionParser::parse_product() {
    product();
    return take_result();
}

void ExpressionParser::push_name(std::string_view name, std::size_t offset) {
    const auto next = static_cast<std::int64_t>(result_.names_.size());
    const auto [entry, is_new] = name_indices_.try_emplace(std::string(name), next);
    if (is_new) result_.names_.emplace_back(name);
    push(Kind::name, offset, entry->second);
}

void ExpressionParser::sum() {
    product();
    while (scanner_.peek().kind == TokenKind::plus || scanner_.peek().kind == TokenKind::minus) {
        const Token sign = scanner_.take();
        product();
        push(sign.kind == TokenKind::plus ? Kind::add : Kind::subtract, sign.begin);
    }
}

bool ExpressionParser::is_constant_from(std::size_t first_node) const {
    return std::all_of(result_.nodes_.begin() + static_cast<std::ptrdiff_t>(first_node), result_.nodes_.end(),
                       [](const auto& node) { return node.kind != Kind::name && node.kind != Kind::call; });
}

/// Any number of signs; whether they make a minus.
bool ExpressionParser::signs() {
    bool minus = false;
    while (scanner_.peek().kind == TokenKind::plus || scanner_.peek().kind == TokenKind::minus)
        minus ^= scanner_.take().kind == TokenKind::minus;
    return minus;
}

void ExpressionParser::product() {
    run_.poll();
    const std::size_t begin = scanner_.peek().begin;
    const std::size_t first_node = result_.nodes_.size();
    bool minus = signs();
    bool bare_number = scanner_.peek().kind == TokenKind::number;
    factor();
    for (;;) {
        const Token next = scanner_.peek();
        if (next.kind == TokenKind::times || next.kind == TokenKind::divide) {
            if (next.kind == TokenKind::divide && dialect_ == Dialect::singular &&
                is_constant_from(first_node))
                scanner_.fail(
                    "a variable before '/' (Singular divides integers with remainder, unless as in 7/2)");
            scanner_.take();
            minus ^= signs();
            const bool is_number = scanner_.peek().kind == TokenKind::number;
            factor();
            push(next.kind == TokenKind::times ? Kind::multiply : Kind::divide, next.begin);
            // In 1/2x the x could belong to either side.
            if (next.kind == TokenKind::divide && is_number && at_product_by_juxtaposition())
                scanner_.fail("an operator: a product after a/b needs a '*' or parentheses");
            bare_number = is_number && next.kind == TokenKind::times;
        } else if (bare_number && at_product_by_juxtaposition() && dialect_ == Dialect::eliminant) {
            factor();
            push(Kind::multiply, next.begin);
            bare_number = false;
        } else {
            break;
        }
    }
    if (minus) push(Kind::negate, begin);
}

void ExpressionParser::factor() {
    atom();
    const TokenKind next = scanner_.peek().kind;
    if (next != TokenKind::power && next != TokenKind::superscript) return;
    exponent();
    const TokenKind after = scanner_.peek().kind;
    if (after == TokenKind::power || after == TokenKind::superscript)
        scanner_.fail("parentheses that say which power is taken first");
}

void ExpressionParser::atom() {
    const Token token = scanner_.peek();
    if (dialect_ == Dialect::singular && (token.kind == TokenKind::number || token.kind == TokenKind::name))
        return singular_monomial();
    switch (token.kind) {
    case TokenKind::number:
        literal(scanner_.take());
        return;
    case TokenKind::left:
        nested("')'");
        return;
    case TokenKind::name: {
        scanner_.take();
        if (std::ranges::find(vocabulary_.functions, scanner_.text_of(token)) != vocabulary_.functions.end())
            return call(token);
        if (scanner_.peek().kind == TokenKind::left)
            scanner_.fail(vocabulary_.functions.empty()
                              ? "an operator (there are no functions here)"
                              : "an operator, or a known function before the parenthesis");
        return push_name(scanner_.text_of(token), token.begin);
    }
    default:
        scanner_.fail("a number, a name or a parenthesis");
    }
}

void ExpressionParser::nested(std::string_view expected) {
    if (++nesting_ > Expression::max_nesting)
        scanner_.fail("at most " + std::to_string(Expression::max_nesting) +
                      " parentheses inside each other");
    scanner_.require(TokenKind::left, "'('");
    sum();
    scanner_.require(TokenKind::right, "an operator or " + std::string(expected));
    --nesting_;
}

void ExpressionParser::call(const Token& name) {
    const std::size_t index = result_.nodes_.size();
    push_name(scanner_.text_of(name), name.begin);
    result_.nodes_.back().kind = Kind::call;
    if (scanner_.peek().kind != TokenKind::left)
        scanner_.fail("'(' after the function " + std::string(scanner_.text_of(name)));
    nested("')'");
    result_.nodes_[index].extent = result_.nodes_.size() - index - 1;
}

void ExpressionParser::literal(const Token& token) {
    const std::string_view text = scanner_.text_of(token);
    const std::size_t e = text.find_first_of("eE");
    if (e != std::string_view::npos) {
        const bool is_signed = text[e + 1] == '-' || text[e + 1] == '+';
        const bool runs_on = scanner_.adjacent() && scanner_.peek().kind == TokenKind::name;
        if (runs_on) scanner_.fail("an operator after the decimal '" + std::string(text) + "'");
        if (!is_signed && vocabulary_.is_variable && vocabulary_.is_variable(text.substr(e)))
            scanner_.source().fail(token.begin, "'" + std::string(text.substr(0, e)) + "*" +
                                                    std::string(text.substr(e)) + "' or a number, as " +
                                                    std::string(text.substr(e)) + " is a variable");
    }
    push(Kind::number, token.begin, static_cast<std::int64_t>(result_.numbers_.size()));
    result_.numbers_.push_back(read_number(scanner_.source(), token.begin, token.end));
}

/// `4/3x2y`, whose parts may not be separated: a number or fraction, then a known name, or letters that are
/// known names with their exponents.
void ExpressionParser::singular_monomial() {
    const std::string_view text = scanner_.source().text();
    std::size_t i = scanner_.peek().begin;
    const std::size_t begin = i;
    const auto end_of = [text](std::size_t from, auto&& belongs) {
        while (from < text.size() && belongs(text[from])) ++from;
        return from;
    };
    const auto push_number = [&](std::size_t end) {
        push(Kind::number, i, static_cast<std::int64_t>(result_.numbers_.size()));
        result_.numbers_.push_back(read_number(scanner_.source(), i, end));
        i = end;
    };
    const bool has_number = is_digit(text[i]);
    if (has_number) {
        push_number(end_of(i, is_digit));
        if (i + 1 < text.size() && text[i] == '/' && is_digit(text[i + 1])) {
            const std::size_t slash = i++;
            push_number(end_of(i, is_digit));
            push(Kind::divide, slash);
        }
    }
    std::size_t factors = has_number ? 1 : 0;
    const auto count_factor = [&] {
        if (factors++ > 0) push(Kind::multiply, begin);
    };
    const std::size_t word_end = end_of(i, continues_name);
    const std::string_view word = text.substr(i, word_end - i);
    const auto is_variable = [&](std::string_view name) { return vocabulary_.is_variable(name); };
    const bool splits = word.size() > 1 && !is_variable(word) && word.find('_') == std::string_view::npos;
    while (i < word_end) {
        const std::size_t end = splits ? i + 1 : word_end;
        push_name(text.substr(i, end - i), i);
        if (splits && !is_variable(text.substr(i, 1)))
            scanner_.source().fail(i, "a variable, or a product of one-letter variables");
        const std::size_t digits_end = splits ? end_of(end, is_digit) : end;
        if (digits_end > end) {
            const auto exponent = read_exponent(text.substr(end, digits_end - end));
            if (!exponent) scanner_.source().fail(end, "an exponent below 2^63");
            push_power(*exponent, end);
        }
        i = digits_end;
        count_factor();
    }
    scanner_.restart(i);
}

void ExpressionParser::exponent() {
    const Token power = scanner_.take();
    const char* const expected = "an integer exponent below 2^63";
    if (power.kind == TokenKind::superscript) {
        const std::string digits = superscript_text(scanner_.text_of(power));
        const bool minus = digits.front() == '-';
        const auto value =
            read_exponent(std::string_view(digits).substr(minus || digits.front() == '+' ? 1 : 0));
        if (!value) scanner_.source().fail(power.begin, expected);
        push_power(minus ? -*value : *value, power.begin);
    } else {
        const bool minus = signs();
        const Token token = scanner_.peek();
        std::int64_t value = 0;
        if (token.kind == TokenKind::left) {
            value = parenthesised_exponent();
        } else {
            scanner_.require(TokenKind::number, "an integer exponent");
            const auto number = read_number(scanner_.source(), token.begin, token.end);
            if (!number.denominator.is_one() || number.numerator.bit_length() > 63)
                scanner_.source().fail(token.begin, expected);
            value = number.numerator.to_mpz().get_si();
        }
        push_power(minus ? -value : value, power.begin);
    }
    if (dialect_ == Dialect::eliminant && at_product_by_juxtaposition())
        scanner_.fail("an operator: a product after a power needs a '*'");
}

std::int64_t ExpressionParser::parenthesised_exponent() {
    const std::size_t begin = scanner_.peek().begin;
    const std::size_t first_node = result_.nodes_.size();
    nested("')'");
    const ExpressionView view(result_, std::span(result_.nodes_).subspan(first_node));
    const auto value = evaluate_constant(view, "a number: an exponent is a constant", run_);
    if (value.get_den() != 1 || mpz_sizeinbase(value.get_num_mpz_t(), 2) > 63)
        scanner_.source().fail(begin, "an integer exponent below 2^63",
                               "(" + value.get_str().substr(0, 20) + ")");
    result_.nodes_.resize(first_node);
    return value.get_num().get_si();
}

void ExpressionParser::push_power(std::int64_t exponent, std::size_t offset) {
    push(Kind::power, offset, exponent);
}

} // namespace eliminant::algebra
