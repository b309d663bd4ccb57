#include "eliminant/ideal/operations.hpp"

#include "eliminant/ideal/dimension.hpp"
#include "support/random_ideals.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace eliminant::ideal {
namespace {

using testing::describe;
using testing::number;
using testing::Random;
using testing::random_ideal;
using testing::random_small;
using testing::variables;

const Ring xyz(CoefficientField::rationals(), {"x", "y", "z"});

/// The sample rings, and in each a pair of ideals, one of them homogeneous in every other round.
template <class Check>
void for_random_pairs(std::uint64_t seed, Check&& check) {
    Random random(seed);
    for (int round = 0; round < 4; ++round) {
        for (const Ring& ring : testing::sample_rings()) {
            const bool homogeneous = round % 2 == 0;
            const Ideal I = random_ideal(ring, random, 2, 2 + random() % 2, 2, homogeneous);
            const Ideal J = random_ideal(ring, random, 1 + random() % 2, 2, 2, random() % 2 == 0);
            SCOPED_TRACE("seed " + std::to_string(seed) + "\nI = " + describe(I) + "\nJ = " + describe(J));
            check(I, J, random);
        }
    }
}

Ideal ideal(std::vector<Polynomial> generators) {
    const Ring ring = generators.front().ring();
    return {ring, std::move(generators)};
}

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
    const std::vector<Ideal> axes = {ideal({x, y}), ideal({y, z}), ideal({x, z})};
    const Ideal together = intersect(axes, run);
    EXPECT_EQ(together.groebner_basis(run), (std::vector{y * z, x * z, x * y}));
    EXPECT_THROW(static_cast<void>(intersect(std::span<const Ideal>(), run)), DomainError);
    // Cox, Little, O'Shea, §4.3, example after Theorem 11.
    EXPECT_TRUE(intersect(ideal({x * x * y}), ideal({x * y * y}), run).equals(ideal({x * x * y * y}), run));
}

TEST(Operations, PowerIsRepeatedMultiplication) {
    base::Run run;
    for_random_pairs(24, [&](const Ideal& I, const Ideal&, Random&) {
        EXPECT_TRUE(power(I, 0, run).is_unit(run));
        EXPECT_TRUE(power(I, 1, run).equals(I, run));
        EXPECT_TRUE(power(I, 3, run).equals(product(I, product(I, I, run), run), run));
    });
    const auto [x, y, z] = variables<3>(xyz);
    EXPECT_EQ(power(ideal({x, y, z}), 4, run).generators().size(), 15U); // monomials of degree 4
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
        EXPECT_TRUE(quotient(product(I, ideal({f}), run), f, run).equals(I, run))
            << describe(I) << describe(f);
    }
    const auto [x, y, z] = variables<3>(xyz);
    // Cox, Little, O'Shea, §4.4, example after Definition 5: I(V(xz, yz)) : I(V(z)) is the z-axis.
    EXPECT_TRUE(quotient(ideal({x * z, y * z}), ideal({z}), run).equals(ideal({x, y}), run));
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
    const Ideal curve = ideal({y - x * x, z - x * y}); // (t, t², t³), homogeneous for the weights
    const Polynomial f = x * y + z;
    const Ideal with_junk = product(curve, power(ideal({f, x * z}), 2, run), run);
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
    const Ideal two = ideal({x * z - y * y, x * w - y * z});
    const Ideal cubic = ideal({x * z - y * y, x * w - y * z, y * w - z * z});
    EXPECT_TRUE(saturate(two, x, run).equals(cubic, run));
    EXPECT_TRUE(saturate(two, ideal({x, y}), run).equals(cubic, run));
    EXPECT_TRUE(quotient(two, cubic, run).equals(ideal({x, y}), run));
}

