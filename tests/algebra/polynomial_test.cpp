#include "eliminant/algebra/arithmetic.hpp"
#include "support/random_polynomials.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace eliminant;
using eliminant::testing::random_polynomial;
using eliminant::testing::sample_rings;

namespace {

TEST(Polynomial, SatisfiesTheRingAxiomsInEveryOrderAndField) {
    std::mt19937_64 random(1);
    for (const Ring& ring : sample_rings()) {
        for (int round = 0; round < 10; ++round) {
            const Polynomial a = random_polynomial(ring, random, 8, 5);
            const Polynomial b = random_polynomial(ring, random, 8, 5);
            const Polynomial c = random_polynomial(ring, random, 8, 200);
            EXPECT_EQ(a + b, b + a) << ring.to_string();
            EXPECT_EQ((a + b) + c, a + (b + c)) << ring.to_string();
            EXPECT_EQ(a * b, b * a) << ring.to_string();
            EXPECT_EQ((a * b) * c, a * (b * c)) << ring.to_string();
            EXPECT_EQ(a * (b + c), a * b + a * c) << ring.to_string();
            EXPECT_TRUE((a - a).is_zero()) << ring.to_string();
            EXPECT_EQ(a + (-b), a - b) << ring.to_string();
        }
    }
}

TEST(Polynomial, KeepsItsTermsStrictlyDecreasing) {
    std::mt19937_64 random(2);
    for (const Ring& ring : sample_rings()) {
        const Polynomial f = random_polynomial(ring, random, 30, 9) * random_polynomial(ring, random, 30, 9);
        for (std::size_t i = 1; i < f.size(); ++i)
            EXPECT_GT(f.monomial(i - 1), f.monomial(i)) << ring.to_string();
    }
}

TEST(Polynomial, DividesWithTheTextbookIdentity) {
    std::mt19937_64 random(3);
    base::Run run;
    for (const Ring& ring : sample_rings()) {
        const Polynomial f = random_polynomial(ring, random, 12, 6);
        std::vector<Polynomial> divisors;
        for (int i = 0; i < 3; ++i) {
            const Polynomial g = random_polynomial(ring, random, 3, 3);
            if (!g.is_zero()) divisors.push_back(g);
        }
        const Division division = divide(f, divisors, run);
        Polynomial sum = division.remainder;
        for (std::size_t i = 0; i < divisors.size(); ++i) sum += division.quotients[i] * divisors[i];
        EXPECT_EQ(sum, f) << ring.to_string();
        for (std::size_t i = 0; i < division.remainder.size(); ++i) {
            for (const Polynomial& g : divisors)
                EXPECT_FALSE(g.leading_monomial().divides(division.remainder.monomial(i)))
                    << ring.to_string();
        }
    }
}

} // namespace
