#include "groebner/f4_trace.hpp"

#include "eliminant/algebra/parse.hpp"
#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/error.hpp"
#include "eliminant/groebner/f4.hpp"
#include "groebner/classical_systems.hpp"
#include "support/random_ideals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

using namespace eliminant;
using groebner::F4Trace;
using groebner::Replay;

namespace {

constexpr std::uint64_t large_prime = 2147483629;

std::vector<std::uint32_t> primes_below(std::uint64_t bound, std::size_t count) {
    std::vector<std::uint32_t> primes;
    while (primes.size() < count) {
        bound = algebra::previous_prime(bound);
        primes.push_back(static_cast<std::uint32_t>(bound));
    }
    return primes;
}

std::vector<Polynomial> images_of(std::span<const Polynomial> generators, const Ring& ring) {
    std::vector<Polynomial> images;
    for (const Polynomial& f : generators) images.push_back(f.primitive_part().in_ring(ring));
    return images;
}

std::vector<Polynomial> parse(const Ring& ring, std::initializer_list<const char*> texts) {
    std::vector<Polynomial> result;
    for (const char* text : texts) result.push_back(algebra::parse_polynomial(ring, text));
    return result;
}

bool are_same(const F4Trace::Image& a, const F4Trace::Image& b) {
    return a.prime == b.prime && a.replay == b.replay && a.coefficients == b.coefficients;
}

/// The polynomials of an image.
std::vector<Polynomial> polynomials(const F4Trace& trace, const F4Trace::Image& image) {
    const Ring ring = trace.ring().with_field(CoefficientField::prime(image.prime));
    std::vector<Polynomial> result;
    std::size_t next = 0;
    for (const Polynomial& f : trace.basis().elements) {
        PolynomialBuilder builder(ring);
        for (std::size_t i = 0; i < f.size(); ++i, ++next)
            builder.add(Integer(static_cast<std::int64_t>(image.coefficients.at(next))),
                        f.monomial(i).exponents());
        result.push_back(builder.build());
    }
    EXPECT_EQ(next, image.coefficients.size());
    return result;
}

/// Every image that agrees is the reduced basis modulo its prime. Returns how many agree.
std::size_t check_replays(const Ring& ring, std::span<const Polynomial> generators, const F4Trace& trace,
                          std::span<const std::uint32_t> primes) {
    base::Run run;
    std::size_t agreeing = 0;
    const std::vector<F4Trace::Image> images = trace.replay(primes, run);
    EXPECT_EQ(images.size(), primes.size());
    for (std::size_t i = 0; i < images.size(); ++i) {
        EXPECT_EQ(images[i].prime, primes[i]);
        if (images[i].replay != Replay::agrees) {
            EXPECT_TRUE(images[i].coefficients.empty());
            continue;
        }
        ++agreeing;
        const Ring image_ring = ring.with_field(CoefficientField::prime(primes[i]));
        EXPECT_EQ(polynomials(trace, images[i]),
                  f4(image_ring, images_of(generators, image_ring), {}, run).elements)
            << ring.to_string() << " modulo " << primes[i];
    }
    return agreeing;
}

TEST(F4Trace, ReplaysAgreeWithDirectComputationOnRandomIdeals) {
    constexpr int seed = 31;
    eliminant::testing::Random random(seed);
    base::Run run;
    const std::vector<std::uint32_t> large = primes_below(1U << 31U, 11);
    std::size_t agreeing = 0;
    std::size_t tried = 0;
    for (const Ring& ring : eliminant::testing::sample_rings()) {
        if (!ring.field().is_rationals()) continue;
        for (int round = 0; round < 12; ++round) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round));
            std::vector<Polynomial> generators;
            for (std::uint64_t i = 0; i < 1 + random() % 4; ++i)
                generators.push_back(
                    eliminant::testing::random_small(ring, random, 1 + random() % 5, 1 + random() % 3));
            const auto trace = F4Trace::learn(ring, generators, 1073741789, {}, run);
            ASSERT_TRUE(trace.has_value());
            agreeing += check_replays(ring, generators, *trace, large);
            tried += large.size();
            EXPECT_EQ(polynomials(*trace, trace->replay(std::vector{trace->prime()}, run).front()),
                      trace->basis().elements);
        }
    }
    // An intermediate coefficient that vanishes by accident is possible, but far from common.
    EXPECT_GE(agreeing, tried - large.size());
}

