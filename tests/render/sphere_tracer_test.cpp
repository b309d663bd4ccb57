// Sphere tracing finds what the surface itself answers, with any relaxation, and says what it did.
#include "eliminant/base/error.hpp"
#include "eliminant/render/camera.hpp"
#include "eliminant/render/sphere_tracer.hpp"
#include "render/spheres.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace eliminant::render {
namespace {

using test::Spheres;

constexpr field::DistanceLevel any_level{}; // the spheres' distances are exact at each

scene::ClipRegion ball_of(double radius) {
    scene::ClipRegion clip;
    clip.add(scene::Ball{glm::dvec3(0), radius});
    return clip;
}

/// A near row of small spheres that rays pass closely, and a large one behind.
Spheres hurdles() {
    std::vector<scene::Ball> balls{{{0, 0, -2}, 1.5}};
    for (int i = -4; i <= 4; ++i) balls.push_back({{0.3 * i, 0.25 * ((i + 8) % 3 - 1), 1}, 0.1});
    return Spheres(balls);
}

struct Traced {
    std::vector<scene::Hit> hits;
    SphereStatistics statistics;
};

Traced traced(const scene::Surface& surface, const scene::RayGrid& rays, const scene::ClipRegion& clip,
              double over_relaxation, std::uint32_t most_steps = 256) {
    const SphereTracer tracer(surface, rays, clip, {any_level, over_relaxation, most_steps});
    Traced result{std::vector<scene::Hit>(rays.width * rays.height), {}};
    base::Run run;
    tracer.trace({0, 0, rays.width, rays.height}, result.hits, run);
    result.statistics = tracer.statistics();
    return result;
}

const scene::RayGrid& rays_from_front() {
    static const scene::RayGrid rays =
        Camera::perspective({{0.2, 0.1, 6}, {0, 0, 0}, {0, 1, 0}}, 35).rays({60, 60});
    return rays;
}

TEST(SphereTracer, FindsTheFirstHitOfEveryRay) {
    const Spheres surface = hurdles();
    const scene::ClipRegion clip = ball_of(4);
    const auto exact = surface.tracer(rays_from_front(), clip, *std::make_unique<base::Run>());
    std::vector<scene::Hit> expected(std::size_t{60} * 60);
    base::Run run;
    exact->trace({0, 0, 60, 60}, expected, run);
    for (const double over_relaxation : {1.0, 1.2, 1.6, 1.99})
        for (const std::uint32_t most_steps : {1U, 5U, 256U}) {
            const Traced found = traced(surface, rays_from_front(), clip, over_relaxation, most_steps);
            for (std::size_t i = 0; i < expected.size(); ++i) {
                EXPECT_EQ(found.hits[i].kind, expected[i].kind) << i;
                EXPECT_TRUE(!expected[i] ||
                            std::abs(found.hits[i].t - expected[i].t) < 1e-14 * expected[i].t);
            }
        }
}

TEST(SphereTracer, StatisticsAddUp) {
    const Spheres surface = hurdles();
    const Traced found = traced(surface, rays_from_front(), ball_of(4), 1.6);
    const SphereStatistics& seen = found.statistics;
    EXPECT_EQ(seen.rays, seen.left + seen.came_near + seen.ran_out);
    EXPECT_GT(seen.left, 0U);
    EXPECT_GT(seen.came_near, 0U);
    EXPECT_EQ(seen.ran_out, 0U);
    EXPECT_GT(seen.back_steps, 0U);
    std::uint64_t steps = 0;
    for (const scene::Hit& hit : found.hits) steps += hit.steps;
    EXPECT_EQ(seen.steps, steps);
    EXPECT_EQ(traced(surface, rays_from_front(), ball_of(4), 1.0).statistics.back_steps, 0U);
    const SphereStatistics hurried = traced(surface, rays_from_front(), ball_of(4), 1.6, 1).statistics;
    EXPECT_GT(hurried.ran_out, 0U);
    EXPECT_EQ(hurried.steps, hurried.rays);
}

TEST(SphereTracer, OverRelaxationSavesSteps) {
    const Spheres surface({{{0, -1000, 0}, 1000}}); // seen at a grazing angle
    const scene::RayGrid rays = Camera::perspective({{0, 0.4, 9}, {0, 0.3, 0}, {0, 1, 0}}, 10).rays({20, 20});
    const auto steps = [&](double over_relaxation) {
        return traced(surface, rays, ball_of(10), over_relaxation).statistics.steps;
    };
    EXPECT_LT(static_cast<double>(steps(1.6)), 0.8 * static_cast<double>(steps(1.0)));
}

TEST(SphereTracer, StartingOnTheSurfaceIsAHit) {
    const Spheres surface({{{0, 0, 0}, 1}});
    scene::RayGrid rays;
    rays.origin = {0, 0, 1};
    const Traced found = traced(surface, rays, ball_of(2), 1.6);
    EXPECT_EQ(found.hits[0].t, 0);
    EXPECT_EQ(found.hits[0].steps, 1);
}

TEST(SphereTracer, ImproperOptionsAreRefused) {
    const Spheres surface({{{0, 0, 0}, 1}});
    const scene::RayGrid rays;
    for (const double over_relaxation : {0.9, 2.0, -1.0})
        EXPECT_THROW(SphereTracer(surface, rays, ball_of(2), {any_level, over_relaxation, 10}), DomainError);
    EXPECT_THROW(SphereTracer(surface, rays, scene::ClipRegion{}, {any_level, 1.5, 10}), DomainError);
    const scene::ClipRegion clip = ball_of(2);
    const SphereTracer tracer(surface, rays, clip, {any_level, 1.5, 10});
    base::Run run;
    std::vector<scene::Hit> hits(2);
    EXPECT_THROW(tracer.trace({0, 0, 2, 1}, hits, run), DomainError);
    EXPECT_THROW(tracer.trace({0, 0, 1, 1}, hits, run), DomainError);
}

} // namespace
} // namespace eliminant::render
