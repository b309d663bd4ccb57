#include "eliminant/algebra/system.hpp"

#include "eliminant/algebra/parse.hpp"
#include "eliminant/algebra/print.hpp"
#include "eliminant/base/error.hpp"

#include "number_text.hpp"
#include "polynomial_reader.hpp"
#include "scanner.hpp"
#include "system_reader.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace eliminant::algebra {

namespace {

bool is_keyword(std::string_view word) { return word == "variables" || word == "field" || word == "order"; }

/// Whether the scanner stands at a header line. A name is never followed by a name in a polynomial, so a
/// variable may be called `order`.
bool at_header(Scanner scanner) {
    const Token word = scanner.take();
    const TokenKind next = scanner.peek().kind;
    return word.kind == TokenKind::name && is_keyword(scanner.text_of(word)) &&
           (next == TokenKind::name || next == TokenKind::end);
}

/// The lines of a system file, by what they are.
struct SystemLines {
    std::optional<base::SourceText> variables;
    std::optional<base::SourceText> field;
    std::optional<base::SourceText> order;
    std::vector<base::SourceText> polynomials;
};

void add_header(SystemLines& lines, const base::SourceText& line, Scanner scanner) {
    const Token word = scanner.take();
    const std::string_view keyword = scanner.text_of(word);
    auto& place = keyword == "variables" ? lines.variables : keyword == "field" ? lines.field : lines.order;
    if (place) line.fail(word.begin, "one line '" + std::string(keyword) + "'", "a second one");
    if (!lines.polynomials.empty())
        line.fail(word.begin, "the line '" + std::string(keyword) + "' before the first polynomial");
    place = line.section(word.end, line.size());
}

SystemLines split_lines(const base::SourceText& source) {
    SystemLines lines;
    const std::string_view text = source.text();
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const bool has_mark = begin == 0 && text.starts_with("\uFEFF");
        const base::SourceText line = source.section(has_mark ? 3 : begin, end);
        const Scanner scanner(line);
        if (at_header(scanner))
            add_header(lines, line, scanner);
        else if (scanner.peek().kind != TokenKind::end)
            lines.polynomials.push_back(line);
        begin = end + 1;
    }
    return lines;
}

std::vector<std::string> names_in_all(std::span<const base::SourceText> texts) {
    std::vector<std::string> names;
    std::unordered_set<std::string> known;
    for (const base::SourceText& text : texts) {
        for (std::string& name : names_in(text)) {
            if (known.insert(name).second) names.push_back(std::move(name));
        }
    }
    return names;
}

/// Whether the text begins as Singular's: with a comment of C++ or one of these declarations.
bool looks_like_singular(const base::SourceText& source) {
    Scanner scanner(source);
    const Token first = scanner.take();
    if (first.kind == TokenKind::divide) {
        const TokenKind second = scanner.peek().kind;
        return scanner.adjacent() && (second == TokenKind::divide || second == TokenKind::times ||
                                      second == TokenKind::power); // "//", "/*", "/**"
    }
    const std::string_view word = scanner.text_of(first);
    return (word == "ring" && scanner.peek().kind == TokenKind::name) ||
           (word == "LIB" && scanner.peek().kind == TokenKind::other);
}

/// How many names a list has at the beginning that is followed, on a later line, by an integer on its own:
/// the beginning of msolve's format. 0 if that is not how the text begins.
std::size_t names_before_characteristic(const base::SourceText& source) {
    Scanner scanner(source);
    std::size_t count = 0;
    std::size_t list_end = 0;
    do {
        const Token name = scanner.take();
        if (name.kind != TokenKind::name) return 0;
        list_end = name.end;
        ++count;
    } while (scanner.accept(TokenKind::comma));
    const std::string_view text = source.text();
    const Token number = scanner.take();
    if (number.kind != TokenKind::number || !std::ranges::all_of(scanner.text_of(number), is_digit)) return 0;
    const auto breaks_between = [text](std::size_t from, std::size_t to) {
        return text.substr(from, to - from).find('\n') != std::string_view::npos;
    };
    const bool alone =
        breaks_between(list_end, number.begin) && breaks_between(number.end, scanner.peek().begin);
    return alone ? count : 0;
}

SystemFormat guess(const base::SourceText& source) {
    if (looks_like_singular(source)) return SystemFormat::singular;
    // One name and a number on lines of their own are two polynomials as well.
    const std::size_t names = names_before_characteristic(source);
    if (names == 1)
        source.fail(Scanner(source).peek().begin, "a line 'variables …', or the input format said",
                    "a text that msolve's format would read differently");
    return names > 1 ? SystemFormat::msolve : SystemFormat::eliminant;
}

