#include "eliminant/scene/algebraic_surface.hpp"

#include "scene/cases.hpp"

#include "eliminant/base/error.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace eliminant::scene {
namespace {

std::vector<Hit> trace(const Surface& surface, const RayGrid& rays, const ClipRegion& clip) {
    base::Run run;
    std::vector<Hit> hits(rays.width * rays.height);
    surface.tracer(rays, clip, run)->trace({0, 0, rays.width, rays.height}, hits, run);
    return hits;
}

std::unique_ptr<Surface> surface_of(const std::string& f) {
    base::Run run;
    return algebraic_surface(test::polynomial(f), run);
}

Ray ray_of(const RayGrid& rays, std::size_t pixel) {
    return rays.ray(static_cast<double>(pixel % rays.width), static_cast<double>(pixel / rays.width));
}

TEST(GridTracer, AgreesWithExactAnswersOnEverySurface) {
    base::Run run;
    for (const test::Case& entry : test::cases()) {
        const auto surface = algebraic_surface(entry.polynomial, run);
        const RayGrid rays = test::pinhole_grid(entry.camera, 128);
        const auto hits = trace(*surface, rays, ClipRegion().add(Ball{glm::dvec3(0.0), entry.clip_radius}));
        const auto exact = test::exact_depths(entry.name);
        for (std::size_t i = 0; i < exact.size(); ++i) {
            if (std::isnan(exact[i])) continue;
            const std::size_t pixel = (4 * (i / 32) + 2) * 128 + 4 * (i % 32) + 2;
            const Hit& hit = hits[pixel];
            const Ray ray = ray_of(rays, pixel);
            ASSERT_EQ(static_cast<bool>(hit), std::isfinite(exact[i])) << entry.name << ", pixel " << pixel;
            if (!hit) continue;
            EXPECT_NEAR(hit.t * glm::length(ray.direction), exact[i], 1e-10 * exact[i]) << entry.name;
            const glm::dvec3 expected = glm::normalize(surface->gradient(ray.at(hit.t)));
            EXPECT_NEAR(glm::dot(glm::normalize(hit.gradient), expected), 1.0, 1e-9)
                << entry.name << ", pixel " << pixel;
            // The function falls on the way in from where it is positive.
            EXPECT_LT(hit.side * glm::dot(hit.gradient, ray.direction), 0.0) << entry.name;
        }
    }
}

/// Every ray asked for by itself must give what the grid gives.
void expect_as_single_rays(const Surface& surface, const RayGrid& rays, const ClipRegion& clip,
                           const std::string& what) {
    const auto hits = trace(surface, rays, clip);
    int met = 0;
    base::Run run;
    for (std::size_t pixel = 0; pixel < hits.size(); ++pixel) {
        const Ray ray = ray_of(rays, pixel);
        const Hit single = surface.first_hit(ray, clip.interval(ray), run);
        ASSERT_EQ(static_cast<bool>(hits[pixel]), static_cast<bool>(single)) << what << ", pixel " << pixel;
        if (!single) continue;
        ++met;
        EXPECT_NEAR(hits[pixel].t, single.t, 1e-8 * single.t) << what << ", pixel " << pixel;
        EXPECT_EQ(hits[pixel].side, single.side) << what << ", pixel " << pixel;
        EXPECT_EQ(hits[pixel].kind, single.kind) << what << ", pixel " << pixel;
        EXPECT_NEAR(glm::dot(glm::normalize(hits[pixel].gradient), glm::normalize(single.gradient)), 1.0,
                    1e-6)
            << what << ", pixel " << pixel;
    }
    EXPECT_GT(met, 0) << what;
}

RayGrid parallel_grid(std::size_t width, std::size_t height) {
    RayGrid rays;
    rays.width = width;
    rays.height = height;
    rays.origin = {-2.03, 1.96, 4.0};
    rays.origin_dx = {4.0 / static_cast<double>(width), 0.01, 0.0};
    rays.origin_dy = {0.0, -4.0 / static_cast<double>(height), 0.02};
    rays.direction = {0.1, 0.05, -1.5};
    return rays;
}

TEST(GridTracer, ParallelRaysAndOtherGrids) {
    const ClipRegion clip = ClipRegion().add(Ball{{0.1, 0.0, 0.0}, 2.0});
    for (const char* name : {"torus", "barth6", "endrass8"}) {
        base::Run run;
        const auto surface = algebraic_surface(test::case_named(name).polynomial, run);
        expect_as_single_rays(*surface, parallel_grid(45, 70), clip, std::string(name) + ", parallel");
        RayGrid both = parallel_grid(20, 20);
        both.direction_dx = {0.001, 0.0, 0.002};
        expect_as_single_rays(*surface, both, clip,
                              std::string(name) + ", neither parallel nor from a point");
    }
}

TEST(GridTracer, CamerasWithinAndBehindTheRegion) {
    base::Run run;
    const auto surface = algebraic_surface(test::case_named("torus").polynomial, run);
    const ClipRegion clip = ClipRegion().add(Ball{glm::dvec3(0.0), 1.6});
    for (const glm::dvec3 origin :
         {glm::dvec3{1.0, 0.1, 0.05}, glm::dvec3{0.9, 0.9, 0.9}, glm::dvec3{0.0, 0.2, 1.7}})
        expect_as_single_rays(*surface, test::pinhole_grid(origin, 24), clip, "near camera");
    // So near to the surface that rays are traced one by one, and on it.
    expect_as_single_rays(*surface, test::pinhole_grid({1.4 - 1e-5, 0.0, 0.0}, 9), clip, "very near camera");
    const auto sphere = surface_of("x^2+y^2+z^2-1");
    for (const Hit& hit : trace(*sphere, test::pinhole_grid({0.0, 0.0, 1.0}, 5), clip)) EXPECT_EQ(hit.t, 0.0);
    RayGrid away = test::pinhole_grid({0.5, 1.0, 6.0}, 16);
    away.direction = -away.direction;
    away.direction_dx = -away.direction_dx;
    away.direction_dy = -away.direction_dy;
    for (const Hit& hit : trace(*surface, away, clip)) EXPECT_FALSE(hit);
}

TEST(GridTracer, BoxesAndHalfSpacesAreNotCapped) {
    const auto sphere = surface_of("x^2+y^2+z^2-1");
    RayGrid rays = test::pinhole_grid({0.01, 0.02, 6.0}, 33);
    // The near half is cut away: the first hit is on the far half, from within.
    const ClipRegion far_half = ClipRegion().add(Ball{glm::dvec3(0.0), 2.0}).add(HalfSpace{{0, 0, 1}, 0.0});
    expect_as_single_rays(*sphere, rays, far_half, "half-space");
    const Hit middle = trace(*sphere, rays, far_half)[16 * 33 + 16];
    ASSERT_TRUE(middle);
    EXPECT_EQ(middle.side, -1);
    EXPECT_NEAR(rays.ray(16, 16).at(middle.t).z, -1.0, 1e-3);
    expect_as_single_rays(*sphere, rays, ClipRegion().add(Box{{-0.5, -2, -2}, {2, 0.25, 2}}), "box");
    // A region bounded by the surface itself keeps all of it.
    int hits = 0;
    for (const Hit& hit : trace(*sphere, rays, ClipRegion().add(Ball{glm::dvec3(0.0), 1.0})))
        hits += hit ? 1 : 0;
    int all = 0;
    for (const Hit& hit : trace(*sphere, rays, ClipRegion().add(Ball{glm::dvec3(0.0), 1.5})))
        all += hit ? 1 : 0;
    EXPECT_EQ(hits, all);
}

TEST(GridTracer, DoesNotDependOnTiles) {
    base::Run run;
    const test::Case& entry = test::case_named("barth6");
    const auto surface = algebraic_surface(entry.polynomial, run);
    const RayGrid rays = test::pinhole_grid(entry.camera, 100);
    const ClipRegion clip = ClipRegion().add(Ball{glm::dvec3(0.0), entry.clip_radius});
    const auto whole = trace(*surface, rays, clip);
    const auto tracer = surface->tracer(rays, clip, run);
    for (std::size_t row = 0; row < 100; row += 37)
        for (std::size_t column = 0; column < 100; column += 23) {
            const Tile tile{column, row, std::min<std::size_t>(23, 100 - column),
                            std::min<std::size_t>(37, 100 - row)};
            std::vector<Hit> hits(tile.size());
            tracer->trace(tile, hits, run);
            for (std::size_t i = 0; i < hits.size(); ++i) {
                const Hit& expected = whole[(row + i / tile.width) * 100 + column + i % tile.width];
                ASSERT_EQ(hits[i].t, expected.t);
                ASSERT_EQ(hits[i].gradient, expected.gradient);
                ASSERT_EQ(hits[i].kind, expected.kind);
                ASSERT_EQ(hits[i].side, expected.side);
            }
        }
}

TEST(GridTracer, SingularLinesAreHitWhereRaysMeetThem) {
    // The middle column of rays meets the handle of Whitney's umbrella, x = y = 0 with z < 0, in one point
    // each.
    const auto whitney = surface_of("x^2-y^2*z");
    RayGrid rays;
    rays.width = 65;
    rays.height = 33;
    rays.origin = {-2.0, 4.0, -1.5};
    rays.origin_dx = {0.0625, 0.0, 0.0};
    rays.origin_dy = {0.0, 0.0, 0.03125};
    rays.direction = {0.0, -1.0, 0.0};
    const auto hits = trace(*whitney, rays, ClipRegion().add(Ball{glm::dvec3(0.0), 3.0}));
    for (std::size_t row = 0; row < 33; ++row)
        for (std::size_t column = 0; column < 65; ++column) {
            const Hit& hit = hits[row * 65 + column];
            EXPECT_EQ(hit.kind, column == 32 ? HitKind::tangency : HitKind::miss) << row << " " << column;
            if (hit) {
                EXPECT_EQ(hit.t, 4.0);
            }
        }
}

TEST(GridTracer, RaysWithinTheSurfaceAndConstants) {
    const ClipRegion clip = ClipRegion().add(Ball{glm::dvec3(0.0), 2.0});
    RayGrid rays = parallel_grid(5, 5);
    rays.origin = {-1.0, 0.0, 4.0};
    rays.origin_dx = {0.5, 0.0, 0.0};
    rays.origin_dy = {0.0, 0.25, 0.0};
    rays.direction = {0.0, 0.0, -1.0};
    const auto hits = trace(*surface_of("x*y"), rays, clip);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const Ray ray = ray_of(rays, i);
        EXPECT_EQ(hits[i].kind,
                  ray.origin.x == 0.0 || ray.origin.y == 0.0 ? HitKind::contained : HitKind::miss);
        if (hits[i]) {
            EXPECT_NEAR(hits[i].t, clip.interval(ray).lower, 1e-12);
        }
    }
    for (const Hit& hit : trace(*surface_of("0"), rays, clip)) EXPECT_EQ(hit.kind, HitKind::contained);
    for (const Hit& hit : trace(*surface_of("-2"), rays, clip)) {
        EXPECT_EQ(hit.kind, HitKind::miss);
        EXPECT_EQ(hit.side, -1);
    }
}

