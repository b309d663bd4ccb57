#include "eliminant/base/run.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <limits>
#include <thread>
#include <vector>

#include <unistd.h>

namespace eliminant {
namespace {

// Inside a TEST the plain word Run is a member of GoogleTest's base class, hence eliminant::Run below.

/// Polls until stopped, as a computation without end would; returns the reason.
StopReason spin(Run& run) {
    try {
        for (;;) {
            run.poll();
            std::this_thread::yield();
        }
    } catch (const Stopped& stopped) {
        return stopped.reason();
    }
}

TEST(RunTest, WithoutOptionsNeverStopsAndIgnoresReports) {
    eliminant::Run run;
    EXPECT_NO_THROW(run.poll());
    EXPECT_EQ(run.stop_reason(), std::nullopt);
    EXPECT_EQ(run.threads(), 1U);
    EXPECT_EQ(run.seed(), 0U);
    run.report([]() -> Progress {
        ADD_FAILURE() << "a report was composed that nobody reads";
        return {};
    });
}

TEST(RunTest, StopsWithTheReasonAskedForAndStaysStopped) {
    eliminant::Run run;
    run.request_stop(StopReason::memory_limit);
    EXPECT_EQ(spin(run), StopReason::memory_limit);
    EXPECT_EQ(spin(run), StopReason::memory_limit);
    EXPECT_EQ(run.stop_reason(), StopReason::memory_limit);
}

TEST(RunTest, KeepsTheFirstReason) {
    eliminant::Run run;
    run.request_stop();
    run.request_stop(StopReason::time_limit);
    EXPECT_EQ(spin(run), StopReason::interrupted);
}

TEST(RunTest, IsStoppedFromAnotherThread) {
    eliminant::Run run;
    std::atomic<bool> started = false;
    std::thread other([&] {
        started.wait(false);
        run.request_stop();
    });
    started = true;
    started.notify_one();
    EXPECT_EQ(spin(run), StopReason::interrupted);
    other.join();
}

TEST(RunTest, StopsEveryThreadThatPolls) {
    eliminant::Run run;
    std::vector<StopReason> reasons(4, StopReason::time_limit);
    std::vector<std::thread> workers;
    for (StopReason& reason : reasons) workers.emplace_back([&] { reason = spin(run); });
    run.request_stop();
    for (std::thread& worker : workers) worker.join();
    EXPECT_EQ(reasons, std::vector(4, StopReason::interrupted));
}

Run* interrupted_run = nullptr; // what a program with a Ctrl-C handler has

TEST(RunTest, IsStoppedFromASignalHandler) {
    eliminant::Run run;
    interrupted_run = &run;
    const auto previous = std::signal(SIGINT, [](int) { interrupted_run->request_stop(); });
    ASSERT_EQ(std::raise(SIGINT), 0);
    EXPECT_EQ(spin(run), StopReason::interrupted);
    std::signal(SIGINT, previous);
}

TEST(RunTest, KeepsItsTimeLimit) {
    for (const double seconds : {0.0, 1e-9, 0.02}) {
        const auto start = std::chrono::steady_clock::now();
        eliminant::Run run({.time_limit_seconds = seconds});
        EXPECT_EQ(spin(run), StopReason::time_limit);
        EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::duration<double>(seconds));
    }
}

TEST(RunTest, AcceptsTimeLimitsBeyondTheEndOfTime) {
    for (const double seconds : {1e9, 1e30, std::numeric_limits<double>::infinity()}) {
        eliminant::Run run({.time_limit_seconds = seconds});
        EXPECT_NO_THROW(run.poll());
    }
}

TEST(RunTest, KeepsItsMemoryLimit) {
    eliminant::Run run({.memory_limit_bytes = 1}); // every process is larger
    EXPECT_EQ(spin(run), StopReason::memory_limit);
}

TEST(RunTest, SeesMemoryGrow) {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages >> pages; // the second number is what is resident
    ASSERT_GT(pages, 0U);
    constexpr std::uint64_t megabyte = 1U << 20;
    eliminant::Run run(
        {.memory_limit_bytes = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) + 64 * megabyte});
    std::this_thread::sleep_for(std::chrono::milliseconds(20)); // several samples
    EXPECT_NO_THROW(run.poll());
    const std::vector<char> block(128 * megabyte, 1);
    EXPECT_EQ(spin(run), StopReason::memory_limit);
    EXPECT_EQ(block.back(), 1);
}