TEST(F4Trace, ReplaysAgreeWithDirectComputationOnClassicalSystems) {
    base::Run run;
    for (const char* name : {"katsura6", "cyclic6", "eco8", "noon5", "chandra7"}) {
        const System system = eliminant::testing::classical_system(name, CoefficientField::rationals(), run);
        BuchbergerOptions options;
        options.selection = groebner::Selection::normal;
        const auto trace = F4Trace::learn(system.ring, system.polynomials, large_prime, options, run);
        ASSERT_TRUE(trace.has_value()) << name;
        EXPECT_GT(trace->size_in_bytes(), 0U);
        const std::vector<std::uint32_t> primes = primes_below(1U << 30U, 9);
        EXPECT_EQ(check_replays(system.ring, system.polynomials, *trace, primes), primes.size()) << name;
    }
}

TEST(F4Trace, KernelsAndThreadsGiveTheSame) {
    base::Run run;
    const System system =
        eliminant::testing::classical_system("katsura6", CoefficientField::rationals(), run);
    const auto trace = F4Trace::learn(system.ring, system.polynomials, large_prime, {}, run);
    ASSERT_TRUE(trace.has_value());
    const std::vector<std::uint32_t> primes = primes_below(1U << 31U, 21);
    const std::vector<F4Trace::Image> expected = trace->replay(primes, run);
    for (const base::VectorUnit unit : base::available_vector_units()) {
        const auto pack = trace->replay_pack(std::span(primes).first(8), groebner::lane_kernels(unit), run);
        EXPECT_TRUE(std::equal(pack.begin(), pack.end(), expected.begin(), are_same)) << base::name(unit);
    }
}

/// With matrices so large that threads share their rows, and primes modulo which something is different.
TEST(F4Trace, ThreadsGiveTheSame) {
    base::Run run;
    const System system =
        eliminant::testing::classical_system("katsura8", CoefficientField::rationals(), run);
    const auto trace = F4Trace::learn(system.ring, system.polynomials, large_prime, {}, run);
    ASSERT_TRUE(trace.has_value());
    std::vector<std::uint32_t> primes = primes_below(1U << 31U, 4);
    for (const std::uint32_t p : {101U, 103U, 3U, 107U, 109U}) primes.push_back(p);
    for (const auto extent : {F4Trace::Extent::basis, F4Trace::Extent::elements}) {
        const std::vector<F4Trace::Image> expected = trace->replay(primes, run, extent);
        EXPECT_GE(std::ranges::count(expected, Replay::agrees, &F4Trace::Image::replay), 4);
        EXPECT_LT(std::ranges::count(expected, Replay::agrees, &F4Trace::Image::replay), 9);
        for (const unsigned threads : {2U, 3U}) {
            RunOptions options;
            options.threads = threads;
            base::Run several(options);
            EXPECT_TRUE(std::ranges::equal(expected, trace->replay(primes, several, extent), are_same));
        }
    }
}

TEST(F4Trace, PrimesThatChangeTheInputAreFound) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y"}, MonomialOrder::lex());
    const std::uint32_t bad = 1073741827;
    // Modulo `bad` the leading monomial of the first vanishes in its tail: <y, y + x + bad·x^2>.
    const auto generators = parse(ring, {"y", "y + x + 1073741827*x^2"});
    EXPECT_FALSE(F4Trace::learn(ring, generators, bad, {}, run).has_value());
    const auto trace = F4Trace::learn(ring, generators, large_prime, {}, run);
    ASSERT_TRUE(trace.has_value());
    const auto images = trace->replay(std::vector<std::uint32_t>{2147483647, bad, 1073741789}, run);
    EXPECT_EQ(images[0].replay, Replay::agrees);
    EXPECT_EQ(images[1].replay, Replay::input_vanishes);
    EXPECT_EQ(images[2].replay, Replay::agrees);
}

