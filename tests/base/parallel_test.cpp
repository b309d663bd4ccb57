#include "base/parallel.hpp"
#include "base/vector_unit.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <stdexcept>
#include <vector>

namespace eliminant::base {
namespace {

RunOptions with_threads(unsigned threads) {
    RunOptions options;
    options.threads = threads;
    return options;
}

TEST(ParallelFor, TreatsEachItemOnce) {
    for (const unsigned threads : {1U, 2U, 5U}) {
        base::Run run(with_threads(threads));
        for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
            std::vector<std::atomic<int>> treated(count);
            std::atomic<bool> worker_in_range = true;
            parallel_for(run, count, [&](std::size_t item, std::size_t worker) {
                ++treated[item];
                if (worker >= threads) worker_in_range = false;
            });
            for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(treated[i], 1) << i << " of " << count;
            EXPECT_TRUE(worker_in_range);
        }
    }
}

TEST(ParallelFor, ScratchOfAnOuterItemStaysUntouched) {
    base::Run run(with_threads(4));
    std::vector<int> scratch(4, 0);
    std::atomic<int> clashes = 0;
    std::atomic<int> inner_items = 0;
    parallel_for(run, 64, [&](std::size_t, std::size_t worker) {
        if (scratch[worker] != 0) ++clashes;
        scratch[worker] = 1;
        parallel_for(run, 16, [&](std::size_t, std::size_t) { ++inner_items; });
        scratch[worker] = 0;
    });
    EXPECT_EQ(clashes, 0);
    EXPECT_EQ(inner_items, 64 * 16);
}

TEST(ParallelFor, AnErrorOfOneItemReachesTheCaller) {
    for (const unsigned threads : {1U, 3U}) {
        base::Run run(with_threads(threads));
        const auto fail = [](std::size_t item, std::size_t) {
            if (item == 77) throw std::domain_error("item 77");
        };
        EXPECT_THROW(parallel_for(run, 100, fail), std::domain_error);
    }
}

TEST(ParallelFor, StopsWhenAsked) {
    for (const unsigned threads : {1U, 3U}) {
        base::Run run(with_threads(threads));
        std::atomic<int> treated = 0;
        EXPECT_THROW(parallel_for(run, 1000000,
                                  [&](std::size_t, std::size_t) {
                                      if (++treated == 10) run.request_stop();
                                  }),
                     Stopped);
        EXPECT_LT(treated, 1000);
    }
}

TEST(VectorUnits, PortableIsFirstAndTheBestIsLast) {
    const std::vector<VectorUnit> units = available_vector_units();
    ASSERT_FALSE(units.empty());
    EXPECT_EQ(units.front(), VectorUnit::portable);
    EXPECT_EQ(units.back(), best_vector_unit());
    std::set<std::string_view> names;
    for (const VectorUnit unit : units) names.insert(name(unit));
    EXPECT_EQ(names.size(), units.size());
}

} // namespace
} // namespace eliminant::base
