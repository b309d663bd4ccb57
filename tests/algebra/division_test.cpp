#include "algebra/division.hpp"

#include "support/random_polynomials.hpp"

#include <gtest/gtest.h>

#include <thread>

using namespace eliminant;
using eliminant::algebra::QuotientKernel;
using eliminant::algebra::try_divide_with;
using eliminant::testing::random_nonzero;
using eliminant::testing::random_polynomial;

namespace {

/// The slow twin: the algorithm of Cox, Little, O'Shea, §2.3, word for word.
Division textbook_division(const Polynomial& f, const std::vector<Polynomial>& divisors) {
    Division result{std::vector<Polynomial>(divisors.size(), Polynomial(f.ring())), Polynomial(f.ring())};
    Polynomial rest = f;
    while (!rest.is_zero()) {
        const Monomial leading = rest.leading_monomial();
        const auto divides = [&](const Polynomial& g) { return g.leading_monomial().divides(leading); };
        const auto divisor = std::ranges::find_if(divisors, divides);
        if (divisor == divisors.end()) {
            result.remainder += rest.leading_term();
            rest = rest.tail();
            continue;
        }
        const Polynomial step = Polynomial::term(leading / divisor->leading_monomial(),
                                                 rest.leading_coefficient() / divisor->leading_coefficient());
        result.quotients[static_cast<std::size_t>(divisor - divisors.begin())] += step;
        rest -= step * *divisor;
    }
    return result;
}

std::vector<CoefficientField> fields() {
    return {CoefficientField::rationals(), CoefficientField::prime(2), CoefficientField::prime(65537),
            CoefficientField::prime(2147483647)};
}

void expect_quotient(const Polynomial& a, const Polynomial& b, const std::optional<Polynomial>& expected,
                     std::uint64_t seed) {
    base::Run run;
    const auto where = [&] { return "seed " + std::to_string(seed) + ", " + a.ring().to_string(); };
    EXPECT_EQ(try_divide(a, b), expected) << where();
    for (const unsigned bits : {0U, 7U, 10U, 13U})
        EXPECT_EQ(try_divide_with(a, b, {QuotientKernel::window, bits}, run), expected)
            << where() << ", window " << bits;
    EXPECT_EQ(try_divide_with(a, b, {QuotientKernel::dense, {}}, run), expected) << where();
}

/// (q·b)/b is q, and neighbours of q·b are divisible exactly if the textbook says so.
void expect_divisions_right(const Polynomial& q, const Polynomial& b, std::uint64_t seed) {
    const Polynomial a = q * b;
    expect_quotient(a, b, q, seed);
    for (const std::size_t i : {std::size_t{0}, a.size() / 2, a.size() - 1}) {
        const Polynomial off = a + Polynomial::term(a.monomial(i), 1);
        const Division division = textbook_division(off, {b});
        expect_quotient(
            off, b, division.remainder.is_zero() ? std::optional(division.quotients[0]) : std::nullopt, seed);
    }
}

TEST(ExactDivision, UndoesMultiplicationInEveryRing) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        std::mt19937_64 random(seed);
        const std::size_t n = seed;
        for (const auto& field : fields()) {
            for (const auto& order : eliminant::testing::every_order(n, random)) {
                const Ring ring(field, eliminant::testing::variable_names(n), order);
                const std::uint64_t stride = 1 + random() % 3;
                const Polynomial q =
                    random_nonzero(ring, random, {1 + random() % 12, random() % 9, stride, 20, true});
                const Polynomial b =
                    random_nonzero(ring, random, {1 + random() % 9, random() % 6, stride, 9, true});
                expect_divisions_right(q, b, seed);
            }
        }
    }
}

TEST(ExactDivision, UndoesMultiplicationForCoefficientsOfEverySize) {
    std::uint64_t seed = 0;
    for (const unsigned bits_q : {1U, 31U, 60U, 61U, 62U, 63U, 64U, 126U, 128U, 2000U}) {
        for (const unsigned bits_b : {1U, 31U, 61U, 62U, 63U, 64U, 127U, 2000U}) {
            std::mt19937_64 random(++seed);
            const Ring ring(CoefficientField::rationals(), eliminant::testing::variable_names(2));
            const Polynomial q = random_nonzero(ring, random, {10, 4, 1, bits_q, false});
            const Polynomial b = random_nonzero(ring, random, {8, 4, 1, bits_b, false});
            expect_quotient(q * b, b, q, seed);
        }
    }
}

TEST(ExactDivision, UndoesMultiplicationForHugeExponents) {
    for (std::uint64_t seed = 1; seed <= 16; ++seed) {
        std::mt19937_64 random(seed);
        const std::size_t n = 1 + seed % 6;
        for (const auto& order : eliminant::testing::every_order(n, random)) {
            const Ring ring(fields()[seed % 4], eliminant::testing::variable_names(n), order);
            const std::uint64_t largest = std::uint64_t{1} << (random() % 46);
            const Polynomial q = random_nonzero(ring, random, {8, largest, 1, 9, false});
            const Polynomial b = random_nonzero(ring, random, {6, largest, 1, 9, false});
            expect_quotient(q * b, b, q, seed);
        }
    }
}

