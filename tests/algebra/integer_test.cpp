#include "eliminant/algebra/integer.hpp"
#include "eliminant/base/error.hpp"

#include "support/random_polynomials.hpp"

#include <gtest/gtest.h>

using namespace eliminant;

namespace {

/// Integers that crowd the borders between one word, inline and large.
std::vector<Integer> samples(std::mt19937_64& random) {
    std::vector<Integer> values;
    for (const unsigned bits :
         {0U, 1U, 2U, 31U, 32U, 61U, 62U, 63U, 64U, 65U, 124U, 126U, 127U, 128U, 129U, 300U}) {
        for (int i = 0; i < 4; ++i) values.push_back(eliminant::testing::random_integer(random, bits));
    }
    mpz_class border = 1;
    border <<= 62;
    for (int d = -2; d <= 2; ++d) {
        values.emplace_back(mpz_class(border + d));
        values.emplace_back(mpz_class(-border + d));
    }
    return values;
}

/// The representation is canonical: inline exactly when −2^62 ≤ value < 2^62.
void expect_value(const Integer& found, const mpz_class& expected, const char* what) {
    mpz_class limit = 1;
    limit <<= 62;
    EXPECT_EQ(found.to_mpz(), expected) << what;
    EXPECT_EQ(found.is_small(), expected >= -limit && expected < limit) << what << " = " << expected;
    EXPECT_EQ(found, Integer(expected)) << what;
}

TEST(Integer, AgreesWithGmpOnEveryPair) {
    std::mt19937_64 random(1);
    const auto values = samples(random);
    for (const Integer& a : values) {
        const mpz_class x = a.to_mpz();
        expect_value(-a, -x, "negation");
        expect_value(abs(a), abs(x), "absolute value");
        EXPECT_EQ(a.bit_length(), x == 0 ? 0 : mpz_sizeinbase(x.get_mpz_t(), 2));
        EXPECT_EQ(a.to_string(), x.get_str());
        EXPECT_EQ(a.sign(), sgn(x));
        EXPECT_EQ(a.residue(1000003), mpz_fdiv_ui(x.get_mpz_t(), 1000003));
        for (const Integer& b : values) {
            const mpz_class y = b.to_mpz();
            expect_value(a + b, x + y, "sum");
            expect_value(a - b, x - y, "difference");
            expect_value(a * b, x * y, "product");
            expect_value(gcd(a, b), gcd(x, y), "gcd");
            expect_value(lcm(a, b), lcm(x, y), "lcm");
            EXPECT_EQ(a < b, x < y);
            EXPECT_EQ(a == b, x == y);
            EXPECT_EQ(compare_magnitude(a, b) == 0, abs(x) == abs(y));
            Integer quotient;
            const bool divides = y == 0 ? x == 0 : mpz_divisible_p(x.get_mpz_t(), y.get_mpz_t()) != 0;
            EXPECT_EQ(a.try_divide(b, quotient), divides) << x << " / " << y;
            if (y == 0) continue;
            if (divides) expect_value(quotient, x / y, "quotient");
            Integer product = a * b;
            product.divide_exactly(b);
            expect_value(product, x, "exact quotient");
            Integer remainder;
            mpz_class q;
            mpz_class r;
            mpz_fdiv_qr(q.get_mpz_t(), r.get_mpz_t(), x.get_mpz_t(), y.get_mpz_t());
            expect_value(Integer::floor_divide(a, b, &remainder), q, "floor");
            expect_value(remainder, r, "remainder");
        }
    }
}

TEST(Integer, AddsProductsAlsoToItself) {
    std::mt19937_64 random(2);
    const auto values = samples(random);
    for (int round = 0; round < 4000; ++round) {
        const auto pick = [&]() -> const Integer& { return values[random() % values.size()]; };
        Integer sum = pick();
        const Integer a = pick();
        const Integer b = pick();
        const mpz_class s = sum.to_mpz();
        sum.add_product(a, b);
        expect_value(sum, s + a.to_mpz() * b.to_mpz(), "added product");
        sum.subtract_product(a, b);
        expect_value(sum, s, "subtracted product");
        Integer self = sum;
        self.add_product(self, a);
        expect_value(self, s + s * a.to_mpz(), "product with itself");
        self = sum;
        self *= self;
        expect_value(self, s * s, "square");
        self = sum;
        self += self;
        expect_value(self, 2 * s, "double");
        const Integer& alias = self;
        self -= alias;
        EXPECT_TRUE(self.is_zero());
        self = std::move(sum);
        expect_value(self, s, "moved value");
    }
}

TEST(Integer, ReadsDigitsAndRefusesDivisionByZero) {
    EXPECT_EQ(Integer::from_digits("0"), Integer(0));
    EXPECT_EQ(Integer::from_digits("999999999999999999").to_string(), "999999999999999999");
    EXPECT_EQ(Integer::from_digits("4611686018427387904").to_string(), "4611686018427387904");
    EXPECT_EQ(Integer(~std::uint64_t{0}).to_string(), "18446744073709551615");
    EXPECT_THROW(Integer::floor_divide(Integer(1), Integer(0)), DomainError);
}

} // namespace
