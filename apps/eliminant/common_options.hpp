/// \file
/// The options that every command has.
#pragma once

#include "option_set.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace eliminant::app {

/// How a result is written.
enum class ResultFormat { text, json, latex, singular, macaulay2, sage, maple };

struct CommonOptions {
    std::string output; ///< empty for standard output
    ResultFormat format = ResultFormat::text;
    unsigned threads = 0; ///< 0 for all cores
    std::optional<double> time_limit_seconds = {};
    std::optional<std::uint64_t> memory_limit_bytes = {};
    std::uint64_t seed = 0;
    bool quiet = false;
    bool verbose = false;
    bool help = false;
    bool version = false;

    /// Adds them to the options of a command. `*this` must outlive `options`.
    void declare(OptionSet& options);
};

/// A whole number of [least, most] in decimal digits. \throws Error `expected …, found …`
std::uint64_t read_whole_number(std::string_view text, std::uint64_t least, std::uint64_t most);

/// A number of seconds ≥ 0, as `10`, `0.5`, `1e3`. \throws Error
double read_seconds(std::string_view text);

/// A number of bytes, as `4096`, `512M`, `1.5G`: K, M, G and T are powers of 1024. \throws Error
std::uint64_t read_memory_size(std::string_view text);

} // namespace eliminant::app