std::vector<Polynomial> read_lines(const Ring& ring, std::span<const base::SourceText> lines,
                                   base::Run& run) {
    std::vector<Polynomial> polynomials;
    for (const base::SourceText& line : lines) polynomials.push_back(parse_equation(ring, line, run));
    return polynomials;
}

} // namespace

MonomialOrder order_or(const SystemOverrides& overrides, std::span<const std::string> names,
                       MonomialOrder otherwise) {
    if (!overrides.order) return otherwise;
    return parse_order({*overrides.order, "order"}, names);
}

System read_eliminant_system(const base::SourceText& source, const SystemOverrides& overrides,
                             base::Run& run) {
    const SystemLines lines = split_lines(source);
    const auto field = lines.field ? parse_field(*lines.field) : CoefficientField::rationals();
    const auto declared = lines.variables ? std::optional(parse_names(*lines.variables)) : std::nullopt;
    const auto names = overrides.variables ? *overrides.variables
                       : declared          ? *declared
                                           : names_in_all(lines.polynomials);
    // The line is read against its own names even where it is overridden, so that a wrong one is never
    // silent.
    auto order = lines.order ? parse_order(*lines.order, overrides.order && declared ? *declared : names)
                             : MonomialOrder::degrevlex();
    const Ring ring(overrides.field.value_or(field), names, order_or(overrides, names, std::move(order)));
    return {ring, read_lines(ring, lines.polynomials, run)};
}

System read_msolve_system(const base::SourceText& source, const SystemOverrides& overrides, base::Run& run) {
    Scanner scanner(source);
    std::vector<std::string> names;
    do {
        const Token name = scanner.require(TokenKind::name, "a variable");
        if (std::ranges::find(names, scanner.text_of(name)) != names.end())
            source.fail(name.begin, "a variable that is not yet in the list");
        names.emplace_back(scanner.text_of(name));
    } while (scanner.accept(TokenKind::comma));
    const char* const characteristic_expected = "the characteristic, 0 or a prime below 2^31";
    const Token number = scanner.require(TokenKind::number, "',' or " + std::string(characteristic_expected));
    const auto p = read_exponent(scanner.text_of(number));
    if (!p || (*p != 0 && (*p >= std::int64_t{1} << 31 || !is_prime(static_cast<std::uint64_t>(*p)))))
        source.fail(number.begin, characteristic_expected);
    const auto field =
        *p == 0 ? CoefficientField::rationals() : CoefficientField::prime(static_cast<std::uint64_t>(*p));

    if (overrides.variables) names = *overrides.variables;
    const Ring ring(overrides.field.value_or(field), names,
                    order_or(overrides, names, MonomialOrder::degrevlex()));
    System system{ring, {}};
    PolynomialReader reader(ring, source, Dialect::eliminant, run);
    std::size_t position = number.end;
    for (;;) {
        system.polynomials.push_back(reader.read(position));
        if (position == source.size()) return system;
        if (source.text()[position] != ',') source.fail(position, "an operator, ',' or the end of the text");
        ++position;
    }
}

System parse_system(const base::SourceText& source, SystemFormat format, const SystemOverrides& overrides,
                    base::Run& run) {
    source.check_encoding();
    switch (format == SystemFormat::guess ? guess(source) : format) {
    case SystemFormat::msolve:
        return read_msolve_system(source, overrides, run);
    case SystemFormat::singular:
        return read_singular_system(source, overrides, run);
    default:
        return read_eliminant_system(source, overrides, run);
    }
}

System parse_system(std::span<const base::SourceText> polynomials, const SystemOverrides& overrides,
                    base::Run& run) {
    const auto names = overrides.variables ? *overrides.variables : names_in_all(polynomials);
    const Ring ring(overrides.field.value_or(CoefficientField::rationals()), names,
                    order_or(overrides, names, MonomialOrder::degrevlex()));
    return {ring, read_lines(ring, polynomials, run)};
}

std::string to_string(const System& system) {
    const Ring& ring = system.ring;
    std::string text;
    for (std::size_t i = 0; i < ring.variable_count(); ++i)
        text.append(i == 0 ? "variables " : ", ").append(ring.names()[i]);
    if (ring.variable_count() > 0) text += '\n';
    text.append("field ").append(ring.field().to_string()).append("\n");
    if (ring.variable_count() > 0)
        text.append("order ").append(ring.order().to_string(ring.names())).append("\n");
    for (const Polynomial& f : system.polynomials) {
        const std::string line = to_string(f);
        // Alone on its line, a variable of that name would be a header; a sign makes it a polynomial.
        text.append(is_keyword(line) ? "+" : "").append(line).append("\n");
    }
    return text;
}

} // namespace eliminant::algebra
