/// \file
/// A text that is being read, and where in it one is: what every parser says when it does not understand.
#pragma once

#include "eliminant/base/error.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace eliminant::base {

/// A text, or a section of one, with a name for messages. Positions are byte offsets into the section;
/// messages count lines and characters from the beginning of the whole text, so a parser of one line of a
/// file reports the line of the file.
///
/// It refers to the text and does not own it: the text outlives it.
class SourceText {
  public:
    /// \param text what is read
    /// \param name file name, `-` for standard input, or a word such as `argument`
    SourceText(std::string_view text, std::string name = "argument");  // NOLINT(google-explicit-constructor)
    SourceText(const std::string& text, std::string name = "argument") // NOLINT(google-explicit-constructor)
        : SourceText(std::string_view(text), std::move(name)) {}
    SourceText(const char* text, std::string name = "argument") // NOLINT(google-explicit-constructor)
        : SourceText(std::string_view(text), std::move(name)) {}

    std::string_view text() const { return whole_.substr(begin_, size_); } ///< The section.
    const std::string& name() const { return name_; }                      ///< As given.
    std::size_t size() const { return size_; }                             ///< Bytes in the section.

    /// The part [begin, end) of this section; 0 ≤ begin ≤ end ≤ size().
    SourceText section(std::size_t begin, std::size_t end) const;

    /// Line and column of an offset in [0, size()]. Linear in what stands before it.
    SourceLocation locate(std::size_t offset) const;
    /// The whole line around an offset, without its line break.
    std::string_view line_at(std::size_t offset) const;
    /// What stands at an offset, for a message: a word or number in quotes, a character, `end of line`,
    /// `end of text`, `a NUL byte`.
    std::string describe(std::size_t offset) const;

    /// \throws ParseError always, at `offset`; what was found is describe(offset) unless said
    [[noreturn]] void fail(std::size_t offset, std::string expected) const;
    [[noreturn]] void fail(std::size_t offset, std::string expected, std::string found) const;

    /// \throws ParseError at the first NUL byte or the first byte that is not UTF-8. Linear.
    void check_encoding() const;

  private:
    std::string_view whole_;
    std::size_t begin_ = 0;
    std::size_t size_ = 0;
    std::string name_;
};

/// Number of bytes of the UTF-8 character at the beginning of text: 1 to 4, or 0 if there is none that is
/// well-formed (RFC 3629: no overlong forms, no surrogates, nothing above U+10FFFF).
std::size_t utf8_length(std::string_view text);

} // namespace eliminant::base

namespace eliminant {
using base::SourceText;
} // namespace eliminant
