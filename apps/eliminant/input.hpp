/// \file
/// Where the text of a command comes from: a file, standard input, or the command line itself.
#pragma once

#include "eliminant/base/error.hpp"
#include "eliminant/base/run.hpp"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace eliminant::app {

/// A file could not be read or written.
class FileError : public Error {
  public:
    using Error::Error;
    /// `FILE: WHAT`, for instance `no such file`; the system's own words for an errno value.
    FileError(std::string_view file, std::string_view what);
    FileError(std::string_view file, int error_number);
};

/// What the operands of a command mean: one text, or expressions.
struct Input {
    /// A text to be parsed, and what to call it in messages: the file as it was given, `-`, `argument` if
    /// there is only one, or `argument 2`.
    struct Part {
        std::string name;
        std::string text;
    };
    bool is_expressions = false; ///< else it is one part, a file or standard input
    std::vector<Part> parts;
};

/// Reads what the operands mean.
///
/// A single operand is
/// 1. standard input, if it is `-`, or missing while standard input is no terminal;
/// 2. a file, if one of that name exists that is no directory;
/// 3. an expression, if `is_expression` says so;
/// 4. otherwise the name of a file that does not exist.
/// Each of several is an expression, and must look like one. Polls `run`.
/// \throws FileError, and UsageError if there is nothing to read
Input input_of(std::span<const std::string> operands,
               const std::function<bool(std::string_view)>& is_expression, Run& run);

/// Whether an argument can only be, or more probably is, a polynomial than the name of a missing file: it is
/// not a path as `dir/name`, and has no extension as `name.ext`.
bool looks_like_polynomial(std::string_view argument);

/// Whether an argument can only be, or is meant as, a line of a parametrization: it begins with `parameters`
/// and the like, or has a sign that formulas have and names of files have not.
bool looks_like_equation(std::string_view argument);

} // namespace eliminant::app
