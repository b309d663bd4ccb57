// Texts of one statement a line.
#pragma once

#include "eliminant/base/run.hpp"
#include "eliminant/base/source_text.hpp"

#include <cstddef>
#include <functional>
#include <string_view>

namespace eliminant::implicit {

/// The first offset that is no blank, or the end.
std::size_t skip_blanks(const base::SourceText& text, std::size_t offset);
/// The end of the letters, digits and underscores from `offset` on.
std::size_t skip_word(const base::SourceText& text, std::size_t offset);
/// The word at the first offset that is no blank; empty if another character stands there.
std::string_view first_word(const base::SourceText& text);

/// Calls `read` with each line of a text that is not blank, without its comment, so that what is missing is
/// found missing at the `end of line`. A byte order mark is skipped.
/// \throws ParseError where bytes are not UTF-8; what `read` throws; Stopped
void for_each_line(const base::SourceText& source, base::Run& run,
                   const std::function<void(const base::SourceText& line)>& read);

} // namespace eliminant::implicit
