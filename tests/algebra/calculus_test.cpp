#include "eliminant/algebra/calculus.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/coefficients.hpp"
#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/algebra/grading.hpp"

#include "support/random_polynomials.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

using namespace eliminant;
using namespace eliminant::testing;

namespace {

Polynomial integer(const Ring& ring, std::int64_t value) {
    return Polynomial::constant(ring, mpq_class(value));
}

TEST(Derivative, ObeysLeibnizInEveryOrderAndField) {
    std::mt19937_64 random(11);
    for (const Ring& ring : sample_rings()) {
        const Polynomial f = random_polynomial(ring, random, 8, 7);
        const Polynomial g = random_polynomial(ring, random, 8, 7);
        for (std::size_t v = 0; v < 3; ++v) {
            EXPECT_EQ(derivative(f * g, v), derivative(f, v) * g + f * derivative(g, v)) << ring.to_string();
            EXPECT_EQ(derivative(f + g, v), derivative(f, v) + derivative(g, v)) << ring.to_string();
        }
    }
}

TEST(Derivative, OfAFormObeysEulersRelation) {
    std::mt19937_64 random(12);
    for (const Ring& ring : sample_rings()) {
        const std::array<std::uint64_t, 3> weights = {2, 1, 3};
        const Polynomial form = leading_form(random_nonzero(ring, random, 20, 4), weights);
        ASSERT_TRUE(is_homogeneous(form, weights));
        Polynomial sum(ring);
        const std::vector<Polynomial> slopes = gradient(form);
        for (std::size_t v = 0; v < 3; ++v)
            sum += integer(ring, static_cast<std::int64_t>(weights[v])) * Polynomial::variable(ring, v) *
                   slopes[v];
        EXPECT_EQ(sum, integer(ring, weighted_degree(form, weights)) * form) << ring.to_string();
    }
}

TEST(Derivative, OfACompositionObeysTheChainRule) {
    std::mt19937_64 random(13);
    base::Run run;
    for (const Ring& ring : sample_rings()) {
        const Ring source(ring.field(), {"u", "v"});
        const Polynomial f = random_polynomial(source, random, 6, 4);
        const std::vector<Polynomial> images = {random_polynomial(ring, random, 3, 2),
                                                random_polynomial(ring, random, 3, 2)};
        for (std::size_t v = 0; v < 3; ++v) {
            Polynomial expected(ring);
            for (std::size_t i = 0; i < 2; ++i)
                expected += compose(derivative(f, i), ring, images, run) * derivative(images[i], v);
            EXPECT_EQ(derivative(compose(f, ring, images, run), v), expected) << ring.to_string();
        }
    }
}

TEST(Derivative, OfAPthPowerVanishesInCharacteristicP) {
    for (const std::uint64_t p : {2U, 3U, 101U}) {
        const Ring ring(CoefficientField::prime(p), {"x", "y"});
        const Polynomial f = pow(Polynomial::variable(ring, 0) + Polynomial::variable(ring, 1), p);
        EXPECT_TRUE(derivative(f, 0).is_zero());
        EXPECT_TRUE(derivative(f, 1).is_zero());
    }
    EXPECT_THROW(derivative(Polynomial(Ring(CoefficientField::rationals(), {"x"})), 1), DomainError);
}

TEST(Evaluation, IsAHomomorphismAndAgreesWithComposition) {
    std::mt19937_64 random(14);
    base::Run run;
    for (const Ring& ring : sample_rings()) {
        const Polynomial f = random_polynomial(ring, random, 10, 9);
        const Polynomial g = random_polynomial(ring, random, 10, 9);
        // Denominators prime to 2, 3 and 101.
        const std::array<mpq_class, 3> point = {mpq_class(2, 5), mpq_class(-3), mpq_class(7, 25)};
        const auto value = [&](const Polynomial& h) {
            return Polynomial::constant(ring, evaluate(h, point));
        };
        EXPECT_EQ(value(f * g), value(f) * value(g)) << ring.to_string();
        EXPECT_EQ(value(f + g), value(f) + value(g)) << ring.to_string();
        std::vector<Polynomial> constants;
        for (const mpq_class& c : point) constants.push_back(Polynomial::constant(ring, c));
        EXPECT_EQ(value(f), compose(f, ring, constants, run)) << ring.to_string();
        // In two steps.
        const std::array<std::size_t, 2> outer = {2, 0};
        const std::array<mpq_class, 2> outer_values = {point[2], point[0]};
        EXPECT_EQ(evaluate(evaluate(f, outer, outer_values, run), 1, point[1], run), value(f))
            << ring.to_string();
    }
}

TEST(Evaluation, AtResiduesIsTheResidueOfTheValue) {
    std::mt19937_64 random(15);
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"});
    const PrimeField field(10007);
    for (int round = 0; round < 20; ++round) {
        const Polynomial f = random_polynomial(ring, random, 10, 9);
        const std::array<PrimeField::Element, 3> point = {17, 0, 10006};
        const mpq_class value = evaluate(f, std::array<mpq_class, 3>{17, 0, 10006});
        EXPECT_EQ(evaluate(f, field, point, run),
                  field.from_fraction(Integer(value.get_num()), Integer(value.get_den())));
    }
}

TEST(Composition, AgreesWithTheSumOfItsTerms) {
    std::mt19937_64 random(16);
    base::Run run;
    for (const Ring& ring : sample_rings()) {
        const Ring target = ring.with_order(MonomialOrder::deglex());
        const Polynomial f = random_polynomial(ring, random, 10, 5);
        // An image of each kind: several terms, one term, none.
        std::vector<Polynomial> images = {
            random_polynomial(target, random, 3, 3), random_polynomial(target, random, 1, 3),
            random() % 2 == 0 ? Polynomial(target) : random_polynomial(target, random, 2, 2)};
        Polynomial expected(target);
        for (std::size_t i = 0; i < f.size(); ++i) {
            Polynomial product = Polynomial::constant(target, f.coefficient(i));
            for (std::size_t v = 0; v < 3; ++v) product *= pow(images[v], f.exponent(i, v));
            expected += product;
        }
        EXPECT_EQ(compose(f, target, images, run), expected) << ring.to_string();
    }
}

TEST(Composition, OfARationalPolynomialMapsToAPrimeField) {
    base::Run run;
    const Ring from(CoefficientField::rationals(), {"t"});
    const Ring to(CoefficientField::prime(7), {"x", "y"});
    const Polynomial t = Polynomial::variable(from, 0);
    const Polynomial sum = Polynomial::variable(to, 0) + Polynomial::variable(to, 1);
    const std::array<Polynomial, 1> image = {sum};
    EXPECT_EQ(compose((t * t).scaled(mpq_class(1, 2)) + integer(from, 3), to, image, run),
              (sum * sum).scaled(4) + integer(to, 3));
    EXPECT_THROW(compose(t.scaled(mpq_class(1, 7)), to, image, run), DomainError);
}

TEST(Evaluation, RejectsWhatHasNoValue) {
    base::Run run;
    const Ring ring(CoefficientField::prime(5), {"x", "y"});
    const Polynomial x = Polynomial::variable(ring, 0);
    EXPECT_THROW(evaluate(x, std::array<mpq_class, 1>{1}), DomainError);
    EXPECT_THROW(evaluate(x, std::array<mpq_class, 2>{mpq_class(1, 5), 1}), DomainError);
    EXPECT_THROW(evaluate(x, 2, mpq_class(1), run), DomainError);
    EXPECT_THROW(evaluate(x, PrimeField(7), std::array<PrimeField::Element, 2>{1, 1}, run), DomainError);
    EXPECT_THROW(compose(x, ring, std::array<Polynomial, 1>{x}, run), DomainError);
    EXPECT_THROW(compose(x, Ring(CoefficientField::prime(7), {"t"}), {}, run), DomainError);
    EXPECT_THROW(substitute(x, 2, x, run), DomainError);
    // Powers that no memory holds, at values whose powers are trivial and at others.
    const Ring rationals(CoefficientField::rationals(), {"x"});
    const Polynomial high = pow(Polynomial::variable(rationals, 0), (std::uint64_t{1} << 60) + 1);
    EXPECT_EQ(evaluate(high, std::array<mpq_class, 1>{-1}), -1);
    EXPECT_EQ(evaluate(high, std::array<mpq_class, 1>{0}), 0);
    EXPECT_THROW(evaluate(high, std::array<mpq_class, 1>{2}), OverflowError);
    const std::array<Polynomial, 1> square = {pow(Polynomial::variable(rationals, 0), 16)};
    EXPECT_THROW(compose(high, rationals, square, run), OverflowError);
}

TEST(Composition, IsStoppedByItsRun) {
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    base::Run run;
    run.request_stop();
    const Polynomial f = pow(Polynomial::variable(ring, 0) + Polynomial::variable(ring, 1), 5);
    EXPECT_THROW(substitute(f, 0, f, run), Stopped);
}

TEST(Substitution, OfAVariableByItselfShifted) {
    base::Run run;
    for (const Ring& ring : sample_rings()) {
        std::mt19937_64 random(17);
        const Polynomial f = random_polynomial(ring, random, 10, 6);
        const Polynomial y = Polynomial::variable(ring, 1);
        const Polynomial shifted = substitute(f, 1, y + integer(ring, 1), run);
        EXPECT_EQ(substitute(shifted, 1, y - integer(ring, 1), run), f) << ring.to_string();
    }
}

TEST(Coefficients, AssembleToThePolynomial) {
    std::mt19937_64 random(18);
    for (const Ring& ring : sample_rings()) {
        const Polynomial f = random_polynomial(ring, random, 30, 3);
        const std::vector<std::vector<std::size_t>> choices = {{}, {0}, {2}, {2, 0}, {0, 1, 2}};
        for (const auto& variables : choices) {
            const auto terms = coefficients(f, variables);
            EXPECT_EQ(from_coefficients(ring, variables, terms), f) << ring.to_string();
            for (std::size_t i = 0; i < terms.size(); ++i) {
                EXPECT_FALSE(terms[i].coefficient.is_zero());
                for (const std::size_t v : variables) EXPECT_LE(terms[i].coefficient.degree(v), 0);
                if (i > 0) {
                    EXPECT_GT(terms[i - 1].exponents, terms[i].exponents);
                }
            }
        }
        for (const auto& term : coefficients(f, 1))
            EXPECT_EQ(coefficient(f, 1, term.exponents[0]), term.coefficient);
        EXPECT_TRUE(coefficient(f, 1, 77).is_zero());
    }
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    EXPECT_THROW(coefficients(Polynomial(ring), std::array<std::size_t, 2>{1, 1}), DomainError);
    EXPECT_THROW(coefficients(Polynomial(ring), 2), DomainError);
    EXPECT_TRUE(coefficients(Polynomial(ring), 1).empty());
}

TEST(Homogenization, IsUndoneByDehomogenization) {
    std::mt19937_64 random(19);
    for (const Ring& plain : sample_rings()) {
        const Ring ring(plain.field(), {"x", "y", "z", "h"});
        const Polynomial f = random_polynomial(plain, random, 10, 5).in_ring(ring);
        const std::array<std::uint64_t, 4> weights = {3, 1, 4, 1};
        const Polynomial form = homogenize(f, 3, weights);
        EXPECT_TRUE(is_homogeneous(form, weights));
        EXPECT_TRUE(homogenize(f, 3).is_homogeneous());
        EXPECT_EQ(weighted_degree(form, weights), weighted_degree(f, weights));
        EXPECT_EQ(dehomogenize(form, 3), f);
        EXPECT_EQ(dehomogenize(homogenize(f, 3), 3), f);
        Polynomial sum(ring);
        for (std::int64_t d = 0; d <= weighted_degree(f, weights); ++d)
            sum += homogeneous_part(f, static_cast<std::uint64_t>(d), weights);
        EXPECT_EQ(sum, f);
    }
}

TEST(Homogenization, RejectsWhatHasNoMeaning) {
    const Ring ring(CoefficientField::rationals(), {"x", "h"});
    const Polynomial f = Polynomial::variable(ring, 0) + integer(ring, 1);
    EXPECT_THROW(homogenize(f, 1, std::array<std::uint64_t, 2>{1, 0}), DomainError);
    EXPECT_THROW(homogenize(f, 1, std::array<std::uint64_t, 2>{1, 2}), DomainError);
    EXPECT_THROW(homogenize(f, 1, std::array<std::uint64_t, 1>{1}), DomainError);
    EXPECT_THROW(homogenize(f, 2), DomainError);
    const Polynomial x = Polynomial::variable(ring, 0);
    EXPECT_THROW(weighted_degree(x * x, std::array<std::uint64_t, 2>{std::uint64_t{1} << 62, 1}),
                 OverflowError);
    EXPECT_EQ(weighted_degree(Polynomial(ring)), -1);
}

} // namespace
