// Distances: the bound against true distances, the estimates against their definitions.
#include "eliminant/field/distance.hpp"

#include "eliminant/base/error.hpp"

#include "field/surfaces.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace eliminant {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

glm::dvec3 random_in_ball(std::mt19937_64& random, double radius) {
    std::uniform_real_distribution<double> coordinate(-radius, radius);
    for (;;) {
        const glm::dvec3 p(coordinate(random), coordinate(random), coordinate(random));
        if (glm::length(p) <= radius) return p;
    }
}

double value(const DistanceField& f, const glm::dvec3& p, DistanceLevel level) {
    return distance(f, p, level).value;
}

/// A surface whose true distance is known.
struct Known {
    const char* text;
    double (*distance)(const glm::dvec3&);
    double least_mean_ratio; ///< over points within 2 of the origin
};

const Known known[] = {
    {"x^2+y^2+z^2-1", [](const glm::dvec3& p) { return std::abs(glm::length(p) - 1); }, 0.99},
    {"2x-y+2z-3", [](const glm::dvec3& p) { return std::abs(2 * p.x - p.y + 2 * p.z - 3) / 3; }, 0.999},
    {"x^2+y^2-1/4", [](const glm::dvec3& p) { return std::abs(std::hypot(p.x, p.y) - 0.5); }, 0.5},
    {"(x^2+y^2+z^2+21/25)^2-4*(x^2+y^2)",
     [](const glm::dvec3& p) { return std::abs(std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.4); }, 0.36},
    {"x*(y-1)", [](const glm::dvec3& p) { return std::min(std::abs(p.x), std::abs(p.y - 1)); }, 0.5},
    {"(x^2+y^2+z^2)*(x-3)", [](const glm::dvec3& p) { return std::min(glm::length(p), std::abs(p.x - 3)); },
     0.1},
};

TEST(Distance, bound_is_below_the_true_distance) {
    std::mt19937_64 random(7);
    for (const Known& surface : known) {
        const DistanceField f(test::polynomial(surface.text));
        double sum = 0;
        constexpr int count = 100'000;
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 p = random_in_ball(random, 2);
            const double bound = value(f, p, DistanceLevel::guaranteed);
            const double truth = surface.distance(p);
            ASSERT_LE(bound, truth * (1 + 1e-14))
                << surface.text << " at " << p.x << ' ' << p.y << ' ' << p.z;
            sum += truth > 0 ? bound / truth : 1;
        }
        EXPECT_GE(sum / count, surface.least_mean_ratio) << surface.text;
        RecordProperty(surface.text, std::to_string(sum / count));
    }
}

TEST(Distance, bound_is_tight_within_two_units_of_the_surface) {
    // Uniform by volume within 2 units of the surface: the ball of radius 3, and the torus' neighbourhood.
    std::mt19937_64 random(8);
    for (const std::size_t index : {0UL, 3UL}) {
        const DistanceField f(test::polynomial(known[index].text));
        double sum = 0;
        int count = 0;
        while (count < 20'000) {
            const glm::dvec3 p = random_in_ball(random, 3.4);
            const double truth = known[index].distance(p);
            if (truth > 2 || truth == 0) continue;
            sum += value(f, p, DistanceLevel::guaranteed) / truth;
            ++count;
        }
        EXPECT_GE(sum / count, index == 0 ? 0.99 : 0.45) << known[index].text;
        RecordProperty(known[index].text, std::to_string(sum / count));
    }
}

