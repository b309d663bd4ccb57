#include "eliminant/algebra/arithmetic.hpp"

#include "support/random_polynomials.hpp"

#include <gtest/gtest.h>

using namespace eliminant;

namespace {

TEST(Pow, IsRepeatedMultiplication) {
    for (std::uint64_t seed = 1; seed <= 24; ++seed) {
        std::mt19937_64 random(seed);
        const std::size_t n = 1 + seed % 4;
        for (const auto& field : {CoefficientField::rationals(), CoefficientField::prime(2),
                                  CoefficientField::prime(7), CoefficientField::prime(2147483647)}) {
            for (const auto& order : eliminant::testing::every_order(n, random)) {
                const Ring ring(field, eliminant::testing::variable_names(n), order);
                const std::uint64_t largest = seed % 3 == 0 ? std::uint64_t{1} << 40 : 5;
                const Polynomial f = eliminant::testing::random_polynomial(
                    ring, random, {1 + random() % 5, largest, 1, 40, true});
                Polynomial expected = Polynomial::constant(ring, 1);
                for (std::uint64_t k = 0; k <= 6; ++k) {
                    EXPECT_EQ(pow(f, k), expected)
                        << "seed " << seed << ", " << ring.to_string() << ", power " << k;
                    expected *= f;
                }
            }
        }
    }
}

TEST(Pow, FindsLargeBinomialPowers) {
    const Ring ring(CoefficientField::rationals(), {"x"});
    const Polynomial f = pow(Polynomial::variable(ring, 0) + Polynomial::constant(ring, 1), 2000);
    ASSERT_EQ(f.size(), 2001U);
    mpz_class expected;
    for (const unsigned long k : {0UL, 1UL, 700UL, 1000UL, 2000UL}) {
        mpz_bin_uiui(expected.get_mpz_t(), 2000, k);
        EXPECT_EQ(f.coefficient(k), mpq_class(expected));
    }
}

TEST(Pow, HandlesItsLimits) {
    const Ring ring(CoefficientField::rationals(), {"x"});
    const Polynomial x = Polynomial::variable(ring, 0);
    EXPECT_EQ(pow(Polynomial(ring), 0), Polynomial::constant(ring, 1));
    EXPECT_TRUE(pow(Polynomial(ring), 5).is_zero());
    const std::uint64_t largest = (std::uint64_t{1} << 63) - 1;
    EXPECT_EQ(pow(-x, largest).degree(0), static_cast<std::int64_t>(largest));
    EXPECT_EQ(pow(-x, largest).leading_coefficient(), -1);
    EXPECT_THROW(pow(x, largest + 1), OverflowError);
    EXPECT_THROW(pow(x * x, largest), OverflowError);
    EXPECT_THROW(pow(Polynomial::constant(ring, 2), largest), OverflowError);
    EXPECT_EQ(pow(Polynomial::constant(ring, -1), ~std::uint64_t{0}), Polynomial::constant(ring, -1));
    base::Run run;
    run.request_stop();
    EXPECT_THROW(static_cast<void>(pow(x + Polynomial::constant(ring, 1), 100, run)), Stopped);
}

} // namespace