TEST(F4Trace, PrimesThatChangeALeadingMonomialOrARankAreFound) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"});
    struct Case {
        std::vector<Polynomial> generators;
        std::uint32_t bad;
    };
    // Differences of two generators: the prime divides what they lead to, not the input.
    const std::vector<Case> cases = {
        {parse(ring, {"x^2 + y^2", "x^2 + 102*y^2 + z"}), 101},   // leading coefficient 101
        {parse(ring, {"x^2 + y*z + 1", "x^2 + y*z + 104"}), 103}, // rank: the unit ideal elsewhere
        {parse(ring, {"x^2 + y^2", "x*y + z^2", "x^2 + 108*y^2"}), 107}};
    for (const Case& c : cases) {
        const auto trace = F4Trace::learn(ring, c.generators, large_prime, {}, run);
        ASSERT_TRUE(trace.has_value());
        const auto images = trace->replay(std::vector<std::uint32_t>{c.bad, 2147483647}, run);
        EXPECT_EQ(images[0].replay, Replay::leads_differ) << c.bad;
        EXPECT_EQ(images[1].replay, Replay::agrees) << c.bad;
    }
}

TEST(F4Trace, MonomialsMissingModuloTheLearnedPrimeAreFound) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"});
    // x^2 − (x^2 − y^2 …) leaves y^2 + 101·z + 1, without z modulo 101.
    const auto generators = parse(ring, {"x^2 + y^2 + 102*z + 3", "x^2 + z + 2"});
    const auto unlucky = F4Trace::learn(ring, generators, 101, {}, run);
    ASSERT_TRUE(unlucky.has_value());
    const auto images = unlucky->replay(std::vector<std::uint32_t>{101, 2147483647}, run);
    EXPECT_EQ(images[0].replay, Replay::agrees);
    EXPECT_EQ(images[1].replay, Replay::support_differs);
    // The other way round nothing is lost: the coefficient is 0.
    const auto lucky = F4Trace::learn(ring, generators, large_prime, {}, run);
    ASSERT_TRUE(lucky.has_value());
    EXPECT_EQ(check_replays(ring, generators, *lucky, std::vector<std::uint32_t>{101, 2147483647}), 2U);
}

TEST(F4Trace, SmallPrimesNeverGiveAWrongBasisOfTheRightShape) {
    base::Run run;
    const System system = eliminant::testing::classical_system("cyclic5", CoefficientField::rationals(), run);
    const auto trace = F4Trace::learn(system.ring, system.polynomials, large_prime, {}, run);
    ASSERT_TRUE(trace.has_value());
    const std::vector<std::uint32_t> primes = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 101};
    const std::size_t agreeing = check_replays(system.ring, system.polynomials, *trace, primes);
    EXPECT_GT(agreeing, 0U);
    EXPECT_LT(agreeing, primes.size()); // 5 is unlucky for cyclic-5
}

TEST(F4Trace, UnitAndZeroIdeals) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    const std::vector<std::uint32_t> primes = {2147483647, 2, 3};
    for (const auto& generators : {parse(ring, {"x", "x+1"}), parse(ring, {"0"}), parse(ring, {})}) {
        const auto trace = F4Trace::learn(ring, generators, large_prime, {}, run);
        ASSERT_TRUE(trace.has_value());
        EXPECT_EQ(check_replays(ring, generators, *trace, primes), primes.size());
    }
}

TEST(F4Trace, RefusesWhatItCannotDo) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    const auto generators = parse(ring, {"x^2+y", "x*y+1"});
    EXPECT_THROW(F4Trace::learn(ring, generators, 9, {}, run), DomainError);
    BuchbergerOptions bounded;
    bounded.degree_bound = 3;
    EXPECT_THROW(F4Trace::learn(ring, generators, 7, bounded, run), DomainError);
    const auto trace = F4Trace::learn(ring, generators, 7, {}, run);
    ASSERT_TRUE(trace.has_value());
    EXPECT_TRUE(trace->replay({}, run).empty());
    for (const std::uint32_t p : {0U, 1U, 9U, 2147483659U})
        EXPECT_THROW(trace->replay(std::vector{p}, run), DomainError) << p;
}

TEST(F4Trace, ReplayCanBeStoppedFromAnotherThread) {
    base::Run run;
    const System system =
        eliminant::testing::classical_system("katsura8", CoefficientField::rationals(), run);
    const auto trace = F4Trace::learn(system.ring, system.polynomials, large_prime, {}, run);
    ASSERT_TRUE(trace.has_value());
    base::Run stopped;
    std::thread stopper([&stopped] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        stopped.request_stop();
    });
    EXPECT_THROW(trace->replay(primes_below(1U << 31U, 4000), stopped), Stopped);
    stopper.join();
}

} // namespace