TEST(Distance, errors_of_the_estimates_on_the_sphere_are_quadratic_with_known_constants) {
    // Outside the unit sphere the first order errs by −h²/2, the second one, with the spectral norm 2, by
    // −h², and with Frobenius' norm 2√3 by −(1 + √3)h²/2. The printed formula without |f| (eq. 106 of a
    // thesis) has no value inside.
    const DistanceField f(test::polynomial("x^2+y^2+z^2-1"));
    const struct {
        DistanceLevel level;
        double outside;
        double inside;
    } cases[] = {
        {DistanceLevel::first_order, -0.5, 0.5},
        {DistanceLevel::second_order, -1, 0},
        {DistanceLevel::second_order_frobenius, -(1 + std::sqrt(3.0)) / 2, (1 - std::sqrt(3.0)) / 2}};
    for (const auto& expected : cases)
        for (const double h : {1e-3, 1e-4}) {
            const double outside = value(f, {0, 0, 1 + h}, expected.level) - h;
            EXPECT_NEAR(outside / (h * h), expected.outside, 5 * h) << to_string(expected.level);
            const double inside = value(f, {0, 0, 1 - h}, expected.level) - h;
            EXPECT_NEAR(inside / (h * h), expected.inside, 5 * h) << to_string(expected.level);
        }
}

TEST(Distance, first_order_is_no_bound) {
    // |f|/‖∇f‖ exceeds the distance inside the sphere (Proposition 1.2 of a thesis calls it a bound); |f|·L,
    // the reverse of |f|/L, would be none either.
    const DistanceField f(test::polynomial("x^2+y^2+z^2-1"));
    EXPECT_GT(value(f, {0.1, 0, 0}, DistanceLevel::first_order), 4);
    EXPECT_LE(value(f, {0.1, 0, 0}, DistanceLevel::guaranteed), 0.9);
    EXPECT_NEAR(value(f, {0.1, 0, 0}, DistanceLevel::guaranteed), 0.9, 1e-9);
}

TEST(Distance, levels_are_ordered_and_the_exact_ones_agree) {
    std::mt19937_64 random(12);
    base::Run run;
    for (const test::Surface& surface : test::surfaces()) {
        const DistanceField f(surface.polynomial);
        const int count = surface.polynomial.size() > 1000 ? 2 : 30;
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 p = random_in_ball(random, 2);
            const std::array<mpq_class, 3> exact = {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
            for (const DistanceLevel level :
                 {DistanceLevel::first_order, DistanceLevel::second_order,
                  DistanceLevel::second_order_frobenius, DistanceLevel::guaranteed}) {
                const Distance fast = distance(f, p, level);
                const Distance slow = distance(surface.polynomial, exact, level, run);
                EXPECT_EQ(fast.sign, slow.sign) << surface.name;
                const double tolerance = level == DistanceLevel::guaranteed ? 1e-3 : 1e-7;
                EXPECT_NEAR(fast.value, slow.value, tolerance * slow.value)
                    << surface.name << to_string(level);
            }
            EXPECT_LE(value(f, p, DistanceLevel::second_order), value(f, p, DistanceLevel::first_order));
            EXPECT_LE(value(f, p, DistanceLevel::second_order_frobenius),
                      value(f, p, DistanceLevel::second_order) * (1 + 1e-7));
        }
    }
}

