#include "eliminant/field/ray_roots.hpp"

#include "field/surfaces.hpp"
#include "support/sturm.hpp"

#include "eliminant/base/error.hpp"
#include "eliminant/field/ray_restriction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace eliminant::field {
namespace {

using Kind = RayRoot::Kind;
using test::polynomial;
constexpr double infinity = std::numeric_limits<double>::infinity();

RayRoot first(const std::string& f, glm::dvec3 origin, glm::dvec3 direction, double lower = 0.0,
              double upper = 100.0) {
    base::Run run;
    return RayRoots(polynomial(f)).first(origin, direction, lower, upper, run);
}

TEST(RayRestriction, IsTheComposition) {
    base::Run run;
    const auto p = restrict_to_ray(polynomial("x^2+y^2+z^2-1"), {3.0, 0.5, 0.25}, {-1.0, 0.0, 0.125}, run);
    // (3 − t)² + 1/4 + (1/4 + t/8)² − 1 up to a positive factor
    ASSERT_EQ(p.size(), 3U);
    EXPECT_EQ(p[0] * 65, p[2] * 133 * 4);
    EXPECT_EQ(p[1] * 65, p[2] * -95 * 4);
    EXPECT_GT(p[2], 0);
    EXPECT_THROW(restrict_to_ray(polynomial("x"), {std::nan(""), 0, 0}, {1, 0, 0}, run), base::DomainError);
}

TEST(RayRoots, CrossingsTangenciesAndMisses) {
    const std::string sphere = "x^2+y^2+z^2-1";
    const RayRoot hit = first(sphere, {0, 0, 3}, {0, 0, -2});
    EXPECT_EQ(hit.kind, Kind::crossing);
    EXPECT_NEAR(hit.t, 1.0, 1e-12);
    EXPECT_EQ(hit.side, 1);
    const RayRoot touch = first(sphere, {1, 0, 3}, {0, 0, -1});
    EXPECT_EQ(touch.kind, Kind::tangency);
    EXPECT_EQ(touch.t, 3.0);
    EXPECT_EQ(touch.multiplicity, 2U);
    EXPECT_EQ(touch.side, 1);
    EXPECT_EQ(touch.precision, Precision::exact);
    // One unit in the last place beside the tangent: exactly a miss, exactly a hit.
    EXPECT_EQ(first(sphere, {std::nextafter(1.0, 2.0), 0, 3}, {0, 0, -1}).kind, Kind::none);
    EXPECT_EQ(first(sphere, {std::nextafter(1.0, 0.0), 0, 3}, {0, 0, -1}).kind, Kind::crossing);
    EXPECT_EQ(first(sphere, {0, 0, 0}, {0, 0, 1}).side, -1);
}

TEST(RayRoots, TheIntervalIsClosed) {
    const std::string sphere = "x^2+y^2+z^2-1";
    EXPECT_EQ(first(sphere, {0, 0, 3}, {0, 0, -1}, 0.0, 2.0).kind, Kind::crossing);
    EXPECT_EQ(first(sphere, {0, 0, 3}, {0, 0, -1}, 0.0, std::nextafter(2.0, 0.0)).kind, Kind::none);
    EXPECT_EQ(first(sphere, {0, 0, 3}, {0, 0, -1}, 4.0, 5.0).kind, Kind::crossing);
    EXPECT_EQ(first(sphere, {0, 0, 3}, {0, 0, -1}, std::nextafter(4.0, 5.0), 5.0).kind, Kind::none);
    EXPECT_EQ(first(sphere, {0, 0, 3}, {0, 0, -1}, 2.0, 2.0).kind, Kind::crossing);
    EXPECT_EQ(first(sphere, {0, 0, 3}, {0, 0, -1}, 3.0, 2.0).kind, Kind::none);
    EXPECT_NEAR(first(sphere, {0, 0, 3e6}, {0, 0, -1}, 0.0, infinity).t, 3e6 - 1, 1e-6);
}

TEST(RayRoots, LowerDimensionalPartsAndRaysWithin) {
    const std::string whitney = "x^2-y^2*z";
    // The handle: the axis x = y = 0 for z < 0, met by a ray across it.
    const RayRoot handle = first(whitney, {3, 0.75, -1}, {-1, -0.25, 0});
    EXPECT_EQ(handle.kind, Kind::tangency);
    EXPECT_EQ(handle.t, 3.0);
    EXPECT_EQ(first(whitney, {3, 0.75, -1}, {-1, -0.25, 0x1p-60}).kind,
              Kind::tangency); // still across the axis
    EXPECT_EQ(first(whitney, {3, 0.75 + 0x1p-40, -1}, {-1, -0.25, 0}).kind, Kind::none);
    const RayRoot within = first(whitney, {0, 0, 5}, {0, 0, -1}, 1.5, 9.0);
    EXPECT_EQ(within.kind, Kind::contained);
    EXPECT_EQ(within.t, 1.5);
    EXPECT_EQ(first("0", {0, 0, 5}, {0, 0, -1}).kind, Kind::contained);
    EXPECT_EQ(first("-3", {0, 0, 5}, {0, 0, -1}).kind, Kind::none);
    EXPECT_EQ(first("-3", {0, 0, 5}, {0, 0, -1}).side, -1);
    // A cone's apex, a triple plane, an isolated point.
    EXPECT_EQ(first("x^2+y^2-z^2", {3, 0, 0}, {-1, 0, 0}).kind, Kind::tangency);
    const RayRoot triple = first("z^3", {0, 0, 2}, {0, 0, -1});
    EXPECT_EQ(triple.kind, Kind::crossing);
    EXPECT_EQ(triple.multiplicity, 3U);
    EXPECT_EQ(first("x^2+y^2+z^2", {2, 0, 0}, {-1, 0, 0}).kind, Kind::tangency);
    EXPECT_EQ(first("x^2+y^2+z^2", {2, 0x1p-500, 0}, {-1, 0, 0}).kind, Kind::none);
}

TEST(RayRoots, AllRootsOfATorus) {
    base::Run run;
    const RayRoots torus(polynomial("(x^2+y^2+z^2+3/4)^2-4*(x^2+y^2)")); // radii 1 and 1/2
    const auto roots = torus.all({-2, 0, 0}, {1, 0, 0}, 0.0, 10.0, run);
    ASSERT_EQ(roots.size(), 4U);
    const double expected[] = {0.5, 1.5, 2.5, 3.5};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_DOUBLE_EQ(roots[i].t, expected[i]);
        EXPECT_EQ(roots[i].side, i % 2 == 0 ? 1 : -1);
    }
}

