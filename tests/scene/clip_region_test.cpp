#include "eliminant/scene/clip_region.hpp"

#include "scene/clip_rows.hpp"

#include "eliminant/base/error.hpp"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace eliminant::scene {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_near(Interval interval, double lower, double upper) {
    EXPECT_LE(interval.lower, lower);
    EXPECT_NEAR(interval.lower, lower, 1e-12 * (1.0 + std::abs(lower)));
    EXPECT_GE(interval.upper, upper);
    EXPECT_NEAR(interval.upper, upper, 1e-12 * (1.0 + std::abs(upper)));
}

TEST(ClipRegion, KnownIntervals) {
    const Ray ray{{0.0, 0.0, 5.0}, {0.0, 0.0, -2.0}};
    expect_near(ClipRegion().add(Ball{{0, 0, 0}, 1.0}).interval(ray), 2.0, 3.0);
    expect_near(ClipRegion().add(Box{{-1, -1, -1}, {1, 1, 3}}).interval(ray), 1.0, 3.0);
    const ClipRegion half = ClipRegion().add(HalfSpace{{0, 0, 1}, 2.0});
    expect_near({half.interval(ray).lower, 0.0}, 1.5, 0.0);
    EXPECT_EQ(half.interval(ray).upper, infinity);
    expect_near(ClipRegion().add(Ball{{0, 0, 0}, 1.0}).add(HalfSpace{{0, 0, 1}, 0.5}).interval(ray), 2.25,
                3.0);
    // From within, the interval starts at the origin.
    EXPECT_EQ(ClipRegion().add(Ball{{0, 0, 5}, 1.0}).interval(ray).lower, 0.0);
    EXPECT_TRUE(ClipRegion().add(Ball{{3, 0, 0}, 1.0}).interval(ray).empty());
    EXPECT_TRUE(ClipRegion().add(Ball{{0, 0, 9}, 1.0}).interval(ray).empty());
    EXPECT_TRUE(ClipRegion().add(Box{{1, 1, -1}, {2, 2, 1}}).interval(ray).empty());
    EXPECT_EQ(ClipRegion().interval(ray).upper, infinity);
}

TEST(ClipRegion, BoundaryIsKept) {
    // Rays that graze, and a face that the ray lies in.
    EXPECT_FALSE(ClipRegion().add(Ball{{0, 0, 0}, 1.0}).interval({{1, 0, 5}, {0, 0, -1}}).empty());
    EXPECT_FALSE(ClipRegion().add(Box{{-1, -1, -1}, {1, 1, 1}}).interval({{1, 0, 5}, {0, 0, -1}}).empty());
    EXPECT_TRUE(ClipRegion().add(Ball{{0, 0, 0}, 1.0}).interval({{1.0001, 0, 5}, {0, 0, -1}}).empty());
}

TEST(ClipRegion, ContainsItsIntervalsOnRandomRays) {
    const unsigned seed = 3;
    std::mt19937_64 random(seed);
    const auto uniform = [&random] { return std::uniform_real_distribution<>(-1.0, 1.0)(random); };
    for (int round = 0; round < 2000; ++round) {
        ClipRegion clip;
        clip.add(Ball{{uniform(), uniform(), uniform()}, 1.0 + uniform()});
        if (round % 2 == 0) clip.add(Box{{-1.0, -0.5 + 0.2 * uniform(), -1.0}, {0.7, 1.0, 0.9}});
        if (round % 3 == 0) clip.add(HalfSpace{{uniform(), uniform(), uniform()}, uniform()});
        const Ray ray{{4.0 * uniform(), 4.0 * uniform(), 4.0 * uniform()}, {uniform(), uniform(), uniform()}};
        const Interval interval = clip.interval(ray);
        for (int i = 0; i <= 40; ++i) {
            const double t = 0.25 * i;
            if (clip.contains(ray.at(t))) {
                EXPECT_TRUE(interval.contains(t)) << "seed " << seed << ", round " << round << ", t " << t;
            }
        }
        if (!interval.empty() && interval.upper - interval.lower > 1e-6) {
            const double inner = 1e-9 * (interval.upper - interval.lower);
            EXPECT_TRUE(clip.contains(ray.at(interval.lower + inner)))
                << "seed " << seed << ", round " << round;
            EXPECT_TRUE(clip.contains(ray.at(interval.upper - inner)))
                << "seed " << seed << ", round " << round;
        }
    }
}

TEST(ClipRegion, RowsOfRaysAgreeWithSingleRays) {
    ClipRegion clip;
    clip.add(Ball{{0.1, 0.2, -0.1}, 1.5})
        .add(Box{{-1, -1.2, -1}, {1, 1.1, 2}})
        .add(HalfSpace{{1, 1, 1}, 1.5});
    constexpr std::size_t count = 32;
    for (const base::VectorUnit unit : base::available_vector_units())
        for (const bool is_pencil : {true, false}) {
            ClipRow row{.first = {{0.0, 0.0, 6.0}, {-0.4, 0.1, -1.0}},
                        .origin_dx = glm::dvec3(0.0),
                        .direction_dx = {0.025, 0.0, 0.0},
                        .is_pencil = is_pencil};
            if (!is_pencil) std::swap(row.origin_dx, row.direction_dx);
            row.region = RegionParts::of(clip);
            const auto raw = [is_pencil](double t) { return is_pencil ? -1.0 / t : t; };
            row.middle_w = 0.5 * (raw(3.0) + raw(10.0));
            row.radius_w = 0.5 * (raw(10.0) - raw(3.0));
            std::vector<double> lower(count);
            std::vector<double> upper(count);
            row.count = count;
            row.lower = lower.data();
            row.upper = upper.data();
            row_clipper(unit)(row);
            for (std::size_t i = 0; i < count; ++i) {
                const double c = static_cast<double>(i);
                const Interval t = clip.interval(
                    {row.first.origin + c * row.origin_dx, row.first.direction + c * row.direction_dx});
                ASSERT_EQ(t.empty(), lower[i] > upper[i]) << name(unit) << " " << i;
                if (t.empty()) continue;
                EXPECT_NEAR(lower[i], (raw(t.lower) - row.middle_w) / row.radius_w, 1e-12) << name(unit);
                EXPECT_NEAR(upper[i], (raw(t.upper) - row.middle_w) / row.radius_w, 1e-12) << name(unit);
            }
        }
}

TEST(ClipRegion, Errors) {
    const double nan = std::nan("");
    EXPECT_THROW(ClipRegion().add(Ball{{0, 0, 0}, -1.0}), base::DomainError);
    EXPECT_THROW(ClipRegion().add(Ball{{nan, 0, 0}, 1.0}), base::DomainError);
    EXPECT_THROW(ClipRegion().add(Box{{1, 0, 0}, {0, 1, 1}}), base::DomainError);
    EXPECT_THROW(ClipRegion().add(Box{{0, 0, 0}, {1, 1, infinity}}), base::DomainError);
    EXPECT_THROW(ClipRegion().add(HalfSpace{{0, 0, 0}, 1.0}), base::DomainError);
    EXPECT_THROW(ClipRegion().interval({{0, 0, 0}, {0, 0, 0}}), base::DomainError);
    EXPECT_THROW(ClipRegion().interval({{0, nan, 0}, {0, 0, 1}}), base::DomainError);
}

} // namespace
} // namespace eliminant::scene