TEST(Distance, special_points) {
    const DistanceField sphere(test::polynomial("x^2+y^2+z^2-1"));
    const auto all = {DistanceLevel::first_order, DistanceLevel::second_order,
                      DistanceLevel::second_order_frobenius, DistanceLevel::guaranteed};
    for (const DistanceLevel level : all) {
        const Distance on = distance(sphere, {0, 1, 0}, level);
        EXPECT_EQ(on.value, 0);
        EXPECT_EQ(on.sign, 0);
        const Distance zero = distance(DistanceField(test::polynomial("0")), {0, 1, 0}, level);
        EXPECT_EQ(zero.value, 0);
        const Distance constant = distance(DistanceField(test::polynomial("-7")), {0, 1, 0}, level);
        EXPECT_EQ(constant.value, infinity);
        EXPECT_EQ(constant.sign, -1);
        for (const double bad : {infinity, -infinity, std::nan("")}) {
            const Distance nowhere = distance(sphere, {0, bad, 0}, level);
            EXPECT_EQ(nowhere.sign, 0);
            if (level == DistanceLevel::guaranteed)
                EXPECT_EQ(nowhere.value, 0);
            else
                EXPECT_TRUE(std::isnan(nowhere.value));
        }
        // Where the fourth power overflows and where it underflows.
        const DistanceField torus(test::surface("torus"));
        const double far = value(torus, {1e200, 0, 0}, level);
        EXPECT_GT(far, 1e198) << to_string(level);
        EXPECT_LE(far, 1e200);
        const double near = value(DistanceField(test::polynomial("x^2+y^2-z^2")), {1e-200, 0, 0}, level);
        EXPECT_GT(near, 1e-201) << to_string(level);
        EXPECT_LE(near, 1e-200);
    }
    // At the center the gradient is 0.
    EXPECT_EQ(value(sphere, {0, 0, 0}, DistanceLevel::first_order), infinity);
    EXPECT_NEAR(value(sphere, {0, 0, 0}, DistanceLevel::second_order), 1, 1e-15);
    EXPECT_NEAR(value(sphere, {0, 0, 0}, DistanceLevel::guaranteed), 1, 1e-12);
    EXPECT_LE(value(sphere, {0, 0, 0}, DistanceLevel::guaranteed), 1);
    // Value and derivatives of order two vanish: only the bound sees the surface.
    const DistanceField cubic(test::polynomial("x^3-8"));
    EXPECT_EQ(value(cubic, {0, 1, 0}, DistanceLevel::second_order), infinity);
    EXPECT_NEAR(value(cubic, {0, 1, 0}, DistanceLevel::guaranteed), 2, 1e-11);
    EXPECT_LE(value(cubic, {0, 1, 0}, DistanceLevel::guaranteed), 2);
    // No real point at all.
    EXPECT_EQ(value(DistanceField(test::polynomial("x^2+y^2+z^2+1")), {0, 0, 0}, DistanceLevel::guaranteed),
              infinity);
}

TEST(Distance, near_singular_points_and_the_medial_axis) {
    std::mt19937_64 random(21);
    std::uniform_real_distribution<double> unit(-1, 1);
    const DistanceField cone(test::polynomial("x^2+y^2-z^2"));
    const DistanceField torus(test::surface("torus"));
    for (int i = 0; i < 20'000; ++i) {
        const double size = std::ldexp(1.0, -static_cast<int>(random() % 200));
        const glm::dvec3 p = size * glm::dvec3(unit(random), unit(random), unit(random));
        const double truth = std::abs(std::hypot(p.x, p.y) - std::abs(p.z)) / std::sqrt(2.0);
        const double bound = value(cone, p, DistanceLevel::guaranteed);
        EXPECT_LE(bound, truth * (1 + 1e-12) + 1e-15 * size);
        EXPECT_GE(bound, truth * 0.2);
        const double angle =
            3 * unit(random); // next to the core circle of the torus, where the distance is 0.4
        const glm::dvec3 q = glm::dvec3(std::cos(angle), std::sin(angle), 0) + std::min(size, 0.01) * p;
        EXPECT_LE(value(torus, q, DistanceLevel::guaranteed),
                  0.4 - std::hypot(std::hypot(q.x, q.y) - 1, q.z) + 1e-15);
    }
}

