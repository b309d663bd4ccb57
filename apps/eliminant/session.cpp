#include "session.hpp"

#include "option_set.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <system_error>

#include <fcntl.h>
#include <gmp.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <unistd.h>

// GCC and Clang tell in different ways that a sanitizer is compiled in.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ELIMINANT_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ELIMINANT_SANITIZED
#endif
#endif

namespace eliminant::app {

namespace {

std::atomic<Run*> interrupted_run = nullptr;
static_assert(std::atomic<Run*>::is_always_lock_free, "it is read in a signal handler");

extern "C" void request_stop_on_signal(int signal_number) {
    if (Run* run = interrupted_run.load()) run->request_stop(StopReason::interrupted);
    // The other of the two signals, too, is a second one now.
    signal(signal_number == SIGINT ? SIGTERM : SIGINT, SIG_DFL);
}

void on_signal(int signal_number, void (*handler)(int), int flags) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    sigaction(signal_number, &action, nullptr);
}

void* checked(void* block) {
    if (block == nullptr) throw std::bad_alloc();
    return block;
}
void* allocate(std::size_t size) { return checked(std::malloc(size)); }
void* reallocate(void* block, std::size_t, std::size_t size) { return checked(std::realloc(block, size)); }
void release(void* block, std::size_t) { std::free(block); }

/// A second fence around the limit that the Run samples: one huge request, as for the power of a large
/// integer, fails at once with std::bad_alloc. It counts what is reserved, not what is used, hence the
/// allowance.
void fence_memory([[maybe_unused]] std::uint64_t limit, [[maybe_unused]] unsigned threads) {
#ifndef ELIMINANT_SANITIZED // their shadow memory counts as well
    constexpr std::uint64_t process = 64 << 20;
    constexpr std::uint64_t stack = 8 << 20;
    const std::uint64_t fence = limit + limit / 2 + process + threads * stack;
    rlimit current{};
    if (getrlimit(RLIMIT_DATA, &current) != 0) return;
    current.rlim_cur = std::min<rlim_t>(fence, current.rlim_max);
    setrlimit(RLIMIT_DATA, &current);
#endif
}

RunOptions run_options(const CommonOptions& options, Console& console) {
    RunOptions result;
    result.threads = options.threads;
    result.time_limit_seconds = options.time_limit_seconds;
    result.memory_limit_bytes = options.memory_limit_bytes;
    result.seed = options.seed;
    if (console.is_terminal() && !options.quiet)
        result.progress = [&console](const Progress& progress) { console.show(progress); };
    return result;
}

} // namespace

InterruptGuard::InterruptGuard(Run& run) {
    interrupted_run = &run;
    // No SA_RESTART: a read that waits for a user must end. SA_RESETHAND: the second signal ends the process.
    for (const int signal_number : {SIGINT, SIGTERM})
        on_signal(signal_number, request_stop_on_signal, static_cast<int>(SA_RESETHAND));
}

InterruptGuard::~InterruptGuard() {
    for (const int signal_number : {SIGINT, SIGTERM}) on_signal(signal_number, SIG_DFL, 0);
    interrupted_run = nullptr;
}

namespace {

bool is_standard_output(const std::string& file) {
    return file.empty() || file == "-" || file == "/dev/stdout";
}

/// Whether what is written to one of two destinations would be mixed with the other, or replaced by it.
bool are_one_place(const std::string& a, const std::string& b) {
    const auto path = [](const std::string& file) {
        return std::filesystem::path(is_standard_output(file) ? "/dev/stdout" : file);
    };
    if (is_standard_output(a) && is_standard_output(b)) return true;
    std::error_code ignored;
    if (std::filesystem::is_character_file(path(a), ignored)) return false; // /dev/null takes both
    return std::filesystem::equivalent(path(a), path(b), ignored) ||
           std::filesystem::weakly_canonical(path(a), ignored) ==
               std::filesystem::weakly_canonical(path(b), ignored);
}

} // namespace

Session::Session(const CommonOptions& options, Console& console)
    : options_(options), console_(console), destination_(options.output), run_(run_options(options, console)),
      interrupt_guard_(run_) {
    // What is over before it begins does not depend on how soon the watchdog of the run looks for the first
    // time.
    if (options.time_limit_seconds == 0.0) run_.request_stop(StopReason::time_limit);
    if (!options.memory_limit_bytes) return;
    if (peak_memory() > *options.memory_limit_bytes) run_.request_stop(StopReason::memory_limit);
    fence_memory(*options.memory_limit_bytes, run_.threads());
}

double Session::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

Destination Session::destination_beside_result(std::string_view option, const std::string& file) const {
    if (are_one_place(file, output()))
        throw UsageError(option, "another place than that of the result",
                         is_standard_output(file) ? "standard output" : "'" + file + "'");
    return Destination(file);
}

void Session::write_result(std::string_view text) {
    run_.poll();
    console_.clear_progress();
    destination_.write(text, run_);
}

OutputStream Session::open_result() { return destination_.open(run_); }

void Session::write_incomplete(std::string_view reason) {
    if (options_.format != ResultFormat::json) return;
    Run unlimited; // the own one has been stopped
    const nlohmann::ordered_json report{{"complete", false}, {"reason", reason}, {"seconds", seconds()}};
    destination_.write(report.dump() + "\n", unlimited);
}

std::uint64_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) << 10; // Linux counts in KiB
}

void prepare_process() {
    signal(SIGPIPE, SIG_IGN);
    mp_set_memory_functions(allocate, reallocate, release);
    // Opened for reading, so that writing to a standard output that the caller closed still fails.
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) open("/dev/null", O_RDONLY);
}

} // namespace eliminant::app
