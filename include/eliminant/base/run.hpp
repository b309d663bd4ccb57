/// \file
/// Control of long computations: cancellation, limits, progress, threads, randomness.
#pragma once

#include "eliminant/base/error.hpp"

#include <atomic>
#include <chrono>
#include <concepts>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace eliminant::base {

/// What a computation says about itself while it runs.
struct Progress {
    std::string_view phase = {}; ///< What is being done, as `reduction`; a string literal.
    std::uint64_t done = 0;      ///< Units finished.
    std::uint64_t total = 0;     ///< Units known so far, 0 if unknown; it may grow.
    std::string note = {};       ///< Anything else worth a glance, as `degree 7, 120 pairs`.
};

/// What the caller of a long computation may ask of it. All fields have a meaning without being set.
struct RunOptions {
    std::optional<double> time_limit_seconds = {}; ///< Wall-clock time from the construction of the Run.
    std::optional<std::uint64_t> memory_limit_bytes = {}; ///< Resident memory of the whole process.
    unsigned threads = 1;   ///< Worker threads; 0 is one for each hardware thread.
    std::uint64_t seed = 0; ///< Start of every random choice.
    /// Receives progress; called from whatever thread reports, never twice at once. It must not throw.
    std::function<void(const Progress&)> progress = {};
    /// Least time between two calls of `progress`; zero passes every report on.
    std::chrono::milliseconds progress_interval{100};
};

/// The handle of one long computation, passed by reference to everything that may take longer than 10 ms.
///
/// A computation ends early in exactly these ways, each a Stopped thrown from poll() in the computing
/// threads:
/// - `interrupted`: somebody called request_stop(), possibly from a signal handler or another thread;
/// - `time_limit`: `time_limit_seconds` passed since the Run was made;
/// - `memory_limit`: the resident memory of the process was seen above `memory_limit_bytes`. It is sampled
///   every few milliseconds, so a computation can exceed the limit by what it allocates between two samples,
///   or within one multiplication of huge integers, which cannot be interrupted.
///
/// The first reason wins and stays: a stopped Run is not reusable. Results finished before are unaffected.
///
/// Computations never read the clock. A watchdog thread keeps the limits and the pace of progress; it exists
/// only when one of them was asked for, and a poll() costs one relaxed atomic load either way.
class Run {
  public:
    Run();
    /// \throws DomainError if the time limit is negative or not a number, or if memory is limited on a system
    ///   that does not tell how much a process uses (no `/proc/self/statm`)
    explicit Run(RunOptions options);
    ~Run();
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    /// Asks the computation to stop. Safe in a signal handler and in any thread; returns at once.
    void request_stop(StopReason reason = StopReason::interrupted) noexcept {
        unsigned char expected = keep_going;
        stop_.compare_exchange_strong(expected, static_cast<unsigned char>(reason),
                                      std::memory_order_relaxed);
    }

    /// Returns at once unless a stop was requested. Call it at least every 10 ms.
    /// \throws Stopped with the first reason for which a stop was requested
    void poll() const {
        if (stop_.load(std::memory_order_relaxed) != keep_going) [[unlikely]]
            throw_stopped();
    }

    /// Why a stop was requested, if it was: for threads that must wind up instead of throwing.
    std::optional<StopReason> stop_reason() const noexcept;

    /// Passes progress on if anybody listens and the last report is old enough; else `describe` is not
    /// called. \param describe returns a Progress
    template <std::invocable F>
    requires std::convertible_to<std::invoke_result_t<F>, Progress>
    void report(F&& describe) {
        if (progress_due_.load(std::memory_order_relaxed)) [[unlikely]]
            deliver(std::forward<F>(describe)());
    }

    unsigned threads() const noexcept { return threads_; } ///< Worker threads to use, at least 1.
    std::uint64_t seed() const noexcept { return seed_; }  ///< Every random choice starts here.

  private:
    struct Sink;
    class Watchdog;
    static constexpr unsigned char keep_going = 0;

    [[noreturn, gnu::cold, gnu::noinline]] void throw_stopped() const;
    void deliver(const Progress& progress);

    std::atomic<unsigned char> stop_{keep_going};
    std::atomic<bool> progress_due_{false};
    unsigned threads_ = 1;
    std::uint64_t seed_ = 0;
    std::unique_ptr<Sink> sink_;         // null when nobody listens
    std::unique_ptr<Watchdog> watchdog_; // last, so that its thread ends before what it uses

    static_assert(std::atomic<unsigned char>::is_always_lock_free, "request_stop must be async-signal-safe");
};

} // namespace eliminant::base

namespace eliminant {
using base::Progress;
using base::Run;
using base::RunOptions;
} // namespace eliminant