TEST(RayRoots, AgreeWithSturmOnRandomRays) {
    const unsigned seed = 11;
    std::mt19937_64 random(seed);
    const auto uniform = [&random] { return std::uniform_real_distribution<>(-1.0, 1.0)(random); };
    base::Run run;
    for (const auto& [name, f] : test::surfaces()) {
        const RayRoots rays(f);
        const int rounds = f.total_degree() > 10 ? 1 : 20;
        for (int round = 0; round < rounds; ++round) {
            const glm::dvec3 origin{3.0 * uniform(), 3.0 * uniform(), 3.0 * uniform()};
            // Some rays through the origin, where many of the surfaces have symmetric, close or double roots.
            const glm::dvec3 direction =
                round % 5 == 0 ? -origin : glm::dvec3{uniform(), uniform(), uniform()};
            const double upper = 1.0 + 4.0 * std::abs(uniform());
            const RayRoot root = rays.first(origin, direction, 0.0, upper, run);
            const test::SturmSequence sturm(test::rational(restrict_to_ray(f, origin, direction, run)));
            const std::string what =
                name + ", seed " + std::to_string(seed) + ", round " + std::to_string(round);
            if (root.kind == Kind::none) {
                EXPECT_EQ(sturm.roots(0, mpq_class(upper)), 0) << what;
                continue;
            }
            const double margin = 1e-8 * upper;
            const mpq_class before(std::max(root.t - margin, 0.0));
            if (root.t > margin) {
                EXPECT_EQ(sturm.roots(0, before), 0) << what;
            }
            EXPECT_GE(sturm.roots(before, mpq_class(std::min(root.t + margin, upper))), 1) << what;
        }
    }
}

TEST(RayRoots, Errors) {
    const double nan = std::nan("");
    EXPECT_THROW(first("x", {nan, 0, 0}, {1, 0, 0}), base::DomainError);
    EXPECT_THROW(first("x", {0, 0, 0}, {infinity, 0, 0}), base::DomainError);
    EXPECT_THROW(first("x", {0, 0, 0}, {1, 0, 0}, nan, 1.0), base::DomainError);
    EXPECT_THROW(first("x", {0, 0, 0}, {1, 0, 0}, 0.0, nan), base::DomainError);
    EXPECT_THROW(first("x", {0, 0, 0}, {1, 0, 0}, -infinity, 0.0), base::DomainError);
    EXPECT_THROW(
        RayRoots(parse_polynomial(Ring(CoefficientField::rationals(), {"x", "y", "z", "w"}), {"x", "f"})),
        base::DomainError);
}

} // namespace
} // namespace eliminant::field
