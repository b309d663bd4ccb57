// Every method of computing gcds, asked by name, against the others.
#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/gcd.hpp"

#include "algebra/gcd_degrees.hpp"
#include "algebra/gcd_modular.hpp"
#include "algebra/gcd_remainders.hpp"
#include "support/random_polynomials.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace eliminant;
using namespace eliminant::algebra;
using namespace eliminant::testing;

namespace {

/// A polynomial that contains every variable and is divisible by none.
Polynomial random_full(const Ring& ring, std::mt19937_64& random, std::size_t terms,
                       std::uint64_t max_exponent, std::uint64_t height) {
    Polynomial f = random_nonzero(ring, random, terms, max_exponent, height);
    for (std::size_t v = 0; v < ring.variable_count(); ++v)
        f += pow(Polynomial::variable(ring, v), max_exponent + 1 + v % 2);
    return f + Polynomial::constant(ring, 1);
}

TEST(GcdMethods, AgreeWithTheConstruction) {
    std::mt19937_64 random(41);
    algebra::Random choices(41);
    base::Run run;
    for (const std::vector<std::string>& names : std::vector<std::vector<std::string>>{
             {"x"}, {"x", "y"}, {"x", "y", "z"}, {"x", "y", "z", "t", "u"}}) {
        for (const Ring& ring : sample_fields(names)) {
            for (int round = 0; round < 4; ++round) {
                const std::uint64_t height = round % 2 == 0 ? 5 : 1U << 30U;
                const Polynomial h = random_full(ring, random, 4, 2, height);
                const Polynomial f = (h * random_full(ring, random, 4, 2, height)).primitive_part();
                const Polynomial g = (h * random_full(ring, random, 4, 2, height)).primitive_part();
                const auto bounds = gcd_degree_bounds(f, g, choices, run);
                const Polynomial expected = gcd(f, g);
                EXPECT_TRUE(try_divide(expected, h)) << ring.to_string();
                for (std::size_t v = 0; v < names.size(); ++v)
                    EXPECT_GE(static_cast<std::int64_t>(bounds[v]), expected.degree(v)) << ring.to_string();
                const auto by_dense = gcd_by_images(f, g, bounds, choices, run, Interpolation::dense);
                ASSERT_TRUE(by_dense) << ring.to_string();
                EXPECT_EQ(*by_dense, expected) << ring.to_string();
                if (names.size() == 1) continue; // nothing to interpolate
                const auto by_sparse = gcd_by_images(f, g, bounds, choices, run, Interpolation::sparse);
                ASSERT_TRUE(by_sparse) << ring.to_string();
                EXPECT_EQ(*by_sparse, expected) << ring.to_string();
            }
        }
    }
}

/// Bounds that no degree reaches ask for the other proof, by coprime cofactors.
TEST(GcdMethods, NeedNoTightBounds) {
    std::mt19937_64 random(46);
    algebra::Random choices(46);
    base::Run run;
    for (const Ring& ring : sample_fields()) {
        const Polynomial h = random_full(ring, random, 4, 2, 10);
        const Polynomial f = (h * random_full(ring, random, 4, 2, 10)).primitive_part();
        const Polynomial g = (h * random_full(ring, random, 4, 2, 10)).primitive_part();
        std::vector<std::uint64_t> bounds;
        for (std::size_t v = 0; v < 3; ++v)
            bounds.push_back(static_cast<std::uint64_t>(std::min(f.degree(v), g.degree(v))));
        for (const auto method : {Interpolation::dense, Interpolation::sparse})
            EXPECT_EQ(gcd_by_images(f, g, bounds, choices, run, method), gcd(f, g)) << ring.to_string();
    }
}

/// Degrees that rule out dense vectors, in a shape that cannot be deflated.
TEST(GcdMethods, LeaveHighDegreesToRemainderSequences) {
    for (const Ring& ring : sample_fields({"x", "y"})) {
        const Polynomial x = Polynomial::variable(ring, 0);
        const Polynomial y = Polynomial::variable(ring, 1);
        const Polynomial one = Polynomial::constant(ring, 1);
        const Polynomial h = pow(x, 1000000000007) * y + one;
        EXPECT_EQ(gcd(h * (x + y), h * (x + y * y + one)), h.primitive_part()) << ring.to_string();
    }
}

TEST(GcdMethods, AgreeWithRemainderSequences) {
    std::mt19937_64 random(42);
    base::Run run;
    for (const Ring& ring : sample_fields({"x", "y"})) {
        for (int round = 0; round < 6; ++round) {
            const Polynomial h = random_nonzero(ring, random, 3, 2);
            const Polynomial f = (h * random_nonzero(ring, random, 4, 2)).primitive_part();
            const Polynomial g = (h * random_nonzero(ring, random, 4, 2)).primitive_part();
            EXPECT_EQ(gcd(f, g), gcd_by_remainders(f, g, run)) << ring.to_string();
        }
    }
}

/// Leading coefficients that are not constant, in every variable, and whose gcd is a proper multiple of that
/// of h: what interpolation of monic images has to undo.
TEST(GcdMethods, CopeWithLeadingCoefficientsThatMeet) {
    base::Run run;
    algebra::Random choices(43);
    for (const Ring& ring : sample_fields()) {
        const Polynomial x = Polynomial::variable(ring, 0);
        const Polynomial y = Polynomial::variable(ring, 1);
        const Polynomial z = Polynomial::variable(ring, 2);
        const Polynomial one = Polynomial::constant(ring, 1);
        const Polynomial h = (y * z + one) * x * x + (y + z) * x + y * y * z + z + one;
        const Polynomial f = (h * ((y + z) * x * x + y * x + z * z + one)).primitive_part();
        const Polynomial g = (h * ((y + z) * (y + one) * x * x + z * x + y + one)).primitive_part();
        const auto bounds = gcd_degree_bounds(f, g, choices, run);
        EXPECT_EQ(gcd(f, g), h.primitive_part()) << ring.to_string();
        EXPECT_EQ(gcd_by_images(f, g, bounds, choices, run, Interpolation::dense), h.primitive_part());
        EXPECT_EQ(gcd_by_images(f, g, bounds, choices, run, Interpolation::sparse), h.primitive_part());
    }
}

TEST(GcdMethods, CopeWithContentsInEveryVariable) {
    std::mt19937_64 random(44);
    for (const Ring& ring : sample_fields()) {
        Polynomial h = Polynomial::constant(ring, 1);
        for (std::size_t v = 0; v < 3; ++v) {
            const Polynomial x = Polynomial::variable(ring, v);
            h *= x * x * x + x + Polynomial::constant(ring, 1);
        }
        h *= random_full(ring, random, 4, 2, 10);
        const Polynomial a = random_full(ring, random, 4, 2, 10);
        const Polynomial b = random_full(ring, random, 4, 2, 10);
        EXPECT_EQ(gcd(h * a, h * b), (h * gcd(a, b)).primitive_part()) << ring.to_string();
    }
}

TEST(GcdMethods, FindHighPowersAndSparseShapes) {
    for (const Ring& ring : sample_fields()) {
        const Polynomial x = Polynomial::variable(ring, 0);
        const Polynomial y = Polynomial::variable(ring, 1);
        const Polynomial one = Polynomial::constant(ring, 1);
        // gcd(x^a − 1, x^b − 1) = x^gcd(a, b) − 1, at degrees that no dense vector holds.
        constexpr std::uint64_t unit = std::uint64_t{1} << 40;
        EXPECT_EQ(gcd(pow(x, 12 * unit) - one, pow(x, 18 * unit) - one), pow(x, 6 * unit) - one);
        const Polynomial h = pow(x, 7 * unit) * y + one;
        EXPECT_EQ(gcd(h * (pow(x, unit) + y), h * (pow(x, unit) - y + one)), h.primitive_part());
        EXPECT_EQ(gcd(pow(x, 1000) - pow(y, 1000), pow(x, 700) - pow(y, 700)), pow(x, 100) - pow(y, 100));
    }
}

TEST(GcdMethods, StopWhenTheirRunDoes) {
    std::mt19937_64 random(45);
    algebra::Random choices(45);
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z", "t", "u"});
    const Polynomial f = random_full(ring, random, 12, 9, 1U << 30U);
    const Polynomial g = random_full(ring, random, 12, 9, 1U << 30U);
    {
        base::Run run;
        run.request_stop();
        EXPECT_THROW(gcd(f, g, run), Stopped);
        EXPECT_THROW(squarefree_part(f, run), Stopped);
    }
    { // Remainder sequences of these would take years.
        base::Run run(base::RunOptions{.time_limit_seconds = 0.05});
        EXPECT_THROW(gcd_by_remainders(f, g, run), Stopped);
    }
    { // Dense images of these, too.
        base::Run run(base::RunOptions{.time_limit_seconds = 0.05});
        const std::vector<std::uint64_t> bounds(5, 9);
        EXPECT_THROW(gcd_by_images(f * f, f * g, bounds, choices, run, Interpolation::dense), Stopped);
    }
    { // Coefficients of a million bits: primes by the ten thousand.
        base::Run run(base::RunOptions{.time_limit_seconds = 0.05});
        const Polynomial huge = Polynomial::constant(ring, mpq_class(mpz_class(1) << 1000000, 1));
        EXPECT_THROW(gcd((f + huge) * f, (f + huge) * g, run), Stopped);
    }
}

} // namespace
