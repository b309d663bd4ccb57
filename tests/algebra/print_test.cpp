#include "eliminant/algebra/print.hpp"

#include "eliminant/algebra/parse.hpp"

#include "support/random_polynomials.hpp"

#include <gtest/gtest.h>

#include <sstream>

using namespace eliminant;

namespace {

TEST(Print, WritesTermsInTheRingsOrder) {
    const std::vector<std::string> names = {"x", "y", "z"};
    const auto print = [&](MonomialOrder order) {
        const Ring ring(CoefficientField::rationals(), names, std::move(order));
        return to_string(parse_polynomial(ring, "1 - x + y^3 - z^2*x/2 + 3/4*x^2"));
    };
    EXPECT_EQ(print(MonomialOrder::lex()), "3/4*x^2-1/2*x*z^2-x+y^3+1");
    EXPECT_EQ(print(MonomialOrder::deglex()), "-1/2*x*z^2+y^3+3/4*x^2-x+1");
    EXPECT_EQ(print(MonomialOrder::degrevlex()), "y^3-1/2*x*z^2+3/4*x^2-x+1");
}

TEST(Print, LeavesOutUnits) {
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    for (const char* text : {"0", "1", "-1", "x", "-x", "x*y-1", "-x^2*y^3-x+1", "3/4", "-3/4*x", "2*x-1/2"})
        EXPECT_EQ(to_string(parse_polynomial(ring, text)), text);
}

TEST(Print, WritesResiduesAsLeastNonNegativeNumbers) {
    const Ring ring(CoefficientField::prime(2147483647), {"x"});
    EXPECT_EQ(to_string(parse_polynomial(ring, "-x+1/2")), "2147483646*x+1073741824");
    const Ring two(CoefficientField::prime(2), {"x"});
    EXPECT_EQ(to_string(parse_polynomial(two, "-x^2-3")), "x^2+1");
}

TEST(Print, WritesLargeNumbers) {
    const Ring ring(CoefficientField::rationals(), {"x"});
    for (const char* text :
         {"4611686018427387904*x", "-4611686018427387904", "-4611686018427387905*x^9223372036854775807",
          "1000000000000000000000000000001/1000000000000000000000000000000*x"})
        EXPECT_EQ(to_string(parse_polynomial(ring, text)), text);
}

TEST(Print, ReadsBackInEveryRing) {
    std::mt19937_64 random(5);
    for (const Ring& ring : eliminant::testing::sample_rings()) {
        for (const std::uint64_t max_exponent : {1U, 3U, 200U, 70'000U}) {
            for (const std::uint64_t height : {1U, 20U, 4'000'000'000U}) {
                const Polynomial f =
                    eliminant::testing::random_polynomial(ring, random, random() % 12, max_exponent, height);
                const std::string text = to_string(f);
                EXPECT_EQ(parse_polynomial(ring, text), f) << ring << ": " << text;
                // The grammar without the fast path for monomials reads the same.
                EXPECT_EQ(parse_polynomial(ring, std::string("(").append(text).append(")")), f)
                    << ring << ": " << text;
            }
        }
    }
}

TEST(Print, ReadsBackWithAwkwardNames) {
    const Ring ring(CoefficientField::rationals(), {"e", "E", "e3", "x_1", "lambda"});
    std::mt19937_64 random(6);
    for (int i = 0; i < 20; ++i) {
        const Polynomial f = eliminant::testing::random_polynomial(ring, random, 6, 2);
        EXPECT_EQ(parse_polynomial(ring, to_string(f)), f) << f;
    }
}

TEST(Print, CanBeStopped) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    const Polynomial f = parse_polynomial(ring, "x-1/2*y");
    EXPECT_EQ(to_string(f, run), "x-1/2*y");
    run.request_stop();
    EXPECT_THROW(static_cast<void>(to_string(f, run)), Stopped);
}

TEST(Print, WritesRationalFunctionsAndStreams) {
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    EXPECT_EQ(to_string(RationalFunction(parse_polynomial(ring, "x-1"))), "x-1");
    EXPECT_EQ(to_string(RationalFunction(parse_polynomial(ring, "x-1"), parse_polynomial(ring, "y"))),
              "(x-1)/(y)");
    EXPECT_EQ(to_string(RationalFunction(parse_polynomial(ring, "x"), parse_polynomial(ring, "2"))), "1/2*x");
    EXPECT_THROW(RationalFunction(parse_polynomial(ring, "x"), Polynomial(ring)), DomainError);
    std::ostringstream out;
    out << parse_polynomial(ring, "x+y") << " in " << ring;
    EXPECT_EQ(out.str(), "x+y in QQ[x, y], degrevlex");
}

} // namespace
