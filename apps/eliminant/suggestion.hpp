/// \file
/// "Did you mean …?"
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace eliminant::app {

/// The candidate that `word` was most probably meant to be: the nearest one by number of single-character
/// edits and swaps of neighbours, if they are few for its length, or the only one that begins with `word`.
std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> candidates);

/// `; did you mean 'CANDIDATE'?`, or nothing; to be appended to a message.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

/// `a, b or c`.
std::string either(std::span<const std::string_view> words);

} // namespace eliminant::app
