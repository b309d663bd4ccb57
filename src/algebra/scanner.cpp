#include "scanner.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace eliminant::algebra {

namespace {

using base::SourceText;

struct Sign {
    std::string_view utf8;
    TokenKind kind;
};
constexpr std::array signs = {
    Sign{"\u2212", TokenKind::minus},  // minus sign
    Sign{"\u2013", TokenKind::minus},  // en dash, what PDF readers copy for a minus
    Sign{"\u00B7", TokenKind::times},  // middle dot
    Sign{"\u22C5", TokenKind::times},  // dot operator
    Sign{"\u00D7", TokenKind::times},  // multiplication sign
    Sign{"\u2217", TokenKind::times},  // asterisk operator
    Sign{"\u2215", TokenKind::divide}, // division slash
    Sign{"\u2044", TokenKind::divide}, // fraction slash
};

constexpr std::array<std::string_view, 12> superscripts = {"\u2070", "\u00B9", "\u00B2", "\u00B3",
                                                           "\u2074", "\u2075", "\u2076", "\u2077",
                                                           "\u2078", "\u2079", "\u207A", "\u207B"};
constexpr std::string_view superscript_meaning = "0123456789+-";

/// Index into superscripts of the character at the beginning of text, or their number.
std::size_t superscript_at(std::string_view text) {
    const auto starts = [text](std::string_view s) { return text.starts_with(s); };
    return static_cast<std::size_t>(std::ranges::find_if(superscripts, starts) - superscripts.begin());
}

/// Bytes of the blank at the beginning of text, 0 if there is none.
std::size_t blank_length(std::string_view text) {
    const char c = text.empty() ? 'x' : text.front();
    if (c == ' ' || (c >= '\t' && c <= '\r')) return 1;
    if (text.starts_with("\u00A0")) return 2; // no-break space
    if (text.starts_with("\u202F") || text.starts_with("\u205F") || text.starts_with("\u3000")) return 3;
    if (text.size() >= 3 && text.starts_with("\xE2\x80") && static_cast<unsigned char>(text[2]) <= 0x8A)
        return 3; // U+2000 … U+200A, spaces of all widths
    return 0;
}

TokenKind ascii_kind(char c) {
    switch (c) {
    case '+':
        return TokenKind::plus;
    case '-':
        return TokenKind::minus;
    case '*':
        return TokenKind::times;
    case '/':
        return TokenKind::divide;
    case '^':
        return TokenKind::power;
    case '(':
        return TokenKind::left;
    case ')':
        return TokenKind::right;
    case ',':
        return TokenKind::comma;
    case ';':
        return TokenKind::semicolon;
    case '=':
        return TokenKind::equals;
    default:
        return TokenKind::other;
    }
}

} // namespace

Scanner::Scanner(const SourceText& source, std::size_t offset)
    : source_(source), text_(source_.text()), position_(0), previous_end_(0) {
    restart(offset == 0 && text_.starts_with("\uFEFF") ? 3 : offset);
}

Token Scanner::take() {
    const Token token = next_;
    advance();
    return token;
}

void Scanner::restart(std::size_t offset) {
    position_ = offset;
    next_ = {TokenKind::end, offset, offset};
    advance();
}

bool Scanner::accept(TokenKind kind) {
    if (next_.kind != kind) return false;
    advance();
    return true;
}

Token Scanner::require(TokenKind kind, std::string_view expected) {
    if (next_.kind != kind) fail(std::string(expected));
    return take();
}

void Scanner::skip_blanks() {
    while (position_ < text_.size()) {
        if (text_[position_] == '#') {
            position_ = std::min(text_.find('\n', position_), text_.size());
            continue;
        }
        const std::size_t length = blank_length(text_.substr(position_));
        if (length == 0) return;
        position_ += length;
    }
}

/// End of the number that begins at i with a digit, or with a point before a digit. An `e` belongs to it only
/// when digits follow, with or without a sign: 2e-3 is a decimal, 2e and 2ex are products.
std::size_t Scanner::number_end(std::size_t i) const {
    const auto at = [this](std::size_t k) { return k < text_.size() ? text_[k] : '\0'; };
    while (is_digit(at(i))) ++i;
    if (at(i) == '.' && is_digit(at(i + 1))) {
        ++i;
        while (is_digit(at(i))) ++i;
    }
    if (at(i) == 'e' || at(i) == 'E') {
        const std::size_t digits = i + (at(i + 1) == '+' || at(i + 1) == '-' ? 2 : 1);
        if (is_digit(at(digits))) {
            i = digits;
            while (is_digit(at(i))) ++i;
        }
    }
    return i;
}

void Scanner::advance() {
    previous_end_ = next_.end;
    skip_blanks();
    const std::size_t begin = position_;
    const std::string_view rest = text_.substr(begin);
    const auto finish = [&](TokenKind kind, std::size_t length) {
        position_ = begin + length;
        next_ = {kind, begin, position_};
    };
    if (rest.empty()) return finish(TokenKind::end, 0);
    const char c = rest.front();
    if (is_digit(c) || (c == '.' && rest.size() > 1 && is_digit(rest[1])))
        return finish(TokenKind::number, number_end(begin) - begin);
    if (is_letter(c)) {
        const auto stop = std::ranges::find_if_not(rest, continues_name);
        return finish(TokenKind::name, static_cast<std::size_t>(stop - rest.begin()));
    }
    if (rest.starts_with("**")) return finish(TokenKind::power, 2);
    if (static_cast<unsigned char>(c) < 0x80) return finish(ascii_kind(c), 1);
    for (const Sign& sign : signs) {
        if (rest.starts_with(sign.utf8)) return finish(sign.kind, sign.utf8.size());
    }
    std::size_t length = 0;
    for (std::size_t i = superscript_at(rest); i < superscripts.size();
         i = superscript_at(rest.substr(length)))
        length += superscripts[i].size();
    if (length != 0) return finish(TokenKind::superscript, length);
    finish(TokenKind::other, std::max<std::size_t>(1, base::utf8_length(rest)));
}

std::string superscript_text(std::string_view token) {
    std::string result;
    while (!token.empty()) {
        const std::size_t i = superscript_at(token);
        result += superscript_meaning[i];
        token.remove_prefix(superscripts[i].size());
    }
    return result;
}

} // namespace eliminant::algebra
