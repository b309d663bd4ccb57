/// \file
/// What the program says on standard error: messages of one line each, and on a terminal a live line of
/// progress.
#pragma once

#include "eliminant/base/error.hpp"
#include "eliminant/base/run.hpp"

#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace eliminant::app {

/// Standard error. Its functions may be called from any thread; none of them throws for what it is told.
///
/// Bytes of the user's text that could steer a terminal are shown as `\xHH`.
class Console {
  public:
    Console();

    void set_verbose(bool verbose) { verbose_ = verbose; }
    bool is_verbose() const { return verbose_; }
    bool is_terminal() const { return terminal_; }

    /// `eliminant: MESSAGE`.
    void error(std::string_view message);
    /// The same; on a terminal with the offending line and a caret under the first character that does not
    /// fit.
    void error(const ParseError& error);
    /// `eliminant: warning: MESSAGE`.
    void warning(std::string_view message);
    /// A line of statistics, said only with --verbose.
    void detail(std::string_view line);

    /// From now on the live line also says how long the rest will take: for work whose units are about equal.
    void expect_steady_progress();
    /// Replaces the live line.
    void show(const Progress& progress);
    /// Takes the live line off the screen, as everything else that is said does by itself.
    void clear_progress();

  private:
    void say(const std::string& text);
    void erase_live_line();

    const bool terminal_;
    bool verbose_ = false;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::mutex mutex_;
    bool live_line_ = false;                                                 // guarded by mutex_
    std::optional<std::chrono::steady_clock::time_point> steady_since_ = {}; // guarded by mutex_
};

/// Text on one line that leaves a terminal as it was: control characters and bytes that are no UTF-8 as
/// `\xHH`.
std::string printable(std::string_view text);

/// The part of a line around a column (1-based, in characters) that fits `width`, and below it a caret.
std::string excerpt(std::string_view line, std::size_t column, std::size_t width);

} // namespace eliminant::app
