/// \file
/// Independent items on several threads.
#pragma once

#include "eliminant/base/run.hpp"

#include <cstddef>
#include <functional>

namespace eliminant::base {

/// Calls `body(item, worker)` once for each item in [0, count), on at most run.threads() threads, and returns
/// when all are done. Items are handed out as threads become free, so `body` must not depend on which thread
/// treats what; write results to slots indexed by the item. `worker` is in [0, run.threads()) and differs
/// between calls that run at the same time: an index of scratch memory. With one thread, or one item, the
/// items are treated in ascending order by the calling thread.
///
/// A call from within `body` shares the threads of the outer call. While it waits it takes up none of the
/// outer call's items, so scratch memory of the outer item stays untouched.
///
/// \throws whatever `body` throws, one of them if several threads do; items not yet begun are then dropped.
///   The Run is polled before each item.
void parallel_for(const Run& run, std::size_t count,
                  const std::function<void(std::size_t item, std::size_t worker)>& body);

} // namespace eliminant::base
