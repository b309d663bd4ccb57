#include "eliminant/ideal/ideal.hpp"

#include "eliminant/groebner/buchberger.hpp"
#include "eliminant/ideal/operations.hpp"
#include "ideal/support.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace eliminant::ideal {
namespace {

Ring qq(std::vector<std::string> names, MonomialOrder order = MonomialOrder::degrevlex()) {
    return {CoefficientField::rationals(), std::move(names), std::move(order)};
}

TEST(Ideal, HasTheReducedBasisOfItsOrder) {
    Random random(11);
    base::Run run;
    for (const Ring& ring : testing::sample_rings()) {
        const Ideal I = random_ideal(ring, random, 3, 4, 2);
        for (const MonomialOrder& order :
             {ring.order(), MonomialOrder::lex(), MonomialOrder::degrevlex(),
              MonomialOrder::blocks({{2}, {0}}), MonomialOrder::blocks({{1}, {0, 2}}),
              MonomialOrder::weighted({3, 0, 2}, MonomialOrder::TieBreak::lex),
              MonomialOrder::matrix({{0, 1, 2}, {1, 0, 0}, {0, 0, 1}})}) {
            const Ring target = ring.with_order(order);
            std::vector<Polynomial> generators;
            for (const Polynomial& f : I.generators()) generators.push_back(f.in_ring(target));
            const std::vector<Polynomial>& basis = I.groebner_basis(order, run);
            EXPECT_TRUE(is_reduced_groebner(basis, run)) << describe(I);
            EXPECT_EQ(basis, buchberger(target, generators, {}, run).elements)
                << describe(I) << target.to_string();
        }
    }
}

TEST(Ideal, ContainsExactlyTheCombinationsOfItsGenerators) {
    Random random(12);
    base::Run run;
    for (const Ring& ring : testing::sample_rings()) {
        const Ideal I = random_ideal(ring, random, 2, 3, 2);
        Polynomial member(ring);
        for (const Polynomial& f : I.generators()) member += f * random_small(ring, random, 3, 2);
        EXPECT_TRUE(I.contains(member, run)) << describe(I);
        EXPECT_TRUE(I.normal_form(member, run).is_zero()) << describe(I);

        const Polynomial f = random_small(ring, random, 5, 3);
        const Polynomial remainder = I.normal_form(f, run);
        EXPECT_EQ(I.normal_form(f + member, run), remainder) << describe(I);
        EXPECT_TRUE(I.contains(f - remainder, run)) << describe(I);
        EXPECT_EQ(I.contains(f, run), remainder.is_zero()) << describe(I);
        for (const Polynomial& g : I.groebner_basis(run)) {
            for (std::size_t i = 0; i < remainder.size(); ++i)
                EXPECT_FALSE(g.leading_monomial().divides(remainder.monomial(i))) << describe(I);
        }
    }
}

TEST(Ideal, EqualityDoesNotDependOnTheGenerators) {
    Random random(13);
    base::Run run;
    for (const Ring& ring : testing::sample_rings()) {
        const Ideal I = random_ideal(ring, random, 3, 3, 2);
        std::vector<Polynomial> others = I.generators();
        if (others.size() < 2) continue;
        others[0] += others[1] * random_small(ring, random, 2, 1);
        others.push_back(others[0]);
        others.insert(others.begin(), Polynomial(ring));
        const Ideal J(ring, others);
        EXPECT_TRUE(I.equals(J, run)) << describe(I);
        EXPECT_TRUE(I.contains(J, run) && J.contains(I, run)) << describe(I);
        const Ideal larger = sum(I, Ideal(ring, {random_small(ring, random, 3, 2)}));
        EXPECT_EQ(larger.equals(I, run), I.contains(larger, run)) << describe(I);
    }
}

TEST(Ideal, ZeroAndUnitIdealsAreOrdinary) {
    base::Run run;
    for (std::size_t n : {0U, 1U, 3U}) {
        for (const Ring& sample : testing::sample_fields()) {
            const Ring ring(sample.field(), testing::numbered_names(n));
            const Ideal zero(ring, {Polynomial(ring), Polynomial(ring)});
            const Ideal unit(ring, {number(ring, 3), number(ring, 5)});
            EXPECT_TRUE(zero.is_zero());
            EXPECT_FALSE(zero.is_unit(run));
            EXPECT_TRUE(zero.groebner_basis(run).empty());
            EXPECT_TRUE(unit.is_unit(run));
            EXPECT_EQ(unit.groebner_basis(run), std::vector{number(ring, 1)});
            EXPECT_TRUE(unit.equals(Ideal::unit(ring), run));
            EXPECT_FALSE(unit.equals(zero, run));
            EXPECT_TRUE(zero.equals(Ideal(ring), run));
            EXPECT_TRUE(unit.contains(zero, run));
            EXPECT_FALSE(zero.contains(unit, run));
            EXPECT_TRUE(zero.contains(Polynomial(ring), run));
            EXPECT_EQ(zero.normal_form(number(ring, 1), run), number(ring, 1));
        }
    }
}

TEST(Ideal, RejectsForeignPolynomials) {
    base::Run run;
    const Ring a = qq({"x", "y"});
    const Ring b = qq({"x", "y"}, MonomialOrder::lex());
    const Polynomial f = Polynomial::variable(b, "x");
    EXPECT_THROW(Ideal(a, {f}), RingMismatchError);
    EXPECT_THROW(static_cast<void>(Ideal(a).contains(f, run)), RingMismatchError);
    EXPECT_THROW(static_cast<void>(Ideal(a).equals(Ideal(b), run)), RingMismatchError);
    EXPECT_THROW(static_cast<void>(sum(Ideal(a), Ideal(b))), RingMismatchError);
    EXPECT_THROW(static_cast<void>(Ideal::from_groebner_basis(a, MonomialOrder::degrevlex(), {f})),
                 RingMismatchError);
}

TEST(Ideal, KeepsItsBases) {
    base::Run run;
    const Ring ring = qq({"x", "y"});
    const auto [x, y] = variables<2>(ring);
    const Ideal I(ring, {x * x - y, x * y - number(ring, 1)});
    const Ideal copy = I;
    EXPECT_EQ(&I.groebner_basis(run), &copy.groebner_basis(run));
    EXPECT_EQ(&I.groebner_basis(MonomialOrder::lex(), run), &copy.groebner_basis(MonomialOrder::lex(), run));

    // A stopped run computes nothing, but what is known is still known.
    base::Run stopped;
    stopped.request_stop();
    EXPECT_EQ(I.groebner_basis(stopped), copy.groebner_basis(run));
    EXPECT_THROW(static_cast<void>(I.groebner_basis(MonomialOrder::deglex(), stopped)), Stopped);
    EXPECT_TRUE(is_reduced_groebner(I.groebner_basis(MonomialOrder::deglex(), run), run));
}

TEST(Ideal, CanBeStoppedInsideABasisAndInsideASaturation) {
    const Ideal I = testing::long_work();
    const auto stops = [](auto&& work) {
        base::Run run({.time_limit_seconds = 0.05});
        EXPECT_THROW(work(run), Stopped);
    };
    stops([&](base::Run& run) { static_cast<void>(I.groebner_basis(run)); });
    stops([&](base::Run& run) { static_cast<void>(I.groebner_basis(MonomialOrder::lex(), run)); });
    stops([&](base::Run& run) { static_cast<void>(saturate(I, Polynomial::variable(I.ring(), 0), run)); });
    stops([&](base::Run& run) {
        static_cast<void>(radical_contains(I, Polynomial::variable(I.ring(), 0), run));
    });
    stops([&](base::Run& run) {
        static_cast<void>(intersect(I, Ideal(I.ring(), {Polynomial::variable(I.ring(), 0)}), run));
    });
}

TEST(Ideal, ServesManyThreads) {
    Random random(14);
    const Ring ring = qq({"x", "y", "z"}, MonomialOrder::lex());
    const Ideal I = random_ideal(ring, random, 3, 4, 2);
    std::vector<const std::vector<Polynomial>*> seen(4);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        threads.emplace_back([&, i] {
            base::Run run;
            seen[i] = &I.groebner_basis(i % 2 == 0 ? MonomialOrder::lex() : MonomialOrder::degrevlex(), run);
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(seen[0], seen[2]);
    EXPECT_EQ(seen[1], seen[3]);
    base::Run run;
    EXPECT_TRUE(is_reduced_groebner(*seen[0], run));
    EXPECT_TRUE(is_reduced_groebner(*seen[1], run));
}

} // namespace
} // namespace eliminant::ideal
