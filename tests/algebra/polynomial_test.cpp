#include "eliminant/algebra/arithmetic.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace eliminant;

namespace {

std::vector<Ring> sample_rings() {
    const std::vector<std::string> names = {"x", "y", "z"};
    std::vector<Ring> rings;
    for (const auto& field : {CoefficientField::rationals(), CoefficientField::prime(2),
                              CoefficientField::prime(101), CoefficientField::prime(2147483647)}) {
        rings.emplace_back(field, names, MonomialOrder::lex());
        rings.emplace_back(field, names, MonomialOrder::deglex());
        rings.emplace_back(field, names, MonomialOrder::degrevlex());
        rings.emplace_back(field, names, MonomialOrder::weighted({1, 2, 3}, MonomialOrder::TieBreak::lex));
        rings.emplace_back(field, names, MonomialOrder::weighted({3, 1, 2}, MonomialOrder::TieBreak::revlex));
        rings.emplace_back(field, names, MonomialOrder::elimination({1}));
        rings.emplace_back(field, names, MonomialOrder::matrix({{1, 1, 1}, {0, -1, 2}, {0, 0, -5}}));
    }
    return rings;
}

Polynomial random_polynomial(const Ring& ring, std::mt19937_64& random, std::size_t terms,
                             std::uint64_t max_degree) {
    PolynomialBuilder builder(ring);
    std::vector<std::uint64_t> exponents(ring.variable_count());
    for (std::size_t i = 0; i < terms; ++i) {
        for (auto& e : exponents) e = random() % (max_degree + 1);
        const auto numerator = static_cast<std::int64_t>(random() % 41) - 20;
        const bool fraction = ring.field().is_rationals() && random() % 4 == 0;
        builder.add(Integer(numerator), Integer(fraction ? 1 + static_cast<std::int64_t>(random() % 9) : 1),
                    exponents);
    }
    return builder.build();
}

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