TEST(RunTest, EndsAtOnceWhenTheWorkEndsBeforeItsLimits) {
    for (int i = 0; i < 100; ++i)
        eliminant::Run run(
            {.time_limit_seconds = 1e6, .memory_limit_bytes = std::numeric_limits<std::uint64_t>::max()});
}

TEST(RunTest, RejectsTimeLimitsWithoutMeaning) {
    for (const double seconds : {-1.0, -1e-300, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW(eliminant::Run({.time_limit_seconds = seconds}), DomainError);
}

TEST(RunTest, CountsItsThreads) {
    EXPECT_EQ(eliminant::Run({.threads = 3}).threads(), 3U);
    EXPECT_GE(eliminant::Run({.threads = 0}).threads(), 1U);
    EXPECT_EQ(eliminant::Run({.seed = 99}).seed(), 99U);
}

TEST(RunTest, PassesEveryReportOnWhenTheIntervalIsZero) {
    std::vector<std::string> seen;
    eliminant::Run run({.progress =
                            [&](const Progress& p) {
                                seen.push_back(std::string(p.phase) + ' ' + std::to_string(p.done) + '/' +
                                               std::to_string(p.total) + ' ' + p.note);
                            },
                        .progress_interval = std::chrono::milliseconds(0)});
    for (std::uint64_t i = 1; i <= 3; ++i)
        run.report([&] { return Progress{.phase = "reduction", .done = i, .total = 3, .note = "degree 2"}; });
    EXPECT_EQ(seen, (std::vector<std::string>{"reduction 1/3 degree 2", "reduction 2/3 degree 2",
                                              "reduction 3/3 degree 2"}));
}

TEST(RunTest, PacesReports) {
    std::atomic<int> calls = 0;
    eliminant::Run run(
        {.progress = [&](const Progress&) { ++calls; }, .progress_interval = std::chrono::hours(1)});
    for (int i = 0; i < 1000; ++i) run.report([] { return Progress{.phase = "reduction"}; });
    EXPECT_EQ(calls, 0);
}

TEST(RunTest, ReportsAgainAfterTheInterval) {
    std::atomic<int> calls = 0;
    eliminant::Run run(
        {.progress = [&](const Progress&) { ++calls; }, .progress_interval = std::chrono::milliseconds(2)});
    while (calls < 3) run.report([] { return Progress{.phase = "reduction"}; });
    EXPECT_GE(calls, 3);
}

TEST(RunTest, NeverCallsTheSinkTwiceAtOnce) {
    std::atomic<int> inside = 0;
    std::atomic<bool> overlapped = false;
    int calls = 0; // unguarded on purpose: the thread sanitizer sees two calls at once
    eliminant::Run run({.progress =
                            [&](const Progress&) {
                                if (++inside != 1) overlapped = true;
                                ++calls;
                                --inside;
                            },
                        .progress_interval = std::chrono::milliseconds(0)});
    std::vector<std::thread> workers;
    for (int t = 0; t < 4; ++t)
        workers.emplace_back([&] {
            for (int i = 0; i < 1000; ++i) run.report([] { return Progress{.phase = "primes"}; });
        });
    for (std::thread& worker : workers) worker.join();
    EXPECT_FALSE(overlapped);
    EXPECT_EQ(calls, 4000);
}

} // namespace
} // namespace eliminant
