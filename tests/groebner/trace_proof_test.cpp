#include "groebner/trace_proof.hpp"

#include "eliminant/algebra/parse.hpp"
#include "eliminant/groebner/f4.hpp"
#include "eliminant/groebner/groebner_basis.hpp"
#include "groebner/classical_systems.hpp"
#include "groebner/modular_basis.hpp"
#include "support/random_ideals.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

using namespace eliminant;
using algebra::RationalLifting;
using eliminant::testing::classical_system;
using groebner::F4Trace;
using groebner::ModularBasis;
using groebner::PrimeSequence;
using groebner::Proof;

namespace {

constexpr std::uint32_t good = 2147483647;
constexpr std::uint32_t bad = 2147483587; // primes

std::vector<Polynomial> parse(const Ring& ring, const std::vector<std::string>& texts) {
    std::vector<Polynomial> result;
    for (const std::string& text : texts) result.push_back(algebra::parse_polynomial(ring, text));
    return result;
}

BasisOptions by_f4(Proof proof) { return {.algorithm = Algorithm::f4, .proof = proof}; }

TEST(TraceProof, HoldsForClassicalSystems) {
    base::Run run;
    for (const char* name : {"chandra6", "cyclic5", "cyclic6", "eco8", "katsura6", "noon5"}) {
        SCOPED_TRACE(name);
        const System system = classical_system(name, CoefficientField::rationals(), run);
        ModularBasis images(system.ring, system.polynomials, {}, PrimeSequence(1), run,
                            F4Trace::Extent::elements);
        EXPECT_EQ(images.find(), buchberger(system.ring, system.polynomials, {}, run).elements);
        EXPECT_TRUE(has_all_leading_monomials(images.trace(), system.polynomials, run));
        EXPECT_TRUE(
            lies_in_ideal_of_generators(images.trace(), images.lifted_elements(), images.primes(), run));
    }
}

TEST(TraceProof, IsRefusedWhereACoefficientIsWrong) {
    base::Run run;
    const System system = classical_system("katsura6", CoefficientField::rationals(), run);
    ModularBasis images(system.ring, system.polynomials, {}, PrimeSequence(1), run,
                        F4Trace::Extent::elements);
    static_cast<void>(images.find());
    const std::vector<RationalLifting::Vector> lifted = images.lifted_elements();
    eliminant::testing::Random random(5);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<RationalLifting::Vector> elements = lifted;
        auto& numerators = elements[random() % elements.size()].numerators;
        numerators[random() % numerators.size()] += Integer(1);
        EXPECT_FALSE(lies_in_ideal_of_generators(images.trace(), elements, images.primes(), run));
    }
    // A multiple of all primes so far does not help either.
    std::vector<RationalLifting::Vector> elements = lifted;
    elements.back().numerators.back() += pow(Integer(good), 100);
    EXPECT_FALSE(lies_in_ideal_of_generators(images.trace(), elements, images.primes(), run));
}

TEST(TraceProof, ALearnedPrimeWithFewerLeadingMonomialsProvesNothing) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"});
    // The S-polynomial reduces to P·y²z.
    const auto generators = parse(ring, {"x^2+x*z+" + std::to_string(bad - 1) + "*y*z-y^2", "x*y+y*z+y^2"});
    const auto unlucky = F4Trace::learn(ring, generators, bad, {}, run);
    const auto lucky = F4Trace::learn(ring, generators, good, {}, run);
    ASSERT_TRUE(unlucky && lucky);
    EXPECT_LT(unlucky->basis().elements.size(), lucky->basis().elements.size());
    EXPECT_FALSE(has_all_leading_monomials(*unlucky, generators, run));

    ModularBasis misled(ring, generators, {}, PrimeSequence(1, {bad}), run);
    EXPECT_EQ(misled.find().size(), unlucky->basis().elements.size()) << "no longer an example";
}

TEST(TraceProof, NeedsTheHypothesesOfATheorem) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"});
    const auto known = [&](const std::vector<std::string>& texts) {
        const auto generators = parse(ring, texts);
        const auto trace = F4Trace::learn(ring, generators, good, {}, run);
        return has_all_leading_monomials(*trace, generators, run);
    };
    EXPECT_TRUE(known({"x^2+y-1", "x*y+z^2", "z^3-x"}));
    EXPECT_TRUE(known({"x^2+y*z", "x*y+z^2"}));                  // homogeneous, regular
    EXPECT_FALSE(known({"x*y", "x*z"}));                         // a common factor
    EXPECT_FALSE(known({"x^2+y", "x*y+z^2"}));                   // neither
    EXPECT_FALSE(known({"x*y-1", "x*z+1", "x^2*y-x"}));          // infinitely many solutions
    EXPECT_FALSE(known({"x^2-1", "y^2-1", "z^2-1", "x*y*z-1"})); // more equations
    EXPECT_TRUE(known({"x*y-1", "x", "z", "y^2"}));              // the unit ideal
}

