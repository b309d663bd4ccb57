#include "eliminant/ideal/operations.hpp"

#include "ideal/support.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace eliminant::ideal {
namespace {

const Ring xyz(CoefficientField::rationals(), {"x", "y", "z"});

TEST(Operations, SumIsTheLeastIdealAboveBoth) {
    base::Run run;
    for_random_pairs(21, [&](const Ideal& I, const Ideal& J, Random& random) {
        const Ideal S = sum(I, J);
        EXPECT_TRUE(S.contains(I, run) && S.contains(J, run));
        if (I.is_zero() || J.is_zero()) return;
        EXPECT_TRUE(
            S.contains(I.generators()[0] * random_small(I.ring(), random, 2, 1) - J.generators()[0], run));
        EXPECT_TRUE(S.equals(sum(J, I), run));
    });
}

TEST(Operations, ProductLiesInTheIntersection) {
    base::Run run;
    for_random_pairs(22, [&](const Ideal& I, const Ideal& J, Random&) {
        const Ideal P = product(I, J, run);
        const Ideal D = intersect(I, J, run);
        EXPECT_TRUE(D.contains(P, run));
        EXPECT_TRUE(I.contains(D, run) && J.contains(D, run));
        // (I + J)(I ∩ J) ⊆ IJ, so a larger D would show where the sum is the unit ideal, and where D² is not
        // in P.
        EXPECT_TRUE(P.contains(product(sum(I, J), D, run), run));
        EXPECT_TRUE(D.equals(intersect(J, I, run), run));
    });
}

TEST(Operations, ProductOfComaximalIdealsIsTheIntersection) {
    base::Run run;
    Random random(23);
    for (const Ring& ring : testing::sample_rings()) {
        const Polynomial f = random_small(ring, random, 3, 2);
        const Ideal I(ring, {f, random_small(ring, random, 2, 1)});
        const Ideal J(ring, {f + number(ring, 1), random_small(ring, random, 2, 1)});
        EXPECT_TRUE(product(I, J, run).equals(intersect(I, J, run), run)) << describe(I) << describe(J);
    }
}

TEST(Operations, IntersectionOfTheCoordinateAxes) {
    base::Run run;
    const auto [x, y, z] = variables<3>(xyz);
    const std::vector<Ideal> axes = {ideal_of({x, y}), ideal_of({y, z}), ideal_of({x, z})};
    const Ideal together = intersect(axes, run);
    EXPECT_EQ(together.groebner_basis(run), (std::vector{y * z, x * z, x * y}));
    EXPECT_THROW(static_cast<void>(intersect(std::span<const Ideal>(), run)), DomainError);
    // Cox, Little, O'Shea, §4.3, example after Theorem 11.
    EXPECT_TRUE(
        intersect(ideal_of({x * x * y}), ideal_of({x * y * y}), run).equals(ideal_of({x * x * y * y}), run));
}

TEST(Operations, PowerIsRepeatedMultiplication) {
    base::Run run;
    for_random_pairs(24, [&](const Ideal& I, const Ideal&, Random&) {
        EXPECT_TRUE(power(I, 0, run).is_unit(run));
        EXPECT_TRUE(power(I, 1, run).equals(I, run));
        EXPECT_TRUE(power(I, 3, run).equals(product(I, product(I, I, run), run), run));
    });
    const auto [x, y, z] = variables<3>(xyz);
    EXPECT_EQ(power(ideal_of({x, y, z}), 4, run).generators().size(), 15U); // monomials of degree 4
    EXPECT_TRUE(power(Ideal(xyz), 5, run).is_zero());
}

TEST(Operations, QuotientIsTheLargestIdealThatMultipliesIn) {
    base::Run run;
    for_random_pairs(25, [&](const Ideal& I, const Ideal& J, Random&) {
        const Ideal Q = quotient(I, J, run);
        EXPECT_TRUE(I.contains(product(Q, J, run), run));
        EXPECT_TRUE(Q.contains(I, run));
        // What (f·J ⊆ I ⇒ f ∈ Q) says of the elements of I ∩ J divided by a generator of J.
        for (const Polynomial& f : J.generators()) {
            const Ideal part = quotient(I, f, run);
            EXPECT_TRUE(part.contains(Q, run));
            EXPECT_TRUE(product(part, Ideal(I.ring(), {f}), run)
                            .equals(intersect(I, Ideal(I.ring(), {f}), run), run));
        }
    });
}

TEST(Operations, QuotientRemovesAFactor) {
    base::Run run;
    Random random(26);
    for (const Ring& ring : testing::sample_rings()) {
        const Ideal I = random_ideal(ring, random, 2, 3, 2);
        const Polynomial f = random_small(ring, random, 3, 2);
        if (f.is_zero()) continue;
        EXPECT_TRUE(quotient(product(I, ideal_of({f}), run), f, run).equals(I, run))
            << describe(I) << describe(f);
    }
    const auto [x, y, z] = variables<3>(xyz);
    // Cox, Little, O'Shea, §4.4, example after Definition 5: I(V(xz, yz)) : I(V(z)) is the z-axis.
    EXPECT_TRUE(quotient(ideal_of({x * z, y * z}), ideal_of({z}), run).equals(ideal_of({x, y}), run));
}

TEST(Operations, DegenerateQuotients) {
    base::Run run;
    for (const Ring& ring : testing::sample_rings()) {
        const Polynomial x = Polynomial::variable(ring, 0);
        const Ideal I(ring, {x * x});
        const Ideal zero(ring);
        const Ideal unit = Ideal::unit(ring);
        EXPECT_TRUE(quotient(I, Polynomial(ring), run).is_unit(run));
        EXPECT_TRUE(quotient(I, zero, run).is_unit(run));
        EXPECT_TRUE(quotient(I, unit, run).equals(I, run));
        EXPECT_TRUE(quotient(zero, I, run).is_zero());
        EXPECT_TRUE(quotient(unit, I, run).is_unit(run));
        EXPECT_TRUE(saturate(I, Polynomial(ring), run).is_unit(run));
        EXPECT_TRUE(saturate(I, zero, run).is_unit(run));
        EXPECT_TRUE(saturate(I, unit, run).equals(I, run));
        EXPECT_TRUE(saturate(zero, I, run).is_zero());
        EXPECT_TRUE(saturate(unit, I, run).is_unit(run));
        EXPECT_TRUE(intersect(I, zero, run).is_zero());
        EXPECT_TRUE(intersect(I, unit, run).equals(I, run));
        EXPECT_TRUE(product(I, zero, run).is_zero());
        EXPECT_TRUE(product(I, unit, run).equals(I, run));
    }
}

TEST(Operations, SurviveVariablesNamedLikeTheirOwn) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"t", "y", "t1"});
    const auto [t, y, t1] = variables<3>(ring);
    EXPECT_TRUE(intersect(ideal_of({t}), ideal_of({y}), run).equals(ideal_of({t * y}), run));
    EXPECT_TRUE(saturate(ideal_of({t * y - y}), y, run).equals(ideal_of({t - number(ring, 1)}), run));
    EXPECT_TRUE(saturate(ideal_of({t * (t1 + y)}), t1 + y, run).equals(ideal_of({t}), run));
    EXPECT_TRUE(radical_contains(ideal_of({pow(t + t1, 3)}), t + t1, run));
}

} // namespace
} // namespace eliminant::ideal
