#include "implicit/text_lines.hpp"

#include <algorithm>

namespace eliminant::implicit {

using base::SourceText;

namespace {

constexpr std::string_view blanks = " \t\r\f\v";

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

} // namespace

std::size_t skip_blanks(const SourceText& text, std::size_t offset) {
    return std::min(text.text().find_first_not_of(blanks, offset), text.size());
}

std::size_t skip_word(const SourceText& text, std::size_t offset) {
    while (offset < text.size() && is_word(text.text()[offset])) ++offset;
    return offset;
}

std::string_view first_word(const SourceText& text) {
    const std::size_t begin = skip_blanks(text, 0);
    return text.text().substr(begin, skip_word(text, begin) - begin);
}

void for_each_line(const SourceText& source, base::Run& run,
                   const std::function<void(const SourceText& line)>& read) {
    source.check_encoding();
    std::size_t begin = source.text().starts_with("\xEF\xBB\xBF") ? 3 : 0; // byte order mark
    while (begin < source.size()) {
        run.poll();
        const std::size_t end = std::min(source.text().find('\n', begin), source.size());
        const SourceText whole = source.section(begin, end);
        const SourceText line = whole.section(0, std::min(whole.text().find('#'), whole.size()));
        if (skip_blanks(line, 0) < line.size()) read(line);
        begin = end + 1;
    }
}

} // namespace eliminant::implicit
