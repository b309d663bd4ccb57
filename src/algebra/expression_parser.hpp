#pragma once

#include "eliminant/algebra/expression.hpp"

#include "scanner.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

namespace eliminant::algebra {

/// How the atoms of a formula are written.
enum class Dialect : std::uint8_t {
    eliminant,
    /// Singular: an atom may be a monomial `4/3x2y`, which a power then takes as a whole; no product is
    /// implied between tokens; 7/2 is a rational only as one token.
    singular,
};

/// Reads formulas by recursive descent; the grammar is in parse.hpp. Depth is bounded by
/// Expression::max_nesting.
class ExpressionParser {
  public:
    ExpressionParser(Scanner& scanner, const Vocabulary& vocabulary, Dialect dialect, base::Run& run)
        : scanner_(scanner), vocabulary_(vocabulary), dialect_(dialect), run_(run),
          result_(scanner.source()) {}

    /// Reads up to the first token that does not continue the sum.
    Expression parse_sum();
    /// The same for one product.
    Expression parse_product();

  private:
    using Kind = Expression::Kind;

    void sum();
    void product();
    bool signs();
    void factor();
    void atom();
    void nested(std::string_view expected);
    void call(const Token& name);
    void literal(const Token& token);
    void singular_monomial();
    void exponent();
    std::int64_t parenthesised_exponent();
    void push_power(std::int64_t exponent, std::size_t offset);

    void push(Kind kind, std::size_t offset, std::int64_t payload = 0) {
        result_.nodes_.push_back({kind, offset, payload, 0});
    }
    void push_name(std::string_view name, std::size_t offset);
    Expression take_result();
    bool is_constant_from(std::size_t first_node) const;
    bool at_product_by_juxtaposition() const {
        return scanner_.peek().kind == TokenKind::name || scanner_.peek().kind == TokenKind::left;
    }

    Scanner& scanner_;
    const Vocabulary& vocabulary_;
    Dialect dialect_;
    base::Run& run_;
    std::size_t nesting_ = 0;
    Expression result_;
    std::unordered_map<std::string, std::int64_t> name_indices_;
};

} // namespace eliminant::algebra
