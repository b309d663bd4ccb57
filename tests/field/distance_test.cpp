// Distances: the bound against true distances, the estimates against their definitions.
#include "eliminant/field/distance.hpp"

#include "field/surfaces.hpp"

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

} // namespace
} // namespace eliminant
