/// \file
/// The operands of the commands that take one parametrization.
#pragma once

#include "eliminant/base/run.hpp"
#include "eliminant/implicit/parametrization.hpp"

#include <span>
#include <string>

namespace eliminant::app {

/// A file, `-`, or statements, one an operand. \throws UsageError, FileError, ParseError, Stopped
Parametrization read_parametrization(std::span<const std::string> operands, Run& run);

} // namespace eliminant::app