TEST(Elimination, IsTheIntersectionWithTheSubring) {
    base::Run run;
    for_random_pairs(41, [&](const Ideal& I, const Ideal&, Random& random) {
        const std::vector<std::size_t> gone = random() % 2 == 0
                                                  ? std::vector<std::size_t>{random() % 3}
                                                  : std::vector<std::size_t>{2, random() % 3, 2};
        const Ideal E = eliminate(I, gone, run);
        std::vector<Polynomial> back;
        for (const Polynomial& f : E.generators()) back.push_back(f.in_ring(I.ring()));
        EXPECT_TRUE(I.contains(Ideal(I.ring(), back), run));
        // The lex basis with the eliminated variables first has the same elimination ideal (the theorem).
        std::vector<std::string> names;
        for (const std::size_t i : gone) {
            if (std::ranges::find(names, I.ring().names()[i]) == names.end())
                names.push_back(I.ring().names()[i]);
        }
        names.insert(names.end(), E.ring().names().begin(), E.ring().names().end());
        const Ring lex(I.ring().field(), names, MonomialOrder::lex());
        std::vector<Polynomial> generators;
        for (const Polynomial& f : I.generators()) generators.push_back(f.in_ring(lex));
        std::vector<Polynomial> expected;
        for (const Polynomial& f : Ideal(lex, generators).groebner_basis(run)) {
            const std::size_t k = names.size() - E.ring().variable_count();
            bool free = true;
            for (std::size_t i = 0; i < k; ++i) free = free && f.degree(i) == 0;
            if (free) expected.push_back(f.in_ring(E.ring()));
        }
        EXPECT_TRUE(E.equals(Ideal(E.ring(), expected), run));
    });
}

TEST(Elimination, TextbookExamples) {
    base::Run run;
    const auto [x, y, z] = variables<3>(xyz);
    const Polynomial one = number(xyz, 1);
    {
        // Cox, Little, O'Shea, §3.1, (4): elimination of x and y gives z⁶ − 4z⁴ + 4z³ − z².
        const Ideal I = ideal({x * x + y + z - one, x + y * y + z - one, x + y + z * z - one});
        const Ideal E = eliminate(I, std::vector<std::size_t>{0, 1}, run);
        const Polynomial t = Polynomial::variable(E.ring(), "z");
        EXPECT_EQ(E.generators(), std::vector{pow(t, 6) - number(E.ring(), 4) * pow(t, 4) +
                                              number(E.ring(), 4) * pow(t, 3) - t * t});
    }
    {
        // §3.1, (7): xy = 1, xz = 1; elimination of x gives y − z, but (0, 0) does not extend.
        const Ideal I = ideal({x * y - one, x * z - one});
        const Ideal E = eliminate(I, std::vector<std::size_t>{0}, run);
        EXPECT_EQ(E.generators(),
                  std::vector{Polynomial::variable(E.ring(), "y") - Polynomial::variable(E.ring(), "z")});
        EXPECT_TRUE(sum(I, ideal({y, z})).is_unit(run));
        EXPECT_FALSE(sum(I, ideal({y - one, z - one})).is_unit(run));
    }
    {
        // The tangent surface of the twisted cubic, §3.3, (3).
        const Ring ring(CoefficientField::rationals(), {"t", "u", "x", "y", "z"});
        const auto [t, u, X, Y, Z] = variables<5>(ring);
        const Polynomial two = number(ring, 2);
        const Polynomial three = number(ring, 3);
        const Ideal I(ring, {X - t - u, Y - t * t - two * t * u, Z - t * t * t - three * t * t * u});
        const Ideal E = eliminate(I, std::vector<std::size_t>{0, 1}, run);
        const auto [a, b, c] = variables<3>(E.ring());
        const auto n = [&](long value) { return number(E.ring(), value); };
        EXPECT_EQ(E.generators(), std::vector{(n(-3) * a * a * b * b + n(4) * b * b * b +
                                               n(4) * a * a * a * c - n(6) * a * b * c + c * c)
                                                  .primitive_part()});
    }
}

TEST(Elimination, OfAllOrNoneOfTheVariables) {
    base::Run run;
    for (const Ring& ring : testing::sample_rings()) {
        const Polynomial x = Polynomial::variable(ring, 0);
        std::vector<std::size_t> all(3);
        std::iota(all.begin(), all.end(), std::size_t{0});
        const Ideal I(ring, {x * x});
        EXPECT_TRUE(eliminate(I, all, run).is_zero());
        EXPECT_EQ(eliminate(I, all, run).ring().variable_count(), 0U);
        EXPECT_TRUE(eliminate(Ideal::unit(ring), all, run).is_unit(run));
        EXPECT_TRUE(eliminate(I, {}, run).equals(I, run));
        EXPECT_THROW(static_cast<void>(eliminate(I, std::vector<std::size_t>{3}, run)), DomainError);
    }
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

TEST(Operations, SurviveVariablesNamedLikeTheirOwn) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"t", "y", "t1"});
    const auto [t, y, t1] = variables<3>(ring);
    EXPECT_TRUE(intersect(ideal({t}), ideal({y}), run).equals(ideal({t * y}), run));
    EXPECT_TRUE(saturate(ideal({t * y - y}), y, run).equals(ideal({t - number(ring, 1)}), run));
    EXPECT_TRUE(saturate(ideal({t * (t1 + y)}), t1 + y, run).equals(ideal({t}), run));
    EXPECT_TRUE(radical_contains(ideal({pow(t + t1, 3)}), t + t1, run));
}

