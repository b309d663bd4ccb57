#include "common_options.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace eliminant::app {

namespace {

[[noreturn]] void fail(std::string_view expected, std::string_view found) {
    throw Error("expected " + std::string(expected) + ", found '" + std::string(found) + "'");
}

/// The number at the beginning of a text, without sign, and the text behind it; the text alone if there is
/// none.
std::pair<std::optional<double>, std::string_view> leading_number(std::string_view text) {
    double value = 0;
    const bool begins_well = !text.empty() && (text[0] == '.' || (text[0] >= '0' && text[0] <= '9'));
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (!begins_well || error != std::errc() || !std::isfinite(value)) return {std::nullopt, text};
    return {value, text.substr(static_cast<std::size_t>(end - text.data()))};
}

/// The factor that a suffix as `M`, `MB` or `MiB` stands for.
std::optional<double> memory_unit(std::string_view suffix) {
    if (suffix.empty() || suffix == "B") return 1;
    constexpr std::string_view letters = "KMGT";
    const char letter = suffix[0] >= 'a' ? static_cast<char>(suffix[0] - 'a' + 'A') : suffix[0];
    const std::size_t power = letters.find(letter);
    const std::string_view rest = suffix.substr(1);
    if (power == std::string_view::npos || !(rest.empty() || rest == "B" || rest == "iB"))
        return std::nullopt;
    return std::ldexp(1.0, 10 * static_cast<int>(power + 1));
}

} // namespace

std::uint64_t read_whole_number(std::string_view text, std::uint64_t least, std::uint64_t most) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value < least || value > most)
        fail("a whole number from " + std::to_string(least) + " to " + std::to_string(most), text);
    return value;
}

double read_seconds(std::string_view text) {
    const auto [value, rest] = leading_number(text);
    if (!value || !rest.empty()) fail("a number of seconds that is not negative", text);
    return *value;
}

std::uint64_t read_memory_size(std::string_view text) {
    constexpr double most = 0x1p62;
    const auto [value, suffix] = leading_number(text);
    const std::optional<double> unit = memory_unit(suffix);
    if (!value || !unit || *value * *unit > most) fail("a size as 2G, 512M or 1000000", text);
    return static_cast<std::uint64_t>(*value * *unit);
}

void CommonOptions::declare(OptionSet& options) {
    constexpr std::uint64_t most_threads = 4096;
    options.heading("Output");
    options.value("output", 'o', "FILE", "write the result to FILE, which appears complete or not at all",
                  [this](std::string_view text) {
                      if (text.empty()) fail("the name of a file", text);
                      output = text;
                  });
    options.choice<ResultFormat>("format", "how the result is written (default text)",
                                 {{"text", ResultFormat::text},
                                  {"json", ResultFormat::json},
                                  {"latex", ResultFormat::latex},
                                  {"singular", ResultFormat::singular},
                                  {"macaulay2", ResultFormat::macaulay2},
                                  {"sage", ResultFormat::sage},
                                  {"maple", ResultFormat::maple}},
                                 format);
    options.flag("quiet", 'q', "no live progress on the terminal", quiet);
    options.flag("verbose", 'v', "statistics on standard error", verbose);
    options.heading("Limits");
    options.value("threads", 0, "N", "use N threads (default: all cores)", [this](std::string_view text) {
        threads = static_cast<unsigned>(read_whole_number(text, 1, most_threads));
    });
    options.value("time-limit", 0, "SECONDS", "give up, with exit status 3, after so many seconds",
                  [this](std::string_view text) { time_limit_seconds = read_seconds(text); });
    options.value("memory-limit", 0, "SIZE",
                  "give up, with exit status 3, beyond so much memory, as 512M or 2G",
                  [this](std::string_view text) { memory_limit_bytes = read_memory_size(text); });
    options.value("seed", 0, "N", "start of every random choice (default 0)", [this](std::string_view text) {
        seed = read_whole_number(text, 0, std::numeric_limits<std::uint64_t>::max());
    });
    options.heading("Information");
    options.flag("help", 'h', "show this text", help);
    options.flag("version", 0, "show the version", version);
}

} // namespace eliminant::app
