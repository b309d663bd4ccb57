// Bounds and the search for first roots by them, against exact arithmetic.
#include "field/bounds.hpp"
#include "field/sparse_ray.hpp"
#include "field/surfaces.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>

namespace eliminant::field {
namespace {

using test::polynomial;

bool holds(Bounds bounds, const mpq_class& exact) {
    return mpq_class(bounds.lower) <= exact && exact <= mpq_class(bounds.upper);
}

TEST(Bounds, HoldTheExactResults) {
    const unsigned seed = 7;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> number(-2, 2);
    std::uniform_real_distribution<double> scale(-60, 2);
    for (int round = 0; round < 2000; ++round) {
        const auto draw = [&] { return number(random) * std::exp2(scale(random)); };
        const double a = draw();
        const double b = draw();
        const mpq_class p(a);
        const mpq_class q(b);
        const Bounds x{a, a};
        const Bounds y{b, b};
        EXPECT_TRUE(holds(x + y, p + q)) << "seed " << seed << ", round " << round;
        EXPECT_TRUE(holds(x - y, p - q)) << "seed " << seed << ", round " << round;
        EXPECT_TRUE(holds(x * y, p * q)) << "seed " << seed << ", round " << round;
        EXPECT_TRUE(holds(x / y, p / q)) << "seed " << seed << ", round " << round;
        const auto exponent = static_cast<std::size_t>(random() % 60);
        mpq_class exact = 1;
        for (std::size_t i = 0; i < exponent; ++i) exact *= p;
        EXPECT_TRUE(holds(power(x, exponent), exact)) << "seed " << seed << ", round " << round;
        // An interval's power holds those of its points.
        EXPECT_TRUE(holds(power({std::min(a, b), std::max(a, b)}, exponent), exact));
    }
}

TEST(SparseRay, AgreesWithExactRoots) {
    const unsigned seed = 5;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    base::Run run;
    int answered = 0;
    int met = 0;
    for (const char* text : {"x^30+y^30+z^30-1", "x^24*y-3*x*y^7+z^40-1/2", "x^20*y^3-z^19+x*y*z-1/100",
                             "x^41-x*y+z^2/3", "7*y^64-5"}) {
        const algebra::Polynomial f = polynomial(text);
        ASSERT_TRUE(SparseRay::is_for(f)) << text;
        const SparseRay sparse(f);
        const RayRoots roots(f);
        for (int round = 0; round < 12; ++round) {
            const glm::dvec3 origin(2 * number(random), 2 * number(random), 2 * number(random));
            const glm::dvec3 direction(number(random), number(random), number(random));
            const std::string what =
                std::string(text) + ", seed " + std::to_string(seed) + ", round " + std::to_string(round);
            const auto found = sparse.first(origin, direction, -1.5, 2.25, run);
            if (!found) continue;
            ++answered;
            const auto exact = roots.all(origin, direction, -1.5, 2.25, run);
            ASSERT_EQ(found->kind == RayRoot::Kind::none, exact.empty()) << what;
            if (exact.empty()) continue;
            ++met;
            EXPECT_NEAR(found->t, exact.front().t, 1e-8) << what;
            EXPECT_EQ(found->side, exact.front().side) << what;
            EXPECT_EQ(found->kind, exact.front().kind) << what;
        }
    }
    EXPECT_GT(answered, 50); // of 60
    EXPECT_GT(met, 20);
}

TEST(SparseRay, LeavesWhatItCannotTell) {
    base::Run run;
    const SparseRay tangent(polynomial("(x-1/3)^2*y^20+z^30"));
    // Along y = 1, z = 0 the sign does not change at x = 1/3.
    EXPECT_FALSE(tangent.first({0, 1, 0}, {1, 0, 0}, 0, 1, run));
    const SparseRay plane(polynomial("x^31-x^30"));
    EXPECT_FALSE(plane.first({0, 0, 0}, {1, 0, 0}, 0.5, 1, run));     // a root at the end
    EXPECT_FALSE(plane.first({0, 0, 0}, {1, 0, 0}, 0.5, 1e300, run)); // powers overflow
    const auto root = plane.first({0, 0, 0}, {1, 0, 0}, 0.5, 1e3, run);
    ASSERT_TRUE(root);
    EXPECT_NEAR(root->t, 1, 1e-10);
    EXPECT_EQ(root->side, -1);
    // Along the axes slopes next to the root are of all orders of magnitude.
    const SparseRay cube(polynomial("x^300+y^300+z^300-1"));
    const auto face = cube.first({-5.9974, 0.084, 0.156}, {1, 0, 0}, 0, 11.9948, run);
    ASSERT_TRUE(face);
    EXPECT_NEAR(face->t, 4.9974, 1e-9);
    EXPECT_FALSE(SparseRay::is_for(polynomial("x^2+y^2+z^2-1")));
}

} // namespace
} // namespace eliminant::field