TEST(GridTracer, RepeatedFactorsAndHighDegrees) {
    const RayGrid rays = test::pinhole_grid({1.0, 2.0, 5.0}, 40);
    const ClipRegion clip = ClipRegion().add(Ball{glm::dvec3(0.0), 1.5});
    const auto plain = trace(*surface_of("x^2+y^2+z^2-1"), rays, clip);
    const auto squared = trace(*surface_of("(x^2+y^2+z^2-1)^2*7"), rays, clip);
    for (std::size_t i = 0; i < plain.size(); ++i) {
        ASSERT_EQ(static_cast<bool>(plain[i]), static_cast<bool>(squared[i]));
        if (plain[i]) {
            EXPECT_DOUBLE_EQ(plain[i].t, squared[i].t);
        }
    }
    // Beyond the degree of the kernels: ray by ray.
    const RayGrid few = test::pinhole_grid({1.0, 2.0, 5.0}, 4);
    const auto superquadric = surface_of("x^60+y^60+z^60-1");
    int met = 0;
    for (const Hit& hit : trace(*superquadric, few, clip)) met += hit ? 1 : 0;
    EXPECT_GT(met, 3);
}

TEST(Surface, SingleRaysAndFramingCanBeStopped) {
    const auto surface = surface_of("x^100+x*y^80*z+z^100-1"); // too high a degree for floating point
    base::Run stopped;
    stopped.request_stop();
    const Ray ray{{0.1, 0.2, 5}, {0.3, 0.1, -1}};
    EXPECT_THROW(surface->first_hit(ray, {0, 10}, stopped), base::Stopped);
    EXPECT_THROW(surface->all_hits(ray, {0, 10}, stopped), base::Stopped);
    EXPECT_THROW(surface->occluded(ray, {0, 10}, stopped), base::Stopped);
    EXPECT_THROW(surface->framing_ball(stopped), base::Stopped);
}