TEST(TraceProof, BasesAreThoseOfTheClassicAlgorithm) {
    const std::uint64_t seed = 12;
    eliminant::testing::Random random(seed);
    base::Run run;
    for (int round = 0; round < 40; ++round) {
        for (const Ring& ring : eliminant::testing::sample_rings()) {
            if (!ring.field().is_rationals()) continue;
            std::vector<Polynomial> generators;
            const std::size_t count = 1 + random() % 5; // fewer and more than variables
            for (std::size_t i = 0; i < count; ++i)
                generators.push_back(eliminant::testing::random_small(ring, random, 3, 3, round % 4 == 0));
            SCOPED_TRACE("seed " + std::to_string(seed) + ", " +
                         eliminant::testing::describe(Ideal(ring, generators)));
            const GroebnerBasis proved = groebner_basis(ring, generators, by_f4(Proof::full), run);
            EXPECT_EQ(proved.proof, Proof::full);
            EXPECT_EQ(proved.elements, Ideal(ring, generators).groebner_basis(run));
            EXPECT_TRUE(is_reduced_groebner(proved.elements, run));
            const GroebnerBasis probable = groebner_basis(ring, generators, by_f4(Proof::none), run);
            EXPECT_EQ(probable.elements, proved.elements);
        }
    }
}

TEST(TraceProof, EveryKindOfIdealIsProved) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"});
    const std::vector<std::vector<std::string>> kinds = {
        {"x*y+7*z^2-3", "x*z-2*y^2+5", "x*y*z+x-1", "x^2+y^2+z^2-11"}, // overdetermined, the unit ideal
        {"x^2-1", "y^2-x*y", "x*y*z-z", "x^2*y^2-x^2"},                // overdetermined
        {"x*y-2*z^2", "x*z+3*y^2"},                                    // homogeneous, a curve
        {"x*y-2*z^2", "x*z+3*y^2", "x^2*z-x*y^2"},                     // and one equation more
        {"x^2*y-z", "x*y^2-3*z+1"},                                    // a curve
        {"x^2*y-5*z", "2*x^2*y-10*z", "x*y", "x^2*y^2", "0"},          // redundant, a zero
        {"x*y*(x+y-3*z)", "x*z*(2*x-y)", "x^2-4*x*z"},                 // components of several dimensions
        {"0", "0"},                                                    // the zero ideal
        {"3"},                                                         // the unit ideal
        {"2*x+3*y-5*z+7"},                                             // a plane
    };
    for (const auto& texts : kinds) {
        SCOPED_TRACE(texts.front());
        for (const Ring& ordered : {ring, ring.with_order(MonomialOrder::lex())}) {
            const auto generators = parse(ordered, texts);
            const GroebnerBasis proved = f4(ordered, generators, {}, run);
            EXPECT_EQ(proved.proof, Proof::full);
            EXPECT_EQ(proved.elements, buchberger(ordered, generators, {}, run).elements);
            EXPECT_TRUE(is_reduced_groebner(proved.elements, run));
        }
    }
}

TEST(TraceProof, BasesDoNotDependOnThreads) {
    base::Run one;
    base::Run three(base::RunOptions{.threads = 3});
    const System system = classical_system("katsura7", CoefficientField::rationals(), one);
    EXPECT_EQ(groebner_basis(system.ring, system.polynomials, by_f4(Proof::full), one).elements,
              groebner_basis(system.ring, system.polynomials, by_f4(Proof::full), three).elements);
}

TEST(TraceProof, CanBeStoppedFromAnotherThread) {
    base::Run run;
    const System system = classical_system("chandra9", CoefficientField::rationals(), run);
    ModularBasis images(system.ring, system.polynomials, {}, PrimeSequence(1), run,
                        F4Trace::Extent::elements);
    static_cast<void>(images.find());
    for (const int milliseconds : {1, 20}) {
        base::Run stopped;
        std::thread stopper([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
            stopped.request_stop();
        });
        EXPECT_THROW(static_cast<void>(lies_in_ideal_of_generators(images.trace(), images.lifted_elements(),
                                                                   images.primes(), stopped)),
                     Stopped);
        stopper.join();
    }
}

} // namespace
