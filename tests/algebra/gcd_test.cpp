#include "eliminant/algebra/gcd.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/calculus.hpp"

#include "algebra/gcd_remainders.hpp"
#include "support/random_polynomials.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

using namespace eliminant;
using namespace eliminant::testing;

namespace {

/// The definition, with the twin by remainder sequences for what is left.
void expect_gcd(const Polynomial& g, const Polynomial& a, const Polynomial& b, const std::string& where) {
    base::Run run;
    ASSERT_FALSE(g.is_zero()) << where;
    EXPECT_EQ(g, g.primitive_part()) << where;
    const auto cofactor_a = try_divide(a, g);
    const auto cofactor_b = try_divide(b, g);
    ASSERT_TRUE(cofactor_a && cofactor_b) << where;
    EXPECT_TRUE(algebra::gcd_by_remainders(*cofactor_a, *cofactor_b, run).is_constant()) << where;
}

TEST(Gcd, SatisfiesTheDefinitionInEveryOrderAndField) {
    std::mt19937_64 random(21);
    for (const Ring& ring : sample_rings()) {
        for (int round = 0; round < 2; ++round) {
            const Polynomial h = random_nonzero(ring, random, 3, 2);
            const Polynomial a = h * random_nonzero(ring, random, 3, 2);
            const Polynomial b = h * random_nonzero(ring, random, 3, 2);
            const Polynomial g = gcd(a, b);
            EXPECT_TRUE(try_divide(g, h)) << ring.to_string();
            expect_gcd(g, a, b, ring.to_string());
        }
    }
}

TEST(Gcd, IsMultiplicative) {
    std::mt19937_64 random(22);
    for (const Ring& ring : sample_fields()) {
        for (int round = 0; round < 10; ++round) {
            const Polynomial f = random_nonzero(ring, random, 3, 2);
            const Polynomial g = random_nonzero(ring, random, 3, 2);
            const Polynomial h = random_nonzero(ring, random, 3, 2);
            EXPECT_EQ(gcd(f * h, g * h), (h * gcd(f, g)).primitive_part()) << ring.to_string();
            EXPECT_EQ((lcm(f, g) * gcd(f, g)).primitive_part(), (f * g).primitive_part()) << ring.to_string();
        }
    }
}

TEST(Gcd, OfZeroAndConstants) {
    base::Run run;
    for (const Ring& ring : sample_fields()) {
        const Polynomial zero(ring);
        const Polynomial one = Polynomial::constant(ring, 1);
        const Polynomial x = Polynomial::variable(ring, 0);
        const Polynomial f = -(x * x) - x;
        EXPECT_EQ(gcd(zero, zero), zero);
        EXPECT_EQ(gcd(f, zero), x * x + x);
        EXPECT_EQ(gcd(zero, f), x * x + x);
        EXPECT_EQ(gcd(f, -one), one);
        EXPECT_EQ(gcd(one, one), one);
        EXPECT_EQ(gcd(f, f), x * x + x);
        EXPECT_EQ(lcm(zero, f), zero);
        EXPECT_EQ(lcm(one, f), x * x + x);
        EXPECT_FALSE(coprime(zero, zero, run));
        EXPECT_TRUE(coprime(zero, one, run));
        EXPECT_FALSE(coprime(f, x, run));
        EXPECT_TRUE(coprime(x, x + one, run));
        const std::array<Polynomial, 3> zeros = {zero, zero, zero};
        EXPECT_EQ(gcd(zeros, run), zero);
        const std::array<Polynomial, 3> mixed = {f * f, zero, f * x};
        EXPECT_EQ(gcd(mixed, run), (f * x).primitive_part());
    }
    EXPECT_THROW(gcd(std::span<const Polynomial>(), run), DomainError);
    EXPECT_THROW(gcd(Polynomial(Ring(CoefficientField::rationals(), {"x"})),
                     Polynomial(Ring(CoefficientField::rationals(), {"y"}))),
                 RingMismatchError);
}

TEST(Gcd, OfPthPowersInCharacteristicP) {
    for (const std::uint64_t p : {2U, 3U, 5U, 101U}) {
        const Ring ring(CoefficientField::prime(p), {"x", "y"});
        const Polynomial x = Polynomial::variable(ring, 0);
        const Polynomial y = Polynomial::variable(ring, 1);
        const Polynomial one = Polynomial::constant(ring, 1);
        // x^p − y^p = (x − y)^p.
        EXPECT_EQ(gcd(pow(x, p) - pow(y, p), x * x - y * y), p == 2 ? (x - y) * (x - y) : (x - y).monic());
        // x^p − x vanishes at every point of the field: no evaluation point there can tell it from 0.
        const Polynomial f = pow(x, p) - x;
        const Polynomial g = pow(y, p) - y;
        EXPECT_EQ(gcd(f, g), one);
        EXPECT_EQ(gcd(f * (x + y), g * (x + y)), (x + y).monic());
        EXPECT_EQ(gcd(f * g * (x + y), f * (x + y + one)), f);
        // Coprime, but equal at every value of y in the field.
        EXPECT_EQ(gcd(x * x + x + one + g, x * x + x + one + g * (x + y)), one);
    }
}

TEST(Content, IsTheGcdOfTheCoefficients) {
    base::Run run;
    std::mt19937_64 random(23);
    for (const Ring& ring : sample_fields()) {
        const Polynomial x = Polynomial::variable(ring, 0);
        const Polynomial y = Polynomial::variable(ring, 1);
        const Polynomial z = Polynomial::variable(ring, 2);
        const Polynomial one = Polynomial::constant(ring, 1);
        const Polynomial f = (y * y + y + one) * (z + one) * (x * x * y + x * z + one);
        const std::array<std::size_t, 1> in_x = {0};
        const std::array<std::size_t, 2> in_xy = {0, 1};
        EXPECT_EQ(content(f, in_x, run), (y * y + y + one) * (z + one));
        EXPECT_EQ(content(f, in_xy, run), z + one);
        EXPECT_EQ(content(f, {}, run), f);
        EXPECT_EQ(primitive_part(f, in_x, run), x * x * y + x * z + one);
        EXPECT_TRUE(content(Polynomial(ring), in_x, run).is_zero());
        const Polynomial g = random_nonzero(ring, random, 20, 3);
        EXPECT_EQ((content(g, in_x, run) * primitive_part(g, in_x, run)).primitive_part(),
                  g.primitive_part());
    }
}

void expect_squarefree_decomposition(const Polynomial& f, const Factorization& result,
                                     const std::string& where) {
    base::Run run;
    Polynomial product = Polynomial::constant(f.ring(), result.unit);
    Polynomial radical = Polynomial::constant(f.ring(), 1);
    std::uint64_t last = 0;
    for (const Factor& factor : result.factors) {
        EXPECT_GT(factor.multiplicity, last) << where;
        last = factor.multiplicity;
        EXPECT_FALSE(factor.base.is_constant()) << where;
        EXPECT_EQ(factor.base, factor.base.primitive_part()) << where;
        product *= pow(factor.base, factor.multiplicity);
        radical *= factor.base;
    }
    EXPECT_EQ(product, f) << where;
    // Squarefree over a perfect field: no factor divides all derivatives.
    Polynomial common = radical;
    for (const Polynomial& slope : gradient(radical)) common = gcd(common, slope);
    EXPECT_TRUE(common.is_constant()) << where;
    EXPECT_EQ(squarefree_part(f, run), radical.primitive_part()) << where;
}

TEST(SquarefreeDecomposition, MultipliesToThePolynomialOfSquarefreeParts) {
    base::Run run;
    std::mt19937_64 random(24);
    for (const Ring& ring : sample_fields({"x", "y"})) {
        for (int round = 0; round < 5; ++round) {
            const Polynomial a = random_nonzero(ring, random, 3, 2, 3);
            const Polynomial b = random_nonzero(ring, random, 3, 2, 3);
            const Polynomial f = (a * b * b * b * pow(Polynomial::variable(ring, 1), 6)).scaled(-1);
            if (f.is_zero()) continue;
            expect_squarefree_decomposition(f, squarefree_decomposition(f, run), ring.to_string());
        }
    }
}

TEST(SquarefreeDecomposition, TellsFactorsThatDerivativesMiss) {
    base::Run run;
    for (const std::uint64_t p : {2U, 3U, 5U, 7U}) {
        const Ring ring(CoefficientField::prime(p), {"x", "y"});
        const Polynomial x = Polynomial::variable(ring, 0);
        const Polynomial y = Polynomial::variable(ring, 1);
        const Polynomial one = Polynomial::constant(ring, 1);
        // Irreducible, and its derivative in x is 0.
        const Polynomial inseparable = pow(x, p) - y;
        expect_squarefree_decomposition(inseparable, squarefree_decomposition(inseparable, run),
                                        ring.to_string());
        EXPECT_EQ(squarefree_part(inseparable * inseparable, run), inseparable);
        const Polynomial f = pow(x + y, p) * pow(x + one, p * p) * pow(inseparable, p + 1) * (y + one);
        const Factorization result = squarefree_decomposition(f, run);
        expect_squarefree_decomposition(f, result, ring.to_string());
        ASSERT_EQ(result.factors.size(), 4U);
        EXPECT_EQ(result.factors[0].base, y + one);
        EXPECT_EQ(result.factors[1].multiplicity, p);
        EXPECT_EQ(result.factors[1].base, x + y);
        EXPECT_EQ(result.factors[2].multiplicity, p + 1);
        EXPECT_EQ(result.factors[3].multiplicity, p * p);
    }
}

TEST(SquarefreeDecomposition, OfConstantsHasNoFactors) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x"});
    EXPECT_EQ(squarefree_decomposition(Polynomial(ring), run).unit, 0);
    const Factorization result = squarefree_decomposition(Polynomial::constant(ring, mpq_class(-3, 2)), run);
    EXPECT_EQ(result.unit, mpq_class(-3, 2));
    EXPECT_TRUE(result.factors.empty());
    // Multiplicities far beyond what could be peeled off one by one.
    const Polynomial high = pow(Polynomial::variable(ring, 0), 1000000007);
    EXPECT_EQ(squarefree_part(high, run), Polynomial::variable(ring, 0));
}

} // namespace
