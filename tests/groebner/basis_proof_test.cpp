#include "groebner/basis_proof.hpp"

#include "eliminant/algebra/parse.hpp"
#include "eliminant/groebner/groebner_basis.hpp"
#include "groebner/classical_systems.hpp"
#include "groebner/prime_pack.hpp"
#include "support/random_ideals.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace eliminant;
using eliminant::testing::classical_system;
using groebner::is_proved_groebner;
using groebner::PrimeSequence;

namespace {

constexpr std::uint32_t bad = 2147483587; // a prime

std::vector<Polynomial> parse(const Ring& ring, const std::vector<std::string>& texts) {
    std::vector<Polynomial> result;
    for (const std::string& text : texts) result.push_back(algebra::parse_polynomial(ring, text));
    return result;
}

bool is_proved(const std::vector<Polynomial>& elements, PrimeSequence primes = PrimeSequence(1)) {
    base::Run run;
    return is_proved_groebner(elements, {}, primes, run);
}

TEST(BasisProof, HoldsForClassicalSystems) {
    base::Run run;
    for (const char* name : {"chandra6", "cyclic5", "cyclic6", "eco8", "katsura6", "noon5"}) {
        const System system = classical_system(name, CoefficientField::rationals(), run);
        EXPECT_TRUE(is_proved(buchberger(system.ring, system.polynomials, {}, run).elements)) << name;
    }
}

TEST(BasisProof, IsRefusedWhereACoefficientIsWrong) {
    base::Run run;
    const System system = classical_system("katsura6", CoefficientField::rationals(), run);
    const std::vector<Polynomial> basis = buchberger(system.ring, system.polynomials, {}, run).elements;
    eliminant::testing::Random random(5);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<Polynomial> wrong = basis;
        Polynomial& f = wrong[random() % wrong.size()];
        const std::size_t term = 1 + random() % (f.size() - 1);
        algebra::PolynomialBuilder builder(system.ring);
        std::vector<std::uint64_t> exponents = f.monomial(term).exponents();
        // Once by 1, once by a multiple of many primes.
        builder.add(trial % 2 == 0 ? Integer(1) : pow(Integer(bad), 50), exponents);
        f = f + builder.build();
        EXPECT_FALSE(is_proved(wrong)) << "seed 5, trial " << trial;
    }
}

TEST(BasisProof, APrimeModuloWhichAnSPolynomialVanishesProvesNothing) {
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"});
    // The S-polynomial reduces to P·y²z.
    const auto elements = parse(ring, {"x*y+y*z+y^2", "x^2+x*z+" + std::to_string(bad - 1) + "*y*z-y^2"});
    EXPECT_FALSE(is_proved(elements, PrimeSequence(1, {bad})));
    EXPECT_FALSE(is_proved(elements));
}

TEST(BasisProof, SaysYesForBasesOnly) {
    const std::uint64_t seed = 3;
    eliminant::testing::Random random(seed);
    base::Run run;
    int bases = 0;
    int proved = 0;
    for (int round = 0; round < 60; ++round) {
        for (const Ring& ring : eliminant::testing::sample_rings()) {
            if (!ring.field().is_rationals()) continue;
            std::vector<Polynomial> generators;
            for (std::size_t i = 0; i < 1 + random() % 4; ++i) {
                const Polynomial f = eliminant::testing::random_small(ring, random, 3, 3, round % 2 == 0);
                if (!f.is_zero()) generators.push_back(f.primitive_part());
            }
            SCOPED_TRACE("seed " + std::to_string(seed) + ", " +
                         eliminant::testing::describe(Ideal(ring, generators)));
            EXPECT_TRUE(!is_proved(generators) || is_groebner(generators, run));
            const auto basis = Ideal(ring, generators).groebner_basis(run);
            ++bases;
            proved += is_proved({basis.begin(), basis.end()}) ? 1 : 0;
        }
    }
    // In lex reductions that raise degrees far are put off, and then nothing is proved.
    EXPECT_GE(proved, bases - 2);
}

TEST(PrimePack, ResiduesAreThoseOfDivision) {
    base::Run run;
    eliminant::testing::Random random(8);
    std::vector<Integer> integers = {Integer(0),          Integer(1),          Integer(-1),
                                     pow(Integer(2), 30), pow(Integer(2), 62), -pow(Integer(2), 64)};
    for (int i = 0; i < 400; ++i) {
        Integer n(1);
        for (std::size_t k = 0; k < random() % 30; ++k)
            n = n * Integer(static_cast<std::int64_t>(random() % (1U << 31U))) + Integer(1);
        integers.push_back(i % 2 == 0 ? n : -n);
    }
    PrimeSequence primes(4);
    groebner::LaneEntry numbers;
    for (std::uint32_t& p : numbers.lane) p = primes.next();
    groebner::PrimePack pack(numbers);
    const auto residues = pack.residues(groebner::DigitVector(integers), run);
    ASSERT_EQ(residues.size(), integers.size());
    for (std::size_t i = 0; i < integers.size(); ++i) {
        for (std::size_t lane = 0; lane < groebner::lane_count; ++lane)
            EXPECT_EQ(residues[i].lane[lane], pack.field(lane).from_integer(integers[i]))
                << integers[i].to_string();
    }
}

TEST(LaneKernels, SumsOfDigitsAreTheSameForAllUnits) {
    eliminant::testing::Random random(6);
    PrimeSequence primes(5);
    groebner::LaneEntry numbers;
    for (std::uint32_t& p : numbers.lane) p = primes.next();
    const groebner::LanePrimes lanes(numbers);
    std::vector<groebner::LaneEntry> powers(40);
    for (auto& power : powers) {
        for (std::size_t lane = 0; lane < groebner::lane_count; ++lane)
            power.lane[lane] = static_cast<std::uint32_t>(random() % numbers.lane[lane]);
    }
    std::vector<std::uint32_t> lengths;
    std::vector<std::uint32_t> digits;
    for (std::uint32_t i = 0; i < 60; ++i) {
        lengths.push_back(i % 41);
        for (std::uint32_t j = 0; j < lengths.back(); ++j)
            digits.push_back(static_cast<std::uint32_t>(random() % (1U << 30U)));
    }
    std::vector<groebner::LaneEntry> expected(lengths.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < lengths.size(); ++i, next += lengths[i - 1]) {
        for (std::size_t lane = 0; lane < groebner::lane_count; ++lane) {
            const algebra::PrimeField field(numbers.lane[lane]);
            std::uint32_t sum = 0;
            for (std::size_t j = 0; j < lengths[i]; ++j)
                sum = field.add(sum, field.multiply(field.reduce(digits[next + j]), powers[j].lane[lane]));
            expected[i].lane[lane] = field.negate(sum);
        }
    }
    for (const base::VectorUnit unit : base::available_vector_units()) {
        std::vector<groebner::LaneEntry> result(lengths.size());
        groebner::lane_kernels(unit).sum_digits(lanes, powers.data(), digits.data(), lengths.data(),
                                                lengths.size(), result.data());
        for (std::size_t i = 0; i < result.size(); ++i)
            EXPECT_TRUE(std::ranges::equal(result[i].lane, expected[i].lane)) << base::name(unit) << i;
    }
}

} // namespace