/// The least distance of a point from the zeros of f inside a cube around it, by subdivision: cubes without
/// zeros, or farther than what was found, are dropped by the bound of Taylor's theorem *at their centers* and
/// by the triangle inequality; a sign change between center and corners gives an upper bound.
struct Enclosure {
    double lower;
    double upper;
};
Enclosure enclose_distance(const DistanceField& f, const glm::dvec3& p, double half_side, int depth) {
    struct Cube {
        glm::dvec3 center;
        double half;
    };
    std::vector<Cube> cubes = {{p, half_side}};
    Enclosure result{infinity, infinity};
    for (int level = 0; level < depth; ++level) {
        std::vector<Cube> next;
        result.lower = half_side;
        for (const Cube& cube : cubes)
            for (int octant = 0; octant < 8; ++octant) {
                const glm::dvec3 sign((octant & 1) != 0 ? 1 : -1, (octant & 2) != 0 ? 1 : -1,
                                      (octant & 4) != 0 ? 1 : -1);
                const Cube child{cube.center + 0.5 * cube.half * sign, cube.half / 2};
                const double radius = child.half * std::sqrt(3.0) * (1 + 1e-14);
                const double nearest = glm::length(child.center - p) - radius;
                if (nearest > result.upper || distance_from_ball(f, child.center, radius) > 0) continue;
                const glm::dvec3 corner = child.center + child.half;
                if (f.polynomial().sign(corner) * f.polynomial().sign(corner - 2 * child.half) <= 0)
                    result.upper = std::min(result.upper, glm::length(child.center - p) + radius);
                result.lower = std::min(result.lower, std::max(0.0, nearest));
                next.push_back(child);
            }
        cubes = std::move(next);
    }
    return result;
}

TEST(Distance, bound_against_certified_minimisation) {
    std::mt19937_64 random(31);
    for (const test::Surface& surface : test::surfaces()) {
        if (surface.polynomial.size() > 1000) continue;
        const DistanceField f(surface.polynomial);
        double ratios = 0;
        int count = 0;
        for (int i = 0; i < 12; ++i) {
            const glm::dvec3 p = random_in_ball(random, 1.5);
            const Enclosure truth = enclose_distance(f, p, 1.0, 6);
            const double bound = value(f, p, DistanceLevel::guaranteed);
            EXPECT_LE(bound, truth.upper) << surface.name;
            if (truth.upper > 1) continue;
            EXPECT_LE(truth.lower, truth.upper);
            ratios += bound / truth.upper;
            ++count;
        }
        if (count > 0) RecordProperty(surface.name, std::to_string(ratios / count));
    }
}

TEST(Distance, of_regions) {
    std::mt19937_64 random(41);
    const DistanceField f(test::surface("torus"));
    for (int i = 0; i < 2'000; ++i) {
        const glm::dvec3 center = random_in_ball(random, 2);
        const double radius = 0.2 * std::abs(random_in_ball(random, 1).x);
        const double bound = distance_from_ball(f, center, radius);
        const glm::dvec3 inside = center + random_in_ball(random, 1) * radius;
        EXPECT_LE(bound, known[3].distance(inside) * (1 + 1e-12) + 1e-15);
        const glm::dvec3 half = glm::abs(random_in_ball(random, 0.1));
        const double box = distance_from_box(f, center - half, center + half);
        EXPECT_LE(box, known[3].distance(center + half * random_in_ball(random, 1)) * (1 + 1e-12) + 1e-15);
        EXPECT_LE(box, distance_from_ball(f, center, 0));
    }
    EXPECT_THROW(distance_from_ball(f, {0, 0, 0}, -1), DomainError);
    EXPECT_THROW(distance_from_ball(f, {0, 0, 0}, std::nan("")), DomainError);
    EXPECT_THROW(distance_from_box(f, {0, 0, 1}, {1, 1, 0}), DomainError);
}

TEST(Distance, of_polynomials_too_large_to_expand_is_bounded_coarsely) {
    const DistanceField f(test::polynomial("x^200*y^200*z^200+x^2+y^2+z^2-1"));
    for (const double x : {0.25, 0.5, 0.9}) {
        const double bound = value(f, {x, 0, 0}, DistanceLevel::guaranteed);
        EXPECT_LE(bound, 1 - x);
        EXPECT_GE(bound, 0);
    }
    EXPECT_GT(value(f, {0.25, 0, 0}, DistanceLevel::guaranteed), 0.3);
}

} // namespace
} // namespace eliminant