TEST(Surface, FramesWhatIsFarFromTheOrigin) {
    base::Run run;
    for (const auto& [f, center] : {std::pair{"(x-1000)^2+y^2+z^2-1", glm::dvec3(1000, 0, 0)},
                                    {"(x-10)^2+(y+3)^2+z^4-1", glm::dvec3(10, -3, 0)},
                                    {"x^2+2*(y-7)^2+(x+y-z)^2-5", glm::dvec3(0, 7, 7)}}) {
        const Ball ball = surface_of(f)->framing_ball(run);
        EXPECT_LT(glm::distance(ball.center, center), 1e-6) << f;
        EXPECT_GT(ball.radius, 0.9) << f;
        EXPECT_LT(ball.radius, 10) << f;
    }
    EXPECT_EQ(surface_of("x^4+y^4+z^4-x*y*z-1")->framing_ball(run).center, glm::dvec3(0.0));
}

/// What is unbounded is shown as far as it is of interest, also where nearly all rays miss it far away.
TEST(Surface, FramesUnboundedSurfaces) {
    base::Run run;
    for (const auto& [f, center, least, most] :
         {std::tuple{"x^2+y^2-1", glm::dvec3(0), 1.5, 4.0},
          {"x^2+y^2-1/100", glm::dvec3(0), 0.15, 0.4},
          {"(x-20)^2+y^2-1", glm::dvec3(20, 0, 0), 1.5, 4.0},
          {"x-5", glm::dvec3(5, 0, 0), 0.5, 4.0},
          {"x^2+y^2-z^2-1", glm::dvec3(0), 1.5, 4.0},
          {"x^4+y^4+z^2-1", glm::dvec3(0), 1.2, 2.0}, // bounded, though its highest part is not definite
          {"x^300+y^300+z^300-1", glm::dvec3(0), 1.7, 2.0}}) {
        const Ball ball = surface_of(f)->framing_ball(run);
        EXPECT_LT(glm::distance(ball.center, center), 1e-6) << f;
        EXPECT_GT(ball.radius, least) << f;
        EXPECT_LT(ball.radius, most) << f;
    }
    // The equation of a bicubic patch whose points are within 5/2 of the origin.
    const Ball patch = algebraic_surface(test::case_named("bicubic18").polynomial, run)->framing_ball(run);
    EXPECT_LT(glm::length(patch.center) + patch.radius, 8.0);
    EXPECT_GT(patch.radius, 1.0);
}

