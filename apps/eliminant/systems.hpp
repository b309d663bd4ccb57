/// \file
/// Systems of polynomials from operands: the input of every command but `implicitize`.
#pragma once

#include "option_set.hpp"

#include "eliminant/algebra/system.hpp"
#include "eliminant/base/run.hpp"

#include <span>
#include <string>
#include <vector>

namespace eliminant::app {

/// How the input is to be read.
struct SystemOptions {
    SystemFormat format = SystemFormat::guess;
    SystemOverrides overrides;

    /// Adds `--order`, `--field`, `--variables` and `--input-format`. `*this` must outlive `options`.
    void declare(OptionSet& options);
};

/// The system that operands mean: one file, standard input, or a polynomial or equation each.
/// \throws ParseError, FileError, UsageError, Stopped
System read_system(std::span<const std::string> operands, const SystemOptions& options, Run& run);

/// Several systems in one ring. Its variables are those of the first system, then those that only later ones
/// have; its order is the one asked for, or that of the first system. \throws UsageError if the systems are
/// over different fields, and as read_system
std::vector<System> read_systems(std::span<const std::span<const std::string>> groups,
                                 const SystemOptions& options, Run& run);

} // namespace eliminant::app
