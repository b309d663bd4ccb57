#include "eliminant/algebra/parse.hpp"
#include "eliminant/base/error.hpp"

#include "number_text.hpp"
#include "polynomial_reader.hpp"
#include "scanner.hpp"
#include "system_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace eliminant::algebra {

namespace {

/// A copy of the text, byte for byte as long, with blanks for Singular's comments and for the statements that
/// say nothing about the system.
std::string without_comments(const base::SourceText& source) {
    std::string text(source.text());
    const auto blank_out = [&text](std::size_t begin, std::size_t end) {
        std::replace_if(
            text.begin() + static_cast<std::ptrdiff_t>(begin),
            text.begin() + static_cast<std::ptrdiff_t>(end), [](char c) { return c != '\n'; }, ' ');
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '#') source.fail(i, "Singular's language, in which comments begin with '//'", "'#'");
        if (text[i] == '"') { // a file name; no comment begins inside
            const std::size_t end = text.find('"', i + 1);
            if (end == std::string::npos) source.fail(i, "a string with an end");
            i = end;
        } else if (text.compare(i, 2, "//") == 0) {
            blank_out(i, std::min(text.find('\n', i), text.size()));
        } else if (text.compare(i, 2, "/*") == 0) {
            const std::size_t end = text.find("*/", i + 2);
            if (end == std::string::npos) source.fail(i, "a comment with an end");
            blank_out(i, end + 2);
        }
    }
    return text;
}

/// A block of a product ordering.
struct Block {
    enum class Kind { lex, degrevlex, deglex, weighted_revlex, weighted_lex, matrix, weight_vector } kind;
    std::size_t first; ///< variable
    std::size_t size;
    std::vector<std::int64_t> numbers; ///< weights, or matrix entries row by row
};

std::optional<Block::Kind> block_kind(std::string_view name) {
    using Kind = Block::Kind;
    constexpr std::pair<std::string_view, Kind> kinds[] = {
        {"lp", Kind::lex},          {"dp", Kind::degrevlex},
        {"Dp", Kind::deglex},       {"wp", Kind::weighted_revlex},
        {"Wp", Kind::weighted_lex}, {"M", Kind::matrix},
        {"a", Kind::weight_vector}};
    const auto* const found = std::ranges::find(kinds, name, &std::pair<std::string_view, Kind>::first);
    if (found == std::end(kinds)) return std::nullopt;
    return found->second;
}

bool takes_weights(Block::Kind kind) {
    return kind == Block::Kind::weighted_revlex || kind == Block::Kind::weighted_lex ||
           kind == Block::Kind::weight_vector;
}

/// Appends the rows that a block contributes to the matrix of the order.
void append_rows(std::vector<std::vector<std::int64_t>>& rows, const Block& block,
                 std::size_t variable_count) {
    using Kind = Block::Kind;
    const auto row = [&]() -> std::vector<std::int64_t>& { return rows.emplace_back(variable_count, 0); };
    if (block.kind == Kind::matrix) {
        for (std::size_t i = 0; i < block.size; ++i) {
            auto& r = row();
            for (std::size_t j = 0; j < block.size; ++j)
                r[block.first + j] = block.numbers[i * block.size + j];
        }
        return;
    }
    if (block.kind != Kind::lex) {
        auto& r = row();
        for (std::size_t j = 0; j < block.size; ++j)
            r[block.first + j] = takes_weights(block.kind) ? block.numbers[j] : 1;
    }
    if (block.kind == Kind::weight_vector) return;
    const bool is_reverse = block.kind == Kind::degrevlex || block.kind == Kind::weighted_revlex;
    for (std::size_t j = 0; j < block.size; ++j)
        row()[block.first + (is_reverse ? block.size - 1 - j : j)] = is_reverse ? -1 : 1;
    // The degree and all but one exponent decide the last one.
    if (block.kind != Kind::lex) rows.pop_back();
}

MonomialOrder order_of(const std::vector<Block>& blocks, std::size_t variable_count) {
    using Kind = Block::Kind;
    if (blocks.size() == 1) {
        const Block& block = blocks.front();
        const std::vector<std::uint64_t> weights(block.numbers.begin(), block.numbers.end());
        if (block.kind == Kind::lex) return MonomialOrder::lex();
        if (block.kind == Kind::degrevlex) return MonomialOrder::degrevlex();
        if (block.kind == Kind::deglex) return MonomialOrder::deglex();
        if (block.kind == Kind::weighted_revlex)
            return MonomialOrder::weighted(weights, MonomialOrder::TieBreak::revlex);
        if (block.kind == Kind::weighted_lex)
            return MonomialOrder::weighted(weights, MonomialOrder::TieBreak::lex);
    }
    if (std::ranges::all_of(blocks, [](const Block& block) { return block.kind == Kind::degrevlex; })) {
        std::vector<std::vector<std::size_t>> indices;
        for (const Block& block : blocks) {
            auto& list = indices.emplace_back();
            for (std::size_t j = 0; j < block.size; ++j) list.push_back(block.first + j);
        }
        indices.pop_back(); // what is in no block forms the last one
        return MonomialOrder::blocks(std::move(indices));
    }
    std::vector<std::vector<std::int64_t>> rows;
    for (const Block& block : blocks) append_rows(rows, block, variable_count);
    return MonomialOrder::matrix(std::move(rows));
}

