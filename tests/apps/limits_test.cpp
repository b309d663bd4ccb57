// How a computation is stopped and watched: limits, Ctrl-C, progress, statistics.
#include "program.hpp"

#include <nlohmann/json.hpp>

// GCC and Clang tell in different ways that a sanitizer is compiled in.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ELIMINANT_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ELIMINANT_SANITIZED
#endif
#endif

namespace eliminant::test {
namespace {

/// `groebner` on a system that takes hours, with these options before it.
std::vector<std::string> endless(std::vector<std::string> options) {
    options.insert(options.begin(), "groebner");
    options.insert(options.end(), endless_system().begin(), endless_system().end());
    return options;
}

void expect_incomplete(const ProcessResult& result, const std::string& reason) {
    EXPECT_EQ(result.status, 3);
    EXPECT_EQ(result.errors, "eliminant: " + reason + "\n");
    const nlohmann::json report = nlohmann::json::parse(result.output);
    EXPECT_EQ(report.at("complete"), false);
    EXPECT_EQ(report.at("reason"), reason);
    EXPECT_TRUE(report.at("seconds").is_number());
}

TEST(Limits, ReachedTimeLimitIsStatus3) {
    expect_error(run(endless({"--time-limit", "0.1"})), 3, "time limit reached");
    expect_error(run(endless({"--time-limit", "0"})), 3, "time limit reached");
    expect_error(run({"groebner", "x", "--time-limit", "0"}), 3, "time limit reached");
    expect_incomplete(run(endless({"--time-limit", "0.1", "--format", "json"})), "time limit reached");
}

TEST(Limits, TimeLimitHoldsWhileInputIsAwaited) {
    expect_error(run({"groebner", "--time-limit", "0.1"}, {.keep_input_open = true}), 3,
                 "time limit reached");
    const ScratchDirectory scratch;
    ASSERT_EQ(mkfifo(scratch.path("pipe").c_str(), 0600), 0);
    expect_error(run({"groebner", "--time-limit", "0.1", scratch.path("pipe")}), 3, "time limit reached");
}

TEST(Limits, ReachedMemoryLimitIsStatus3) {
    // One below the size of any process, and one that is reached on the way.
    expect_error(run({"groebner", "x", "--memory-limit", "100K"}), 3, "memory limit reached");
    expect_incomplete(run(endless({"--memory-limit", "100K", "--format", "json"})), "memory limit reached");
    // In the midst of matrices, modulo one prime and over QQ, on several threads.
    for (const char* field : {"GF(2147483647)", "QQ"})
        expect_error(
            run(endless({"--memory-limit", "60M", "--threads", "3", "--algorithm", "f4", "--field", field})),
            3, "memory limit reached");
#ifndef ELIMINANT_SANITIZED
    expect_error_with(run({"groebner", "--memory-limit", "20M", "(x+y+z+t+u+v+1)^30"}), 3, "memory");
#endif
}

TEST(Limits, ExhaustedMemoryIsStatus3) {
#ifdef ELIMINANT_SANITIZED
    GTEST_SKIP() << "sanitizers need more memory than there is here";
#endif
    // The system refuses memory: first to GMP, for a power of a large integer, then to ourselves.
    for (const std::string polynomial : {"(2^4000000*x+1)^12", "(x+y+z+t+u+v+1)^30"}) {
        const std::string script = "ulimit -v 30000; exec \"$0\" groebner --threads 1 \"$1\"";
        expect_error(run_process({"/bin/sh", "-c", script, ELIMINANT_PROGRAM, polynomial}), 3,
                     "memory exhausted");
    }
}

TEST(Limits, OneHugeRequestBeyondTheMemoryLimitIsStatus3) {
#ifdef ELIMINANT_SANITIZED
    GTEST_SKIP() << "the fence is off under sanitizers";
#endif
    expect_error_with(run({"groebner", "--memory-limit", "8M", "(2^4000000*x+1)^60"}), 3, "memory");
}

TEST(Limits, InterruptionIsStatus130) {
    for (const int number : {SIGINT, SIGTERM}) {
        // The first live line says that the computation is under way.
        const ProcessResult result =
            run(endless({}), {.terminal = true, .signals = {number}, .signal_after = " s "});
        EXPECT_EQ(result.status, 130);
        EXPECT_EQ(result.killed_by, 0);
        EXPECT_EQ(result.output, "");
        EXPECT_NE(result.errors.find("eliminant: interrupted"), std::string::npos);
    }
}

TEST(Limits, InterruptionLeavesNoFile) {
    const ScratchDirectory scratch;
    const ProcessResult result = run(endless({"-o", scratch.path("basis"), "--format", "json"}),
                                     {.terminal = true, .signals = {SIGINT}, .signal_after = " s "});
    EXPECT_EQ(result.status, 130);
    EXPECT_EQ(scratch.names(), std::vector<std::string>{});
}

TEST(Limits, WaitingForAReaderCanBeInterrupted) {
    const ScratchDirectory scratch;
    ASSERT_EQ(mkfifo(scratch.path("pipe").c_str(), 0600), 0);
    const std::string script = "\"$0\" groebner x -o \"$1\" & sleep 0.5; kill -TERM $!; wait $!";
    expect_error(run_process({"/bin/sh", "-c", script, ELIMINANT_PROGRAM, scratch.path("pipe")}), 130,
                 "interrupted");
}

TEST(Limits, WaitingForInputCanBeInterrupted) {
    // Reading begins as soon as the program does; the delay of the first signal leaves time for that.
    const std::string script = "\"$0\" groebner - <\"$1\" & sleep 0.5; kill -TERM $!; wait $!";
    const ScratchDirectory scratch;
    ASSERT_EQ(mkfifo(scratch.path("pipe").c_str(), 0600), 0);
    const std::string keep_open = "exec 3<>\"$1\"; " + script;
    const ProcessResult result =
        run_process({"/bin/sh", "-c", keep_open, ELIMINANT_PROGRAM, scratch.path("pipe")});
    expect_error(result, 130, "interrupted");
}

TEST(Limits, ProgressIsOneLiveLineOnATerminal) {
    const ProcessResult seen = run(endless({"--time-limit", "0.5"}), {.terminal = true});
    EXPECT_EQ(seen.status, 3);
    EXPECT_NE(seen.errors.find("\r\033[K"), std::string::npos);
    EXPECT_EQ(seen.errors.find('\n'), seen.errors.size() - 1); // only the message at the end keeps its line
    const ProcessResult quiet = run(endless({"--time-limit", "0.5", "--quiet"}), {.terminal = true});
    EXPECT_EQ(quiet.errors, "eliminant: time limit reached\r\n");
}

TEST(Limits, StatisticsAreForTheVerbose) {
    EXPECT_EQ(run({"groebner", "x^2-y", "y^2-x"}).errors, "");
    const ProcessResult result = run({"groebner", "-v", "x^2-y", "y^2-x"});
    EXPECT_NE(result.errors.find("pairs treated: "), std::string::npos);
    EXPECT_EQ(result.output, run({"groebner", "x^2-y", "y^2-x"}).output);
    // By F4 a line for each matrix, and what its columns are.
    const ProcessResult f4 =
        run({"groebner", "-v", "--field", "GF(101)", "--algorithm", "f4", "x^2*y-1", "x*y^2-x", "x+y+z-1"});
    EXPECT_NE(f4.errors.find("density: share of entries that are not 0"), std::string::npos);
    EXPECT_NE(f4.errors.find('%'), std::string::npos);
    EXPECT_NE(f4.errors.find("; matrices: "), std::string::npos);
}

} // namespace
} // namespace eliminant::test
