// Curvatures against surfaces on which they are known, and projections against their definition.
#include "eliminant/field/curvature.hpp"
#include "eliminant/field/projection.hpp"

#include "field/surfaces.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace eliminant {
namespace {

Curvatures at(const char* text, const glm::dvec3& p) {
    return curvatures(CompiledPolynomial(test::polynomial(text)).jet(p)).value();
}

TEST(Curvature, of_a_sphere_is_one_over_its_radius) {
    const Curvatures c = at("x^2+y^2+z^2-4", {2.0 / 3, 4.0 / 3, -4.0 / 3});
    EXPECT_NEAR(c.mean, 0.5, 1e-14);
    EXPECT_NEAR(c.gaussian, 0.25, 1e-14);
    EXPECT_NEAR(c.principal[0], 0.5, 1e-7); // an umbilic: the root of a difference
    // The other orientation.
    EXPECT_NEAR(at("4-x^2-y^2-z^2", {0, 0, 2}).mean, -0.5, 1e-14);
}

TEST(Curvature, of_a_cylinder_has_its_directions) {
    const Curvatures c = at("x^2+y^2-1/4", {0.3, 0.4, 7});
    EXPECT_NEAR(c.principal[0], 2, 1e-13);
    EXPECT_NEAR(c.principal[1], 0, 1e-13);
    EXPECT_NEAR(c.gaussian, 0, 1e-13);
    EXPECT_NEAR(std::abs(c.directions[1].z), 1, 1e-13);
    EXPECT_NEAR(std::abs(glm::dot(c.directions[0], glm::dvec3(-0.8, 0.6, 0))), 1, 1e-13);
}

TEST(Curvature, of_a_torus) {
    // Radii 1 and 2/5. Outside κ = 5/2 and 1/(1 + 2/5), inside 5/2 and −1/(1 − 2/5).
    const char* torus = "(x^2+y^2+z^2+21/25)^2-4*(x^2+y^2)";
    const Curvatures outside = at(torus, {1.4, 0, 0});
    EXPECT_NEAR(outside.principal[0], 2.5, 1e-13);
    EXPECT_NEAR(outside.principal[1], 1 / 1.4, 1e-13);
    EXPECT_NEAR(at(torus, {0, 0.6, 0}).gaussian, -2.5 / 0.6, 1e-12);
    EXPECT_NEAR(at(torus, {0.6, 0.8, 0.4}).gaussian, 0, 1e-13);
}

TEST(Curvature, is_nothing_at_singular_points) {
    EXPECT_FALSE(curvatures(CompiledPolynomial(test::polynomial("x^2-y^2*z")).jet({0, 0, 1})).has_value());
    EXPECT_FALSE(curvatures(CompiledPolynomial(test::polynomial("x^9")).jet({1e300, 0, 0})).has_value());
}

TEST(Projection, of_known_points) {
    const DistanceField sphere(test::polynomial("x^2+y^2+z^2-1"));
    const Projection p = project(sphere, {2, -4, 4}).value();
    EXPECT_NEAR(glm::length(p.foot - glm::dvec3(1, -2, 2) / 3.0), 0, 1e-15);
    EXPECT_LE(p.radius, 1e-14);
    EXPECT_LE(p.lower, 5);
    EXPECT_GE(p.upper, 5);
    EXPECT_NEAR(p.upper, 5, 1e-13);
    EXPECT_NEAR(p.lower, 5, 1e-10);
    EXPECT_EQ(project(sphere, {0, 1, 0})->upper, 0);
    EXPECT_FALSE(project(sphere, {NAN, 0, 0}).has_value());
    EXPECT_FALSE(project(DistanceField(test::polynomial("x^2+y^2+z^2+1")), {1, 2, 3}).has_value());
    EXPECT_FALSE(project(DistanceField(test::polynomial("(x^2-2)^2")), {1, 2, 3}).has_value());
}

TEST(Projection, is_on_the_surface_and_the_way_is_normal) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (const test::Surface& surface : test::surfaces()) {
        if (surface.polynomial.size() > 1000) continue;
        const DistanceField field(surface.polynomial);
        int found = 0;
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 point(normal(random), normal(random), normal(random));
            const auto result = project(field, point);
            if (!result) continue;
            ++found;
            EXPECT_LE(result->lower, result->upper) << surface.name;
            EXPECT_LE(distance(field, result->foot, DistanceLevel::guaranteed).value,
                      result->radius * (1 + 1e-12))
                << surface.name;
        }
        // Some are nearest to a line on which the surface is real but f does not change its sign.
        EXPECT_GE(found, 15) << surface.name;
    }
}

TEST(Projection, near_the_bicubic_where_doubles_see_noise) {
    const DistanceField field(test::surface("bicubic18"));
    const auto result = project(field, {0.5, 0.4, 0.3});
    ASSERT_TRUE(result.has_value());
    EXPECT_LE(result->radius, 1e-12);
    const Jet jet = field.polynomial().jet(result->foot);
    // Within 1e-8 of the surface: the sign is right on both sides, and the bound is no larger than the way
    // back.
    const glm::dvec3 n = glm::normalize(jet.gradient);
    for (const double h : {1e-8, -1e-8, 1e-10, -1e-10}) {
        const glm::dvec3 p = result->foot + h * n;
        const Distance bound = distance(field, p, DistanceLevel::guaranteed);
        EXPECT_LE(bound.value, std::abs(h) * (1 + 1e-5) + result->radius);
        EXPECT_GE(bound.value, 0.9 * std::abs(h));
        EXPECT_EQ(bound.sign, h > 0 ? 1 : -1);
    }
}

} // namespace
} // namespace eliminant