/// Reads the declarations one after another.
class SingularReader {
  public:
    SingularReader(const base::SourceText& source, const SystemOverrides& overrides, base::Run& run)
        : overrides_(overrides), run_(run), scanner_(source) {}

    System read();

  private:
    const base::SourceText& source() const { return scanner_.source(); }
    bool at_word(std::string_view word) const { return scanner_.text_of(scanner_.peek()) == word; }
    void skip_statement();
    void ring_declaration();
    CoefficientField coefficients();
    std::vector<std::string> variables(TokenKind close);
    std::vector<Block> ordering(std::size_t variable_count);
    Block block(std::size_t first, std::size_t variable_count);
    std::vector<std::int64_t> numbers();
    void poly_declaration();
    void ideal_declaration();
    Token declared_name();
    Polynomial polynomial();

    const SystemOverrides& overrides_;
    base::Run& run_;
    Scanner scanner_;
    std::optional<Ring> ring_;
    PolynomialReader::Definitions definitions_;
    std::vector<Polynomial> polynomials_;
    std::optional<std::vector<Polynomial>> ideal_;
};

System SingularReader::read() {
    while (scanner_.peek().kind != TokenKind::end) {
        if (at_word("ring"))
            ring_declaration();
        else if (at_word("poly"))
            poly_declaration();
        else if (at_word("ideal"))
            ideal_declaration();
        else if (at_word("LIB") || at_word("option") || at_word("short") || at_word("quit") ||
                 at_word("exit"))
            skip_statement();
        else
            scanner_.fail("'ring', 'poly' or 'ideal' (no other statement of Singular is understood)");
    }
    if (!ring_) scanner_.fail("a declaration 'ring r = …;'");
    return {*ring_, ideal_ ? *std::move(ideal_) : std::move(polynomials_)};
}

void SingularReader::skip_statement() {
    while (scanner_.peek().kind != TokenKind::end && scanner_.take().kind != TokenKind::semicolon) {
    }
}

Token SingularReader::declared_name() {
    scanner_.take();
    const Token name = scanner_.require(TokenKind::name, "a name");
    scanner_.require(TokenKind::equals, "'='");
    return name;
}

void SingularReader::ring_declaration() {
    const std::size_t begin = scanner_.peek().begin;
    if (ring_) scanner_.fail("one ring");
    declared_name();
    const CoefficientField field = coefficients();
    std::vector<std::string> names;
    std::vector<Block> blocks;
    if (source().text().substr(scanner_.peek().begin, 1) == "[") { // QQ[x,y,z], in dp
        scanner_.take();
        names = variables(TokenKind::other);
        blocks = {{Block::Kind::degrevlex, 0, names.size(), {}}};
    } else {
        scanner_.require(TokenKind::comma, "','");
        if (scanner_.accept(TokenKind::left))
            names = variables(TokenKind::right);
        else
            names = {std::string(scanner_.text_of(scanner_.require(TokenKind::name, "the variables")))};
        scanner_.require(TokenKind::comma, "','");
        blocks = ordering(names.size());
    }
    scanner_.require(TokenKind::semicolon, "';'");
    if (overrides_.variables) names = *overrides_.variables;
    try {
        auto order = overrides_.order ? order_or(overrides_, names, MonomialOrder::lex())
                                      : order_of(blocks, names.size());
        ring_ = Ring(overrides_.field.value_or(field), names, std::move(order));
    } catch (const base::DomainError& reason) {
        source().fail(begin, "a ring with an admissible order", reason.what());
    }
}

CoefficientField SingularReader::coefficients() {
    const char* const expected = "0, QQ, ZZ/p or a prime p below 2^31 as coefficient field";
    if (at_word("QQ")) {
        scanner_.take();
        return CoefficientField::rationals();
    }
    const bool parenthesis = scanner_.accept(TokenKind::left);
    if (at_word("ZZ")) {
        scanner_.take();
        scanner_.require(TokenKind::divide, "'/': the coefficients form a field");
    }
    const Token number = scanner_.require(TokenKind::number, expected);
    const auto p = read_exponent(scanner_.text_of(number));
    if (parenthesis) scanner_.require(TokenKind::right, "')' (fields with parameters are not understood)");
    if (p && *p == 0) return CoefficientField::rationals();
    if (!p || *p >= std::int64_t{1} << 31 || !is_prime(static_cast<std::uint64_t>(*p)))
        source().fail(number.begin, expected);
    return CoefficientField::prime(static_cast<std::uint64_t>(*p));
}