TEST(GridTracer, Errors) {
    base::Run run;
    const auto sphere = surface_of("x^2+y^2+z^2-1");
    RayGrid rays = test::pinhole_grid({0, 1, 5}, 8);
    const ClipRegion clip = ClipRegion().add(Ball{glm::dvec3(0.0), 2.0});
    EXPECT_THROW(sphere->tracer(rays, ClipRegion(), run), base::DomainError);
    const auto tracer = sphere->tracer(rays, clip, run);
    std::vector<Hit> hits(64);
    EXPECT_THROW(tracer->trace({0, 0, 9, 8}, hits, run), base::DomainError);
    EXPECT_THROW(tracer->trace({0, 0, 4, 8}, hits, run), base::DomainError);
    rays.direction_dx.x = std::nan("");
    EXPECT_THROW(sphere->tracer(rays, clip, run), base::DomainError);
    EXPECT_THROW(sphere->first_hit({{0, 0, 0}, {0, 0, 0}}, {0.0, 1.0}, run), base::DomainError);
    EXPECT_THROW(sphere->first_hit({{0, 0, std::nan("")}, {0, 0, 1}}, {0.0, 1.0}, run), base::DomainError);
    EXPECT_THROW(sphere->first_hit({{0, 0, 0}, {0, 0, 1}}, {0.0, std::nan("")}, run), base::DomainError);
    EXPECT_THROW(
        algebraic_surface(parse_polynomial(Ring(CoefficientField::prime(7), {"x", "y"}), {"x", "f"}), run),
        base::DomainError);
}

} // namespace
} // namespace eliminant::scene
