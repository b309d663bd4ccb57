#include "algebra/multiply.hpp"

#include "support/random_polynomials.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

using namespace eliminant;
using eliminant::algebra::multiply_with;
using eliminant::algebra::ProductKernel;
using eliminant::algebra::ProductOptions;
using eliminant::testing::random_polynomial;
using eliminant::testing::Shape;

namespace {

/// The slow twin: every product of two terms, sorted and added up.
Polynomial term_by_term(const Polynomial& a, const Polynomial& b) {
    PolynomialBuilder builder(a.ring());
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            const mpq_class c = a.coefficient(i) * b.coefficient(j);
            const Monomial m = a.monomial(i) * b.monomial(j);
            builder.add(Integer(c.get_num()), Integer(c.get_den()), m.exponents());
        }
    }
    return builder.build();
}

void expect_every_kernel_agrees(const Polynomial& a, const Polynomial& b, std::uint64_t seed) {
    base::Run run;
    const Polynomial expected = term_by_term(a, b);
    const auto where = [&] {
        return "seed " + std::to_string(seed) + ", " + a.ring().to_string() + ", " +
               std::to_string(a.size()) + " × " + std::to_string(b.size()) + " terms";
    };
    EXPECT_EQ(multiply(a, b, run), expected) << where();
    EXPECT_EQ(multiply(b, a, run), expected) << where();
    const ProductOptions forced[] = {{ProductKernel::heap},       {ProductKernel::kronecker},
                                     {ProductKernel::points},     {ProductKernel::window, 7},
                                     {ProductKernel::window, 11}, {ProductKernel::window, 0}};
    for (const ProductOptions& options : forced) {
        EXPECT_EQ(multiply_with(a, b, options, run), expected)
            << where() << ", kernel " << static_cast<int>(options.kernel) << ", window "
            << options.window_bits;
        EXPECT_EQ(multiply_with(b, a, options, run), expected) << where();
    }
}

std::vector<CoefficientField> fields() {
    return {CoefficientField::rationals(), CoefficientField::prime(2), CoefficientField::prime(65537),
            CoefficientField::prime(1073741827), CoefficientField::prime(2147483647)};
}

TEST(Multiply, AgreesWithItsTwinInEveryRing) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        std::mt19937_64 random(seed);
        const std::size_t n = seed;
        for (const auto& field : fields()) {
            for (const auto& order : eliminant::testing::every_order(n, random)) {
                const Ring ring(field, eliminant::testing::variable_names(n), order);
                const Shape shape{1 + random() % 30, random() % 9, 1 + random() % 3, 20, true};
                expect_every_kernel_agrees(random_polynomial(ring, random, shape),
                                           random_polynomial(ring, random, shape), seed);
            }
        }
    }
}

TEST(Multiply, AgreesWithItsTwinForHugeExponents) {
    for (std::uint64_t seed = 1; seed <= 24; ++seed) {
        std::mt19937_64 random(seed);
        const std::size_t n = 1 + seed % 8;
        for (const auto& order : eliminant::testing::every_order(n, random)) {
            const Ring ring(fields()[seed % 5], eliminant::testing::variable_names(n), order);
            // Up to 2^45, so that no weighted degree of the product exceeds 2^63 in any of the orders.
            const unsigned bits = static_cast<unsigned>(random() % 46);
            const std::uint64_t stride = random() % 2 == 0 ? 1 : 1 + (random() >> (64 - bits / 2 - 1));
            const Shape shape{1 + random() % 20, std::uint64_t{1} << bits, stride, 20, false};
            Shape other = shape;
            other.max_exponent = 3;
            expect_every_kernel_agrees(random_polynomial(ring, random, shape),
                                       random_polynomial(ring, random, shape), seed);
            expect_every_kernel_agrees(random_polynomial(ring, random, shape),
                                       random_polynomial(ring, random, other), seed);
        }
    }
}

