#include "base/parallel.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace eliminant::base {
namespace {

/// True while this thread treats an item of a parallel_for on several threads.
thread_local bool inside = false;

class InsideGuard {
  public:
    InsideGuard() : before_(inside) { inside = true; }
    ~InsideGuard() { inside = before_; }
    InsideGuard(const InsideGuard&) = delete;
    InsideGuard& operator=(const InsideGuard&) = delete;

  private:
    bool before_;
};

} // namespace

void parallel_for(const Run& run, std::size_t count,
                  const std::function<void(std::size_t item, std::size_t worker)>& body) {
    if (count <= 1 || run.threads() == 1) {
        // Within an outer call the number of this thread there: other threads may be at the same place.
        const std::size_t worker =
            inside ? static_cast<std::size_t>(tbb::this_task_arena::current_thread_index()) : 0;
        for (std::size_t item = 0; item < count; ++item) {
            run.poll();
            body(item, worker);
        }
        return;
    }
    const auto spread = [&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, count, 1),
            [&](const tbb::blocked_range<std::size_t>& items) {
                const InsideGuard guard;
                const auto worker = static_cast<std::size_t>(tbb::this_task_arena::current_thread_index());
                for (std::size_t item = items.begin(); item != items.end(); ++item) {
                    run.poll();
                    body(item, worker);
                }
            },
            tbb::simple_partitioner{});
    };
    static const auto default_concurrency = static_cast<std::size_t>(tbb::info::default_concurrency());
    if (inside) {
        tbb::this_task_arena::isolate(spread);
    } else {
        // Without it more threads than processors are refused, with a warning on standard error.
        const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                          std::max<std::size_t>(run.threads(), default_concurrency));
        tbb::task_arena arena(static_cast<int>(run.threads()));
        arena.execute(spread);
    }
}

} // namespace eliminant::base