std::vector<std::string> SingularReader::variables(TokenKind close) {
    std::vector<std::string> names;
    do {
        const Token name = scanner_.require(TokenKind::name, "a variable");
        if (scanner_.peek().kind == TokenKind::left)
            scanner_.fail("',' (indexed variables are not understood)");
        names.emplace_back(scanner_.text_of(name));
    } while (scanner_.accept(TokenKind::comma));
    if (close == TokenKind::other && !at_word("]")) scanner_.fail("',' or ']'");
    scanner_.require(close, "',' or ')'");
    return names;
}

std::vector<std::int64_t> SingularReader::numbers() {
    std::vector<std::int64_t> result;
    scanner_.require(TokenKind::left, "'('");
    do {
        const bool minus = scanner_.accept(TokenKind::minus);
        const Token number = scanner_.require(TokenKind::number, "an integer");
        const auto value = read_exponent(scanner_.text_of(number));
        if (!value) source().fail(number.begin, "an integer below 2^63");
        result.push_back(minus ? -*value : *value);
    } while (scanner_.accept(TokenKind::comma));
    scanner_.require(TokenKind::right, "',' or ')'");
    return result;
}

Block SingularReader::block(std::size_t first, std::size_t variable_count) {
    const Token name = scanner_.peek();
    const auto kind = block_kind(scanner_.text_of(name));
    if (!kind) scanner_.fail("one of the global orderings lp, dp, Dp, wp, Wp, M, a");
    scanner_.take();
    Block result{*kind, first, variable_count - first, {}};
    if (takes_weights(*kind) || *kind == Block::Kind::matrix) {
        result.numbers = numbers();
        result.size = result.numbers.size();
        if (*kind == Block::Kind::matrix) {
            result.size = 0;
            while (result.size * result.size < result.numbers.size()) ++result.size;
            if (result.size * result.size != result.numbers.size())
                source().fail(name.begin, "a square matrix",
                              std::to_string(result.numbers.size()) + " entries");
        }
    } else if (scanner_.peek().kind == TokenKind::left) {
        const Token parenthesis = scanner_.peek();
        const auto size = numbers();
        if (size.size() != 1 || size.front() < 1) source().fail(parenthesis.begin, "the size of the block");
        result.size = static_cast<std::size_t>(size.front());
    }
    if (result.size == 0 || result.size > variable_count - first)
        source().fail(name.begin, "blocks that fit " + std::to_string(variable_count) + " variables");
    return result;
}

std::vector<Block> SingularReader::ordering(std::size_t variable_count) {
    const Token begin = scanner_.peek();
    const bool several = scanner_.accept(TokenKind::left);
    std::vector<Block> blocks;
    std::size_t ordered = 0;
    do {
        if (several && (at_word("c") || at_word("C"))) { // where module components stand: nothing to an ideal
            scanner_.take();
            continue;
        }
        blocks.push_back(block(ordered, variable_count));
        if (blocks.back().kind != Block::Kind::weight_vector) ordered += blocks.back().size;
    } while (several && scanner_.accept(TokenKind::comma));
    if (several) scanner_.require(TokenKind::right, "',' or ')'");
    if (ordered != variable_count)
        source().fail(begin.begin, "an ordering of " + std::to_string(variable_count) + " variables",
                      "one of " + std::to_string(ordered));
    return blocks;
}

Polynomial SingularReader::polynomial() {
    if (!ring_) scanner_.fail("a ring before the first polynomial");
    PolynomialReader reader(*ring_, source(), Dialect::singular, run_);
    reader.set_definitions(definitions_);
    std::size_t position = scanner_.peek().begin;
    Polynomial f = reader.read(position);
    scanner_.restart(position);
    return f;
}

void SingularReader::poly_declaration() {
    Token name = declared_name();
    for (;;) {
        if (ring_ && ring_->index_of(scanner_.text_of(name)))
            source().fail(name.begin, "a name that is not a variable");
        const Polynomial f = polynomial();
        definitions_.insert_or_assign(std::string(scanner_.text_of(name)), f);
        polynomials_.push_back(f);
        if (!scanner_.accept(TokenKind::comma)) break;
        name = scanner_.require(TokenKind::name, "a name");
        scanner_.require(TokenKind::equals, "'='");
    }
    scanner_.require(TokenKind::semicolon, "an operator or ';'");
}

void SingularReader::ideal_declaration() {
    if (ideal_) scanner_.fail("one ideal");
    declared_name();
    ideal_.emplace();
    do {
        ideal_->push_back(polynomial());
    } while (scanner_.accept(TokenKind::comma));
    scanner_.require(TokenKind::semicolon, "an operator, ',' or ';'");
}

} // namespace

System read_singular_system(const base::SourceText& source, const SystemOverrides& overrides,
                            base::Run& run) {
    const std::string text = without_comments(source);
    return SingularReader(base::SourceText(text, source.name()), overrides, run).read();
}

} // namespace eliminant::algebra