TEST(Multiply, AgreesWithItsTwinForCoefficientsOfEverySize) {
    // Around every border between accumulators and between inline and large integers.
    const unsigned sizes[] = {1,  28, 30, 31, 32,  33,  59,  60,  61,  62,
                              63, 64, 65, 95, 125, 126, 127, 128, 129, 3000};
    std::uint64_t seed = 0;
    for (const unsigned bits_a : sizes) {
        for (const unsigned bits_b : sizes) {
            std::mt19937_64 random(++seed);
            const Ring ring(CoefficientField::rationals(), eliminant::testing::variable_names(2));
            expect_every_kernel_agrees(random_polynomial(ring, random, {12, 3, 1, bits_a, false}),
                                       random_polynomial(ring, random, {12, 3, 1, bits_b, false}), seed);
        }
    }
}

TEST(Multiply, SumsOfExtremeProductsDoNotOverflowTheirAccumulators) {
    base::Run run;
    for (const unsigned bits : {31U, 32U, 58U, 61U, 62U, 63U}) {
        for (const int sign : {1, -1}) {
            const Ring ring(CoefficientField::rationals(), {"x"});
            mpz_class c = 1;
            c <<= bits;
            if (sign > 0) c -= 1;
            PolynomialBuilder builder(ring);
            for (std::uint64_t i = 0; i < 64; ++i) builder.add(Integer(mpz_class(sign * c)), std::vector{i});
            const Polynomial f = builder.build();
            expect_every_kernel_agrees(f, f, bits);
            expect_every_kernel_agrees(f, -f, bits);
        }
    }
    for (const std::uint64_t p : {2147483647ULL, 1073741827ULL, 3ULL}) {
        const Ring ring(CoefficientField::prime(p), {"x"});
        PolynomialBuilder builder(ring);
        for (std::uint64_t i = 0; i < 200; ++i) builder.add(Integer(-1), std::vector{i});
        expect_every_kernel_agrees(builder.build(), builder.build() - Polynomial::constant(ring, 1), p);
    }
}

TEST(Multiply, CancelsCompletely) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    const Polynomial x = Polynomial::variable(ring, 0);
    const Polynomial y = Polynomial::variable(ring, 1);
    const Polynomial one = Polynomial::constant(ring, 1);
    for (const auto kernel : {ProductKernel::heap, ProductKernel::window, ProductKernel::automatic}) {
        EXPECT_EQ(multiply_with(x + y, x - y, {kernel}, run), x * x - y * y);
        EXPECT_TRUE(multiply_with(x + y, Polynomial(ring), {kernel}, run).is_zero());
        EXPECT_EQ(multiply_with(one, x, {kernel}, run), x);
    }
}

TEST(Multiply, RefusesExponentsThatDoNotFit) {
    base::Run run;
    for (const auto& order : {MonomialOrder::lex(), MonomialOrder::degrevlex()}) {
        const Ring ring(CoefficientField::rationals(), {"x", "y"}, order);
        const std::uint64_t largest = (std::uint64_t{1} << 63) - 1;
        const auto power = [&](std::uint64_t e) {
            return Polynomial::term(Monomial(ring, std::vector<std::uint64_t>{e, 0}), 1) +
                   Polynomial::constant(ring, 1);
        };
        EXPECT_THROW(multiply(power(largest), power(1), run), OverflowError);
        EXPECT_EQ(multiply(power(largest - 1), power(1), run).degree(0), static_cast<std::int64_t>(largest));
    }
}

TEST(Multiply, StopsWhenTold) {
    for (const auto kernel : {ProductKernel::heap, ProductKernel::window}) {
        base::Run run;
        std::mt19937_64 random(1);
        const Ring ring(CoefficientField::rationals(), eliminant::testing::variable_names(6));
        const Polynomial f = random_polynomial(ring, random, {6000, 60, 1, 60, false});
        std::atomic<bool> started = false;
        std::thread stopper([&] {
            while (!started) std::this_thread::yield();
            run.request_stop();
        });
        started = true;
        EXPECT_THROW(static_cast<void>(multiply_with(f, f, {kernel}, run)), Stopped);
        stopper.join();
    }
}

} // namespace
