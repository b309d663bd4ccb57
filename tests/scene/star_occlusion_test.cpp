#include "eliminant/scene/algebraic_surface.hpp"

#include "scene/cases.hpp"

#include "eliminant/base/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace eliminant::scene {
namespace {

std::unique_ptr<Surface> surface_of(const std::string& f) {
    base::Run run;
    return algebraic_surface(test::polynomial(f), run);
}

glm::dvec3 random_vector(std::mt19937_64& random) {
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    return {number(random), number(random), number(random)};
}

/// Every ray as single rays answer.
void expect_as_single_rays(const Surface& surface, const ClipRegion& clip, double reach, std::size_t points,
                           std::size_t rays, const std::string& what) {
    const unsigned seed = 17;
    std::mt19937_64 random(seed);
    std::vector<glm::dvec3> origins(points);
    std::vector<glm::dvec3> directions(points * rays);
    std::generate(origins.begin(), origins.end(), [&] { return random_vector(random); });
    std::generate(directions.begin(), directions.end(), [&] { return random_vector(random); });
    base::Run run;
    std::vector<std::uint8_t> answers(directions.size(), 7);
    surface.occluded({origins, directions}, clip, reach, answers, run);
    for (std::size_t k = 0; k < directions.size(); ++k) {
        const Ray ray{origins[k % points], directions[k]};
        Interval inside = clip.interval(ray);
        inside.upper = std::min(inside.upper, reach);
        EXPECT_EQ(answers[k], surface.occluded(ray, inside, run) ? 1 : 0)
            << what << ", ray " << k << ", seed " << seed;
    }
}

TEST(StarOcclusion, AgreesWithSingleRays) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const char* f :
         {"x^2+y^2+z^2-1/2", "x^2-y^2*z", "x^4+y^4+z^4-5*(x^2+y^2+z^2)+11.8", "x*y*z", "x-1/3",
          "(x^2+y^2-1/4)^2", "x^60+y^60+z^2-1/2", "x^30+y^30+z^30-1/1000", "0", "1"}) {
        const auto surface = surface_of(f);
        expect_as_single_rays(*surface, ClipRegion().add(Ball{glm::dvec3(0.1), 1.5}), infinity, 13, 3, f);
        expect_as_single_rays(*surface, ClipRegion().add(Ball{glm::dvec3(0.0), 2.0}), 0.4, 8, 2, f);
        expect_as_single_rays(
            *surface,
            ClipRegion().add(Box{glm::dvec3(-0.5), glm::dvec3(1.0)}).add(HalfSpace{{1.0, 1.0, 0.0}, 1.0}),
            infinity, 9, 4, f);
    }
    // Unbounded regions have rays without end.
    expect_as_single_rays(*surface_of("x^2+y^2-z"), ClipRegion(), infinity, 5, 3, "paraboloid");
}

TEST(StarOcclusion, NoPointsOrNoRays) {
    const auto surface = surface_of("x");
    base::Run run;
    const std::vector<glm::dvec3> one(1);
    EXPECT_NO_THROW(surface->occluded(RayStars{}, ClipRegion(), 1.0, {}, run));
    EXPECT_NO_THROW(surface->occluded(RayStars{one, {}}, ClipRegion(), 1.0, {}, run));
}

TEST(StarOcclusion, Errors) {
    base::Run run;
    for (const char* f : {"x", "1"}) {
        const auto surface = surface_of(f);
        const std::vector<glm::dvec3> two{{0, 0, 1}, {0, 1, 0}};
        const std::vector<glm::dvec3> three{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
        const std::vector<glm::dvec3> bad{{0, 0, 1}, {0, std::nan(""), 0}};
        const std::vector<glm::dvec3> null{{0, 0, 1}, {0, 0, 0}};
        std::vector<std::uint8_t> answers(2);
        std::vector<std::uint8_t> three_answers(3);
        const ClipRegion clip = ClipRegion().add(Ball{});
        const auto expect_error = [&](const RayStars& rays, double reach, std::span<std::uint8_t> to) {
            EXPECT_THROW(surface->occluded(rays, clip, reach, to, run), base::DomainError) << f;
        };
        expect_error({two, three}, 1.0, three_answers);
        expect_error({two, two}, 1.0, three_answers);
        expect_error({{}, two}, 1.0, answers);
        expect_error({two, bad}, 1.0, answers);
        expect_error({bad, two}, 1.0, answers);
        expect_error({two, null}, 1.0, answers);
        expect_error({two, two}, -1.0, answers);
        expect_error({two, two}, std::nan(""), answers);
        EXPECT_NO_THROW(surface->occluded({two, two}, clip, 1.0, answers, run));
    }
}

} // namespace
} // namespace eliminant::scene
