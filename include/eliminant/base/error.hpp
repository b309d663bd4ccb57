/// \file
/// The errors of the library. Each says what was being done, what was expected and what was found.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace eliminant::base {

/// Root of every exception that the library throws on purpose. `what()` is one line that can be shown to a
/// user. (Exhausted memory stays `std::bad_alloc`.)
class Error : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A place in a text that was read.
struct SourceLocation {
    std::string source;     ///< File name, `-` for standard input, or a word such as `argument`.
    std::size_t line = 1;   ///< 1-based.
    std::size_t column = 1; ///< 1-based, in characters (Unicode code points), not bytes.
};

/// Text that is not what it should be. `what()` is `SOURCE:LINE:COLUMN: expected X, found Y`.
class ParseError : public Error {
  public:
    /// \param where the first character that does not fit
    /// \param expected what could have stood there, with its article: `an exponent`
    /// \param found what stands there: `'x'`, `end of line`
    /// \param line_text the whole offending line without its line break, so that a caret can point into it
    ParseError(SourceLocation where, std::string expected, std::string found, std::string line_text);

    const SourceLocation& where() const { return where_; }      ///< Where the text stops making sense.
    const std::string& expected() const { return expected_; }   ///< What could have stood there.
    const std::string& found() const { return found_; }         ///< What stands there instead.
    const std::string& line_text() const { return line_text_; } ///< The whole line, without its line break.

  private:
    SourceLocation where_;
    std::string expected_;
    std::string found_;
    std::string line_text_;
};

/// Two operands of different rings met in one operation; the message prints both rings.
class RingMismatchError : public Error {
  public:
    using Error::Error;
};

/// An exponent or degree does not fit the machine word that holds it.
class OverflowError : public Error {
  public:
    using Error::Error;
};

/// An argument outside the domain of the operation: division by zero, an element without inverse, an order
/// that is not admissible. The message gives the reason.
class DomainError : public Error {
  public:
    using Error::Error;
};

/// Why a computation ended before its result.
enum class StopReason : unsigned char {
    interrupted = 1, ///< The caller asked for it: Ctrl-C, a closed window.
    time_limit,      ///< The time limit of the Run passed.
    memory_limit,    ///< The process outgrew the memory limit of the Run.
};

/// The reason in words: `interrupted`, `time limit reached`, `memory limit reached`.
std::string_view to_string(StopReason reason);

/// Thrown by Run::poll once the Run was told to stop. The objects of the unfinished operation are destroyed
/// or as they were before; nothing else is affected, and the same operation can be asked again with another
/// Run.
class Stopped : public Error {
  public:
    explicit Stopped(StopReason reason);

    StopReason reason() const { return reason_; } ///< Why.

  private:
    StopReason reason_;
};

} // namespace eliminant::base

namespace eliminant {
using base::DomainError;
using base::Error;
using base::OverflowError;
using base::ParseError;
using base::RingMismatchError;
using base::SourceLocation;
using base::Stopped;
using base::StopReason;
} // namespace eliminant
