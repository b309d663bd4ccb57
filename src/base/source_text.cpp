#include "eliminant/base/source_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace eliminant::base {

namespace {

constexpr std::size_t longest_quotation = 24; // characters of a word that a message repeats

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_'; }

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

std::string hexadecimal(unsigned value) {
    constexpr std::string_view digits = "0123456789abcdef";
    return {'0', 'x', digits[value >> 4U & 15U], digits[value & 15U]};
}

bool starts_with_byte_order_mark(std::string_view text) { return text.substr(0, 3) == "\xEF\xBB\xBF"; }

} // namespace

std::size_t utf8_length(std::string_view text) {
    if (text.empty()) return 0;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xC2 && lead < 0xE0   ? 2
                               : lead >= 0xE0 && lead < 0xF0 ? 3
                               : lead >= 0xF0 && lead < 0xF5 ? 4
                                                             : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if (!continues_character(text[i])) return 0;
    }
    const bool overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
    const bool surrogate = lead == 0xED && byte(1) >= 0xA0;
    const bool too_large = lead == 0xF4 && byte(1) >= 0x90;
    return overlong || surrogate || too_large ? 0 : length;
}

SourceText::SourceText(std::string_view text, std::string name)
    : whole_(text), size_(text.size()), name_(std::move(name)) {}

SourceText SourceText::section(std::size_t begin, std::size_t end) const {
    SourceText result = *this;
    result.begin_ += begin;
    result.size_ = end - begin;
    return result;
}

SourceLocation SourceText::locate(std::size_t offset) const {
    std::string_view before = whole_.substr(0, begin_ + offset);
    SourceLocation where{name_, 1, 1};
    where.line += static_cast<std::size_t>(std::ranges::count(before, '\n'));
    before.remove_prefix(before.rfind('\n') + 1); // npos + 1 is 0
    if (where.line == 1 && starts_with_byte_order_mark(before)) before.remove_prefix(3);
    where.column +=
        before.size() - static_cast<std::size_t>(std::ranges::count_if(before, continues_character));
    return where;
}

std::string_view SourceText::line_at(std::size_t offset) const {
    const std::size_t at = begin_ + offset;
    const std::size_t first = at == 0 ? 0 : whole_.rfind('\n', at - 1) + 1;
    std::string_view line = whole_.substr(first, std::min(whole_.find('\n', at), whole_.size()) - first);
    if (first == 0 && starts_with_byte_order_mark(line)) line.remove_prefix(3);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

std::string SourceText::describe(std::size_t offset) const {
    const std::string_view rest = whole_.substr(begin_ + offset);
    if (rest.empty()) return "end of text";
    const char c = rest.front();
    if (c == '\n' || c == '\r' || c == '#') return "end of line";
    if (c == '\0') return "a NUL byte";
    const std::size_t length = utf8_length(rest);
    if (length == 0) return "the byte " + hexadecimal(static_cast<unsigned char>(c)) + ", which is not UTF-8";
    if (length == 1 && (c < ' ' || c == '\x7f'))
        return "the control character " + hexadecimal(static_cast<unsigned char>(c));
    auto word_end = static_cast<std::size_t>(std::ranges::find_if_not(rest, is_word) - rest.begin());
    if (is_digit(c) && word_end + 1 < rest.size() && rest[word_end] == '.' && is_digit(rest[word_end + 1])) {
        ++word_end; // a decimal
        while (word_end < rest.size() && is_word(rest[word_end])) ++word_end;
    }
    const std::size_t quoted = is_word(c) ? std::min(word_end, longest_quotation) : length;
    std::string text = "'";
    text.append(rest.substr(0, quoted)).append(quoted < word_end ? "…'" : "'");
    return text;
}

void SourceText::fail(std::size_t offset, std::string expected) const {
    fail(offset, std::move(expected), describe(offset));
}

void SourceText::fail(std::size_t offset, std::string expected, std::string found) const {
    throw ParseError(locate(offset), std::move(expected), std::move(found), std::string(line_at(offset)));
}

void SourceText::check_encoding() const {
    const std::string_view section = text();
    std::size_t i = 0;
    while (i < section.size()) {
        std::uint64_t eight = 0;
        if (i + sizeof eight <= section.size()) {
            std::memcpy(&eight, section.data() + i, sizeof eight);
            // No byte has its top bit, and none is 0: subtracting 1 from each borrows into no top bit.
            if (((eight | (eight - 0x0101010101010101U)) & 0x8080808080808080U) == 0) {
                i += sizeof eight;
                continue;
            }
        }
        const std::size_t length = utf8_length(section.substr(i));
        if (length == 0 || section[i] == '\0') fail(i, "text in UTF-8");
        i += length;
    }
}

} // namespace eliminant::base
