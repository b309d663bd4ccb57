#pragma once

#include "eliminant/base/source_text.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace eliminant::algebra {

enum class TokenKind : std::uint8_t {
    end,
    number,      ///< `12`, `0.25`, `.5`, `1.5e-3`; never signed
    name,        ///< a letter, then letters, digits and underscores
    superscript, ///< `²`, `⁻¹`, `¹²`
    plus,
    minus,
    times,
    divide,
    power, ///< `^` or `**`
    left,
    right,
    comma,
    semicolon,
    equals,
    other, ///< a character that begins no token
};

struct Token {
    TokenKind kind = TokenKind::end;
    std::size_t begin = 0; ///< byte offsets into the text
    std::size_t end = 0;
};

/// Splits a text into tokens, one of look-ahead.
///
/// Between tokens it skips blanks (also the no-break and other wide ones of Unicode), line breaks and
/// comments from
/// `#` to the end of the line. The signs that people paste from papers are tokens like their ASCII forms: −
/// and –, · ⋅ × and ∗, ∕ and ⁄, superscript digits. A byte order mark is skipped at the beginning of the
/// text.
class Scanner {
  public:
    explicit Scanner(const base::SourceText& source, std::size_t offset = 0);

    const base::SourceText& source() const { return source_; }
    const Token& peek() const { return next_; }
    /// Whether nothing stands between the end of the token before and peek().
    bool adjacent() const { return next_.begin == previous_end_; }
    Token take();
    /// Continues at an offset.
    void restart(std::size_t offset);
    /// Takes the next token if it is of that kind.
    bool accept(TokenKind kind);
    /// Takes the next token, which is of that kind, or throws ParseError with what was expected.
    Token require(TokenKind kind, std::string_view expected);
    std::string_view text_of(const Token& token) const {
        return text_.substr(token.begin, token.end - token.begin);
    }

    [[noreturn]] void fail(std::string expected) const { source_.fail(next_.begin, std::move(expected)); }

  private:
    void advance();
    void skip_blanks();
    std::size_t number_end(std::size_t i) const;

    base::SourceText source_;
    std::string_view text_;
    std::size_t position_;
    std::size_t previous_end_;
    Token next_;
};

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
constexpr bool continues_name(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

/// The ASCII text of a superscript token: `⁻¹²` becomes `-12`.
std::string superscript_text(std::string_view token);

} // namespace eliminant::algebra
