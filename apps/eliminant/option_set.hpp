/// \file
/// The options of a command, and the reading of a command line by them.
#pragma once

#include "eliminant/base/error.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace eliminant::app {

/// The command line is not one that the program understands.
class UsageError : public Error {
  public:
    using Error::Error;
    /// `SUBJECT: expected X, found Y`.
    UsageError(std::string_view subject, std::string_view expected, std::string_view found);
};

/// The words that an option accepts and what they stand for.
template <class T>
using Choices = std::vector<std::pair<std::string_view, T>>;

/// The options that a command accepts: CLI11 with the errors of this program and its operands.
///
/// Long options take their value as `--name VALUE` or `--name=VALUE`, short ones as `-o VALUE` or `-oVALUE`;
/// short flags combine, `--` ends the options, the last of several wins. Everything else is an operand, also
/// `-` and, since polynomials may begin with a minus, an argument as `-x^2+1` that is no option and contains
/// more than letters.
class OptionSet {
  public:
    using Setter = std::function<void(std::string_view)>;

    OptionSet();
    ~OptionSet();
    OptionSet(const OptionSet&) = delete;
    OptionSet& operator=(const OptionSet&) = delete;

    /// Options declared from here on are listed under this heading.
    void heading(std::string_view text) { heading_ = text; }
    /// Names are given without dashes; `short_name` 0 is none.
    void flag(std::string_view name, char short_name, std::string_view help, bool& target);
    /// `set` is called with the value, and may throw UsageError or another Error.
    void value(std::string_view name, char short_name, std::string argument, std::string_view help,
               Setter set);
    /// The same for an option that may be given several times and means all of them.
    void values(std::string_view name, std::string argument, std::string_view help, Setter set);
    template <class T>
    void choice(std::string_view name, std::string_view help, Choices<T> choices, T& target) {
        std::vector<std::string_view> words;
        for (const auto& entry : choices) words.push_back(entry.first);
        std::string argument = joined(words);
        value(name, 0, std::move(argument), help,
              [words = std::move(words), choices = std::move(choices), &target](std::string_view found) {
                  target = choices[index_of(found, words)].second;
              });
    }

    enum class Reading {
        all,        ///< options may stand anywhere among the operands
        to_command, ///< reading ends at the first operand, which with all that follows is returned as
                    ///< operands
    };
    /// Reads the arguments, sets what they ask for and returns the operands.
    /// \throws UsageError for an unknown option, or one with a bad or missing value
    std::vector<std::string> read(std::span<const std::string> arguments, Reading reading = Reading::all);

    /// The list of options for `--help`.
    std::string help() const;

  private:
    static std::string joined(std::span<const std::string_view> words);
    /// The position of the value among the words; throws UsageError with a suggestion.
    static std::size_t index_of(std::string_view found, std::span<const std::string_view> words);

    bool is_operand(std::string_view argument) const;
    [[noreturn]] void reject(std::string_view argument) const;
    void explain_mismatch(std::span<const std::string> arguments) const;
    /// What CLI11 did not take: operands, as they were given, and perhaps an unknown option.
    std::vector<std::string> operands(std::span<const std::string> remaining) const;

    std::string heading_;
    struct Parser; ///< CLI11's, kept out of this header, as it takes seconds to compile
    std::unique_ptr<Parser> app_;
};

} // namespace eliminant::app