TEST(ExactDivision, SeesWhatIsNotDivisible) {
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    const Polynomial x = Polynomial::variable(ring, 0);
    const Polynomial y = Polynomial::variable(ring, 1);
    const Polynomial one = Polynomial::constant(ring, 1);
    EXPECT_EQ(try_divide(x * x - y * y, x + y), x - y);
    EXPECT_EQ(try_divide(x * x + y * y, x + y), std::nullopt);
    EXPECT_EQ(try_divide(x, x * x), std::nullopt);
    EXPECT_EQ(try_divide(x + one, y + one), std::nullopt);
    EXPECT_EQ(try_divide(one, x), std::nullopt);
    EXPECT_EQ(try_divide(Polynomial(ring), x), Polynomial(ring));
    EXPECT_EQ(try_divide(x, one.scaled(mpq_class(2, 3))), x.scaled(mpq_class(3, 2)));
    EXPECT_THROW(static_cast<void>(try_divide(x, Polynomial(ring))), DomainError);
    EXPECT_THROW(divide_exactly(x, y), DomainError);
}

TEST(ExactDivision, StopsWhenTold) {
    std::mt19937_64 random(5);
    const Ring ring(CoefficientField::rationals(), eliminant::testing::variable_names(3));
    const Polynomial b = random_nonzero(ring, random, {400, 40, 1, 60, false});
    const Polynomial a = b * random_nonzero(ring, random, {400, 40, 1, 60, false});
    for (const unsigned bits : {0U, 12U}) {
        base::Run run;
        run.request_stop();
        EXPECT_THROW(static_cast<void>(try_divide_with(a, b, {QuotientKernel::window, bits}, run)), Stopped);
    }
    base::Run run;
    run.request_stop();
    EXPECT_THROW(static_cast<void>(divide(a, {&b, 1}, run)), Stopped);
}

TEST(Division, IsTheTextbooks) {
    base::Run run;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        std::mt19937_64 random(seed);
        const std::size_t n = 1 + seed % 5;
        for (const auto& order : eliminant::testing::every_order(n, random)) {
            const Ring ring(fields()[seed % 4], eliminant::testing::variable_names(n), order);
            const Polynomial f = random_polynomial(ring, random, {1 + random() % 12, 6, 1, 5, true});
            std::vector<Polynomial> divisors;
            for (std::size_t i = 0; i < seed % 4; ++i)
                divisors.push_back(random_nonzero(ring, random, {1 + random() % 4, 3, 1, 3, true}));
            const Division expected = textbook_division(f, divisors);
            const Division division = divide(f, divisors, run);
            const auto where = [&] { return "seed " + std::to_string(seed) + ", " + ring.to_string(); };
            EXPECT_EQ(division.quotients, expected.quotients) << where();
            EXPECT_EQ(division.remainder, expected.remainder) << where();
            EXPECT_EQ(normal_form(f, divisors, run), expected.remainder) << where();
        }
    }
}

TEST(Division, WidensItsExponents) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y"}, MonomialOrder::lex());
    const Polynomial x = Polynomial::variable(ring, 0);
    const auto power_of_y = [&](std::uint64_t e) {
        return Polynomial::term(Monomial(ring, std::vector<std::uint64_t>{0, e}), 1);
    };
    const Polynomial g = x - power_of_y(1000);
    EXPECT_EQ(normal_form(pow(x, 100), {&g, 1}, run), power_of_y(100000));
    const Polynomial huge = x - power_of_y(std::uint64_t{1} << 62);
    EXPECT_EQ(normal_form(x, {&huge, 1}, run), power_of_y(std::uint64_t{1} << 62));
    EXPECT_THROW(normal_form(x * x, {&huge, 1}, run), OverflowError);
}

TEST(Division, RefusesZeroDivisorsAndForeignRings) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x"});
    const Polynomial x = Polynomial::variable(ring, 0);
    const std::vector<Polynomial> zero = {x, Polynomial(ring)};
    EXPECT_THROW(divide(x, zero, run), DomainError);
    const Polynomial other = Polynomial::variable(Ring(CoefficientField::prime(7), {"x"}), 0);
    EXPECT_THROW(normal_form(x, {&other, 1}, run), RingMismatchError);
    EXPECT_EQ(normal_form(x, {}, run), x);
}

TEST(SPolynomial, CancelsTheLeadingTerms) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        std::mt19937_64 random(seed);
        const std::size_t n = 1 + seed % 4;
        for (const auto& order : eliminant::testing::every_order(n, random)) {
            const Ring ring(fields()[seed % 4], eliminant::testing::variable_names(n), order);
            const Polynomial f = random_nonzero(ring, random, {5, 100, 1, 70, true});
            const Polynomial g = random_nonzero(ring, random, {5, 100, 1, 5, true});
            const Monomial common = lcm(f.leading_monomial(), g.leading_monomial());
            const Polynomial expected = f.monic().times_term(common / f.leading_monomial(), 1) -
                                        g.monic().times_term(common / g.leading_monomial(), 1);
            EXPECT_EQ(s_polynomial(f, g), expected) << "seed " << seed << ", " << ring.to_string();
        }
    }
}

} // namespace
