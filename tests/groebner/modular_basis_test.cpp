#include "groebner/modular_basis.hpp"

#include "eliminant/algebra/parse.hpp"
#include "groebner/classical_systems.hpp"
#include "support/random_ideals.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

using namespace eliminant;
using eliminant::testing::classical_system;
using groebner::ModularBasis;
using groebner::PrimeSequence;

namespace {

constexpr std::uint32_t bad = 2147483587; // a prime

std::vector<Polynomial> parse(const Ring& ring, const std::vector<std::string>& texts) {
    std::vector<Polynomial> result;
    for (const std::string& text : texts) result.push_back(algebra::parse_polynomial(ring, text));
    return result;
}

std::vector<Polynomial> found(const Ring& ring, const std::vector<Polynomial>& generators,
                              std::vector<std::uint32_t> first_primes, unsigned threads = 1) {
    base::Run run(base::RunOptions{.threads = threads});
    return ModularBasis(ring, generators, {}, PrimeSequence(0, std::move(first_primes)), run).find();
}

std::vector<Polynomial> expected(const Ring& ring, const std::vector<Polynomial>& generators) {
    base::Run run;
    return buchberger(ring, generators, {}, run).elements;
}

TEST(ModularBasis, IsThatOfTheClassicAlgorithmOnRandomSystems) {
    const std::uint64_t seed = 11;
    eliminant::testing::Random random(seed);
    for (int round = 0; round < 12; ++round) {
        for (const Ring& ring : eliminant::testing::sample_rings()) {
            if (!ring.field().is_rationals()) continue;
            std::vector<Polynomial> generators;
            for (std::size_t i = 0; i < 2 + random() % 2; ++i)
                generators.push_back(eliminant::testing::random_small(ring, random, 3, 3));
            SCOPED_TRACE("seed " + std::to_string(seed) + ", " +
                         eliminant::testing::describe(Ideal(ring, generators)));
            EXPECT_EQ(found(ring, generators, {}), expected(ring, generators));
        }
    }
}

TEST(ModularBasis, IsThatOfTheClassicAlgorithmOnClassicalSystems) {
    base::Run run;
    for (const char* name : {"chandra6", "cyclic5", "cyclic6", "eco8", "katsura6", "noon5"}) {
        SCOPED_TRACE(name);
        const System system = classical_system(name, CoefficientField::rationals(), run);
        EXPECT_EQ(found(system.ring, system.polynomials, {}), expected(system.ring, system.polynomials));
        EXPECT_EQ(found(system.ring, system.polynomials, {}, 3), expected(system.ring, system.polynomials));
    }
}

TEST(ModularBasis, OfTrivialIdeals) {
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    EXPECT_TRUE(found(ring, {}, {}).empty());
    EXPECT_TRUE(found(ring, {Polynomial(ring)}, {}).empty());
    EXPECT_EQ(found(ring, parse(ring, {"x*y-1", "x"}), {}), parse(ring, {"1"}));
}

struct BadPrime {
    const char* what;
    std::vector<std::string> generators; ///< in x, y, z, degrevlex; P stands for the prime
};

std::vector<Polynomial> generators_of(const Ring& ring, const BadPrime& example) {
    std::vector<std::string> texts = example.generators;
    for (std::string& text : texts) {
        for (std::size_t at = text.find('P'); at != std::string::npos; at = text.find('P'))
            text.replace(at, 1, std::to_string(bad));
    }
    return parse(ring, texts);
}

const std::vector<BadPrime>& bad_primes() {
    static const std::vector<BadPrime> examples = {
        {"divides a leading coefficient", {"P*x^2+y", "x*y+z"}},
        {"divides another coefficient", {"x^2+P*y", "x*y+z"}},
        {"divides a denominator", {"x^2+1/P*y", "x*y+z"}},
        {"divides a leading coefficient of the basis", {"x^2+y+1", "x^2+(P+1)*y+2"}},
        {"makes a generator superfluous", {"x^2+x*y+z^2", "x^2+(P+1)*x*y+z^2"}},
        {"makes two generators one", {"x^2+y*z", "x^2+(P+1)*y*z", "x*y+z^2"}},
        {"makes a coefficient of the basis vanish", {"x+y+(P+1)*z", "y+z", "z^2-2"}},
        {"makes the ideal the unit ideal", {"x+y", "x+y+P*z-1", "z^2-3"}},
    };
    return examples;
}

TEST(ModularBasis, IsRightWhenTheFirstPrimeIsBad) {
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"});
    for (const BadPrime& example : bad_primes()) {
        SCOPED_TRACE(example.what);
        const auto generators = generators_of(ring, example);
        EXPECT_EQ(found(ring, generators, {bad}), expected(ring, generators));
    }
}

TEST(ModularBasis, IsRightWhenALaterPrimeIsBad) {
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"});
    for (const BadPrime& example : bad_primes()) {
        SCOPED_TRACE(example.what);
        const auto generators = generators_of(ring, example);
        EXPECT_EQ(found(ring, generators, {2147483647, bad}), expected(ring, generators));
        EXPECT_EQ(found(ring, generators, {2147483647, 2147483629, bad, 7, 5}), expected(ring, generators));
    }
}

TEST(ModularBasis, IsRightWhenManyFirstPrimesAreBad) {
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"});
    std::vector<std::uint32_t> primes;
    mpz_class product = 1;
    for (std::uint64_t p = 1U << 30U; primes.size() < 6;) {
        p = algebra::previous_prime(p);
        primes.push_back(static_cast<std::uint32_t>(p));
        product *= primes.back();
    }
    const std::string P = mpz_class(product + 1).get_str();
    for (const auto& generators : {parse(ring, {"x^2+x*y+z^2", "x^2+" + P + "*x*y+z^2"}),
                                   parse(ring, {"x+y+" + P + "*z", "y+z", "z^2-2"})})
        EXPECT_EQ(found(ring, generators, primes), expected(ring, generators));
}

TEST(ModularBasis, CanBeStoppedFromAnotherThread) {
    base::Run run;
    const System system = classical_system("chandra9", CoefficientField::rationals(), run);
    for (const int milliseconds : {5, 40}) {
        base::Run stopped;
        std::thread stopper([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
            stopped.request_stop();
        });
        EXPECT_THROW(static_cast<void>(
                         ModularBasis(system.ring, system.polynomials, {}, PrimeSequence(0), stopped).find()),
                     Stopped);
        stopper.join();
    }
}

} // namespace