TEST(Dimension, OfKnownVarieties) {
    base::Run run;
    for (const Ring& ring : testing::sample_rings()) {
        const auto [x, y, z] = variables<3>(ring);
        const Polynomial one = number(ring, 1);
        EXPECT_EQ(dimension(Ideal(ring), run), 3);
        EXPECT_EQ(dimension(Ideal::unit(ring), run), -1);
        EXPECT_EQ(codimension(Ideal::unit(ring), run), 4);
        EXPECT_EQ(dimension(ideal({x * y, x * z}), run), 2); // Cox, Little, O'Shea, §9.1: a plane and a line
        EXPECT_EQ(dimension(ideal({x * y, y * z, x * z}), run), 1);
        EXPECT_EQ(dimension(ideal({y - x * x, z - x * y}), run), 1);
        EXPECT_EQ(dimension(ideal({x, y, z - one}), run), 0);
        EXPECT_EQ(codimension(ideal({x * x - y}), run), 1);
        EXPECT_EQ(maximal_independent_set(ideal({x * y, x * z}), run), (std::vector<std::size_t>{1, 2}));
        EXPECT_THROW(static_cast<void>(maximal_independent_set(Ideal::unit(ring), run)), DomainError);
    }
    const Ring nothing(CoefficientField::rationals(), {});
    EXPECT_EQ(dimension(Ideal(nothing), run), 0);
    EXPECT_EQ(dimension(Ideal::unit(nothing), run), -1);
    EXPECT_TRUE(maximal_independent_set(Ideal(nothing), run).empty());
}

TEST(Dimension, IndependentVariablesAreIndependent) {
    base::Run run;
    for_random_pairs(61, [&](const Ideal& I, const Ideal& J, Random&) {
        EXPECT_EQ(dimension(intersect(I, J, run), run), std::max(dimension(I, run), dimension(J, run)));
        EXPECT_EQ(dimension(product(I, J, run), run), std::max(dimension(I, run), dimension(J, run)));
        EXPECT_LE(dimension(sum(I, J), run), std::min(dimension(I, run), dimension(J, run)));
        if (I.is_unit(run)) return;
        const std::vector<std::size_t> free = maximal_independent_set(I, run);
        std::vector<std::size_t> bound;
        for (std::size_t i = 0; i < 3; ++i) {
            if (std::ranges::find(free, i) == free.end()) bound.push_back(i);
        }
        EXPECT_TRUE(eliminate(I, bound, run).is_zero());
        for (const std::size_t i : bound) {
            std::vector<std::size_t> others = bound;
            std::erase(others, i);
            EXPECT_FALSE(eliminate(I, others, run).is_zero()); // maximal
        }
    });
}

TEST(Dimension, OfEdgeIdealsIsTheIndependenceNumber) {
    // The edge ideal of a graph: its dimension is the size of the largest independent set of vertices.
    base::Run run;
    Random random(62);
    for (int round = 0; round < 20; ++round) {
        const std::size_t n = 1 + random() % 12;
        const Ring ring(CoefficientField::prime(7), testing::numbered_names(n));
        std::vector<Polynomial> edges;
        std::vector<std::uint32_t> masks;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (random() % 3 != 0) continue;
                edges.push_back(Polynomial::variable(ring, i) * Polynomial::variable(ring, j));
                masks.push_back((1U << i) | (1U << j));
            }
        }
        std::int64_t largest = 0;
        for (std::uint32_t set = 0; set < (1U << n); ++set) {
            const auto is_inside = [set](std::uint32_t edge) { return (edge & set) == edge; };
            if (std::ranges::none_of(masks, is_inside))
                largest = std::max<std::int64_t>(largest, std::popcount(set));
        }
        EXPECT_EQ(dimension(Ideal(ring, edges), run), largest) << describe(Ideal(ring, edges));
    }
}

} // namespace
} // namespace eliminant::ideal
