#include "eliminant/base/run.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace eliminant::base {

namespace {

using Clock = std::chrono::steady_clock;

/// How often memory is looked at. A process that writes fresh pages at 4 GB/s outgrows its limit
/// by 20 MB meanwhile; one look costs about 5 µs.
constexpr std::chrono::milliseconds memory_sampling_interval{5};

/// Resident memory of this process in bytes; nothing where the system does not tell. Allocates nothing: it is
/// asked when memory is short.
std::optional<std::uint64_t> resident_memory() {
    const int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    if (file < 0) return std::nullopt;
    std::array<char, 128> text{}; // "SIZE RESIDENT SHARED …", all in pages
    const ssize_t length = read(file, text.data(), text.size());
    close(file);
    const char* const end = text.data() + std::max<ssize_t>(length, 0);
    const char* const space = std::find<const char*>(text.data(), end, ' ');
    std::uint64_t pages = 0;
    if (space == end || std::from_chars(space + 1, end, pages).ec != std::errc{}) return std::nullopt;
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// The moment `seconds` after `start`. A century stands for no limit: later moments overflow the clock.
Clock::time_point deadline_after(Clock::time_point start, std::optional<double> seconds) {
    constexpr double century = 3e9;
    const std::chrono::duration<double> wait(std::min(seconds.value_or(century), century));
    return start + std::chrono::duration_cast<Clock::duration>(wait);
}

} // namespace

struct Run::Sink {
    Sink(std::function<void(const Progress&)> function, std::chrono::milliseconds least_interval)
        : call(std::move(function)), interval(least_interval) {}

    const std::function<void(const Progress&)> call;
    const std::chrono::milliseconds interval;
    std::mutex mutex; // one report at a time
};

/// The thread that keeps the limits of one Run and paces its progress.
class Run::Watchdog {
  public:
    Watchdog(Run& run, const RunOptions& options, Clock::time_point start)
        : run_(run), deadline_(deadline_after(start, options.time_limit_seconds)),
          memory_limit_(options.memory_limit_bytes),
          progress_interval_(run.sink_ ? run.sink_->interval : std::chrono::milliseconds::zero()),
          thread_([this] { watch(); }) {}

    ~Watchdog() {
        {
            const std::lock_guard lock(mutex_);
            finished_ = true;
        }
        wake_.notify_one();
        thread_.join();
    }

    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

  private:
    void watch() {
        Clock::time_point next_progress = Clock::now() + progress_interval_;
        std::unique_lock lock(mutex_);
        while (!finished_) {
            const Clock::time_point now = Clock::now();
            if (now >= deadline_) run_.request_stop(StopReason::time_limit);
            if (memory_limit_ && resident_memory().value_or(0) > *memory_limit_)
                run_.request_stop(StopReason::memory_limit);
            if (progress_interval_.count() > 0 && now >= next_progress) {
                run_.progress_due_.store(true, std::memory_order_relaxed);
                next_progress = now + progress_interval_;
            }
            if (run_.stop_reason()) return;
            wake_.wait_until(lock, next_event(now, next_progress), [this] { return finished_; });
        }
    }

    /// When there is something to do again, seen from `now`.
    Clock::time_point next_event(Clock::time_point now, Clock::time_point next_progress) const {
        Clock::time_point next = deadline_;
        if (memory_limit_) next = std::min(next, now + memory_sampling_interval);
        if (progress_interval_.count() > 0) next = std::min(next, next_progress);
        return next;
    }

    Run& run_;
    const Clock::time_point deadline_;
    const std::optional<std::uint64_t> memory_limit_;
    const std::chrono::milliseconds progress_interval_;
    std::mutex mutex_;
    std::condition_variable wake_;
    bool finished_ = false; // guarded by mutex_
    std::thread thread_;    // last: it uses all of the above
};

Run::Run() = default;

Run::Run(RunOptions options)
    : threads_(options.threads != 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency())),
      seed_(options.seed) {
    const Clock::time_point start = Clock::now();
    if (options.time_limit_seconds && !(*options.time_limit_seconds >= 0))
        throw DomainError("time limit: expected a number of seconds that is not negative, found " +
                          std::to_string(*options.time_limit_seconds));
    if (options.memory_limit_bytes && !resident_memory())
        throw DomainError("memory limit: this system does not tell the memory of a process");
    if (options.progress) {
        sink_ = std::make_unique<Sink>(std::move(options.progress), options.progress_interval);
        progress_due_ = options.progress_interval.count() <= 0;
    }
    const bool paced = sink_ && options.progress_interval.count() > 0;
    if (options.time_limit_seconds || options.memory_limit_bytes || paced)
        watchdog_ = std::make_unique<Watchdog>(*this, options, start);
}

Run::~Run() = default;

std::optional<StopReason> Run::stop_reason() const noexcept {
    const unsigned char reason = stop_.load(std::memory_order_relaxed);
    if (reason == keep_going) return std::nullopt;
    return static_cast<StopReason>(reason);
}

void Run::throw_stopped() const { throw Stopped(*stop_reason()); }

void Run::deliver(const Progress& progress) {
    const std::lock_guard lock(sink_->mutex);
    // Another thread may have reported between our look at the flag and now.
    if (!progress_due_.load(std::memory_order_relaxed)) return;
    if (sink_->interval.count() > 0) progress_due_.store(false, std::memory_order_relaxed);
    sink_->call(progress);
}

} // namespace eliminant::base
