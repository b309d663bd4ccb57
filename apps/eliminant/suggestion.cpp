#include "suggestion.hpp"

#include <algorithm>
#include <vector>

namespace eliminant::app {

namespace {

/// Fewest insertions, deletions, substitutions and swaps of neighbours from a to b, no character edited twice
/// ("optimal string alignment", which suffices for typing errors).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t substituted = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, substituted});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

} // namespace

std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> candidates) {
    // A pasted text is no misspelled word, and next to one letter are all the others.
    constexpr std::size_t shortest = 2;
    constexpr std::size_t longest = 64;
    if (word.size() < shortest || word.size() > longest) return std::nullopt;

    std::optional<std::string_view> best;
    std::size_t best_distance = 1 + word.size() / 3;
    for (const std::string_view candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance > best_distance || (best && distance == best_distance)) continue;
        best = candidate;
        best_distance = distance;
    }
    if (best) return best;

    for (const std::string_view candidate : candidates) {
        if (!candidate.starts_with(word)) continue;
        if (best) return std::nullopt;
        best = candidate;
    }
    return best;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates) {
    const std::optional<std::string_view> meant = nearest(word, candidates);
    return meant ? "; did you mean '" + std::string(*meant) + "'?" : std::string();
}

std::string either(std::span<const std::string_view> words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
        text += words[i];
    }
    return text;
}

} // namespace eliminant::app
