/// \file
/// One execution of a command: its limits, its interruption, and the place for its result.
#pragma once

#include "common_options.hpp"
#include "console.hpp"
#include "output.hpp"

#include "eliminant/base/run.hpp"

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace eliminant::app {

/// Exit statuses of the program.
enum ExitStatus : int {
    exit_done = 0,
    exit_negative = 1, ///< the question has a definite negative answer
    exit_usage = 2,    ///< bad usage, bad input, or a file that cannot be read or written
    exit_limit = 3,    ///< a limit of time or memory was reached
    exit_interrupted = 130,
};

/// Directs SIGINT and SIGTERM to a Run while it lives: the first asks the computation to stop, a second one
/// has its usual effect and ends the process at once. One at a time.
class InterruptGuard {
  public:
    explicit InterruptGuard(Run& run);
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
};

class Session {
  public:
    /// \throws FileError if the destination cannot be written
    Session(const CommonOptions& options, Console& console);

    Run& run() { return run_; }
    Console& console() { return console_; }
    ResultFormat format() const { return options_.format; }
    const std::string& output() const { return options_.output; } ///< empty or `-` for standard output
    unsigned threads() const { return run_.threads(); }
    double seconds() const; ///< since the session began

    /// A file for something besides the result. \throws UsageError if it is where the result goes, for one of
    /// them would be lost, FileError if it cannot be written
    Destination destination_beside_result(std::string_view option, const std::string& file) const;

    /// Writes the result, unless the run was stopped meanwhile.
    void write_result(std::string_view text);
    /// For a result that is written in parts.
    OutputStream open_result();
    /// What is still said when a limit was reached: in JSON that the result is incomplete, otherwise nothing.
    void write_incomplete(std::string_view reason);

  private:
    const CommonOptions& options_;
    Console& console_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    Destination destination_;
    Run run_;
    InterruptGuard interrupt_guard_;
};

/// Most memory that the process has had so far, in bytes.
std::uint64_t peak_memory();

/// Makes the process as the program wants it, once, first thing in main: failed writes are errors instead of
/// a signal, memory exhausted inside GMP is std::bad_alloc instead of an abort, and the standard descriptors
/// are taken, so that no file that is opened later becomes standard output.
void prepare_process();

} // namespace eliminant::app
