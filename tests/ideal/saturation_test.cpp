#include "eliminant/ideal/operations.hpp"

#include "ideal/support.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace eliminant::ideal {
namespace {

const Ring xyz(CoefficientField::rationals(), {"x", "y", "z"});

/// I : f, (I : f) : f, … until it stays: the slow twin.
Ideal repeated_quotient(Ideal I, const Polynomial& f, base::Run& run) {
    for (;;) {
        Ideal next = quotient(I, f, run);
        if (I.contains(next, run)) return I;
        I = std::move(next);
    }
}

TEST(Saturation, IsTheLimitOfQuotients) {
    base::Run run;
    for_random_pairs(31, [&](const Ideal& I, const Ideal& J, Random& random) {
        const Polynomial x = Polynomial::variable(I.ring(), random() % 3);
        const Polynomial y = Polynomial::variable(I.ring(), random() % 3);
        std::vector<Polynomial> divisors = J.generators();
        divisors.push_back(x);
        divisors.push_back(x * x * y);
        if (!J.is_zero()) divisors.push_back(x * J.generators()[0] * J.generators()[0]);
        for (const Polynomial& f : divisors) {
            const Ideal S = saturate(I, f, run);
            EXPECT_TRUE(S.equals(repeated_quotient(I, f, run), run)) << describe(f);
            EXPECT_EQ(S.is_unit(run), radical_contains(I, f, run)) << describe(f);
        }
    });
}

TEST(Saturation, ByAnIdealRemovesWhatLiesOnIt) {
    base::Run run;
    for_random_pairs(32, [&](const Ideal& I, const Ideal& J, Random&) {
        const Ideal S = saturate(I, J, run);
        EXPECT_TRUE(S.contains(I, run));
        EXPECT_TRUE(quotient(S, J, run).equals(S, run));
        Ideal limit = I;
        for (Ideal next = quotient(I, J, run); !limit.contains(next, run); next = quotient(limit, J, run))
            limit = next;
        EXPECT_TRUE(S.equals(limit, run));
    });
}

TEST(Saturation, KnowsWeightedHomogeneousIdeals) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"},
                    MonomialOrder::weighted({1, 2, 3}, MonomialOrder::TieBreak::revlex));
    const auto [x, y, z] = variables<3>(ring);
    const Ideal curve = ideal_of({y - x * x, z - x * y}); // (t, t², t³), homogeneous for the weights
    const Polynomial f = x * y + z;
    const Ideal with_junk = product(curve, power(ideal_of({f, x * z}), 2, run), run);
    EXPECT_TRUE(saturate(with_junk, f, run).equals(curve, run));
    EXPECT_TRUE(saturate(with_junk, f * f * x, run).equals(curve, run));
    const Polynomial mixed = f * f + x; // not homogeneous
    EXPECT_TRUE(saturate(with_junk, mixed, run).equals(repeated_quotient(with_junk, mixed, run), run));
}

TEST(Saturation, FindsTheTwistedCubicInItsFirstTwoQuadrics) {
    // Cox, Little, O'Shea, §8.4: (xz − y², xw − yz) is the twisted cubic and a line.
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z", "w"});
    const auto [x, y, z, w] = variables<4>(ring);
    const Ideal two = ideal_of({x * z - y * y, x * w - y * z});
    const Ideal cubic = ideal_of({x * z - y * y, x * w - y * z, y * w - z * z});
    EXPECT_TRUE(saturate(two, x, run).equals(cubic, run));
    EXPECT_TRUE(saturate(two, ideal_of({x, y}), run).equals(cubic, run));
    EXPECT_TRUE(quotient(two, cubic, run).equals(ideal_of({x, y}), run));
}

TEST(RadicalMembership, AgreesWithPowers) {
    base::Run run;
    for_random_pairs(51, [&](const Ideal& I, const Ideal& J, Random&) {
        for (const Polynomial& f : J.generators()) {
            // In these small ideals a power that is ever in I is in it soon.
            bool some_power = false;
            Polynomial p = number(I.ring(), 1);
            for (int k = 0; k < 8 && !some_power; ++k) {
                p = I.normal_form(p * f, run);
                some_power = p.is_zero();
            }
            EXPECT_EQ(radical_contains(I, f, run), some_power) << describe(f);
        }
    });
    EXPECT_TRUE(radical_contains(Ideal(xyz), Polynomial(xyz), run));
    EXPECT_FALSE(radical_contains(Ideal(xyz), number(xyz, 1), run));
    EXPECT_TRUE(radical_contains(Ideal::unit(xyz), number(xyz, 1), run));
}

} // namespace
} // namespace eliminant::ideal
