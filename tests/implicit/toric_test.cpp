// Monomial parametrizations: equations, degrees and certificates, against elimination and for exponents that
// nothing else can treat.
#include "eliminant/implicit/certify.hpp"
#include "eliminant/implicit/verify.hpp"
#include "implicit/support.hpp"

namespace eliminant::implicit {
namespace {

Certificate certificate_of(const std::string& text) {
    base::Run run;
    const Parametrization parametrization = parametrization_of(text);
    const auto certificate = certify(parametrization, implicitize(parametrization, {}, run), run).certificate;
    EXPECT_TRUE(certificate) << text;
    return certificate.value_or(Certificate{});
}

bool holds(const Certificate& certificate) {
    base::Run run;
    return verify(certificate, run).holds;
}

/// A term in the names with exponents from −3 to 6, a factor in the constants, and a random coefficient.
std::string random_term(const std::vector<std::string>& names, std::mt19937_64& random) {
    std::string text = std::to_string(static_cast<int>(random() % 11) - 5);
    if (text == "0") text = "-7/4";
    for (const std::string& name : names) {
        const int exponent = static_cast<int>(random() % 10) - 3;
        text.append("*").append(name).append("^(").append(std::to_string(exponent)).append(")");
    }
    return text;
}

TEST(Toric, AgreesWithElimination) {
    constexpr std::uint64_t seed = 20260101;
    std::mt19937_64 random(seed);
    int toric = 0;
    for (int i = 0; i < 60; ++i) {
        std::vector<std::string> names = {"t"};
        if (i % 2 == 1) names.emplace_back("s");
        if (i % 5 == 0) names.emplace_back("r");
        std::string text = i % 5 == 0 ? "constants r\n" : "";
        const std::vector<std::string> coordinates = {"x", "y", "z"};
        for (int j = 0; j < 2 + i % 2; ++j)
            text.append(coordinates[static_cast<std::size_t>(j)])
                .append(" = ")
                .append(random_term(names, random))
                .append("\n");
        const auto result = implicitized(text, {.parametrization_degree = true});
        const auto expected =
            implicitized(text, {.method = Method::groebner, .parametrization_degree = true});
        EXPECT_EQ(joined(result.equations), joined(expected.equations)) << text;
        EXPECT_EQ(result.codimension, expected.codimension) << text;
        EXPECT_EQ(result.parametrization_degree, expected.parametrization_degree) << text;
        if (result.method != Method::toric) continue;
        ++toric;
        EXPECT_TRUE(holds(certificate_of(text))) << text;
    }
    EXPECT_GT(toric, 30);
}

TEST(Toric, TreatsAllExponentsAlike) {
    EXPECT_EQ(equations_of("x = t^99999999\ny = t^99999998"), "y^99999999-x^99999998");
    EXPECT_EQ(equations_of("x = t^4611686018427387904\ny = -t^4611686018427387902"),
              "y^2305843009213693952-x^2305843009213693951");
    EXPECT_EQ(equations_of("x = 2*s^1000000*t^3\ny = s*t\nz = 3*s^1000003*t^6"), "3*x*y^3-2*z");
    EXPECT_EQ(equations_of("x = 5"), "x-5");
    EXPECT_EQ(equations_of("x = -1/t\ny = t/2"), "2*x*y+1");
    EXPECT_EQ(equations_of("constants r\nx = r^2*t^2/3\ny = 5*t^3"), "675*x^3-y^2*r^6");
    const auto degree = [](const char* text) {
        return implicitized(text, {.parametrization_degree = true}).parametrization_degree;
    };
    EXPECT_EQ(degree("x = t^99999999\ny = t^99999996"), 3U);
    EXPECT_EQ(degree("x = s^2*t^4\ny = s^6*t^2\nz = s^2*t^2"), 4U);
    EXPECT_EQ(degree("x = s*t\ny = s^2*t^2"), std::nullopt);
}

TEST(Toric, OnlyWhereAllCoordinatesAreTermsAndOnlyWhenNoMethodWasAskedFor) {
    EXPECT_EQ(implicitized("x = t^3\ny = t^2").method, Method::toric);
    EXPECT_EQ(implicitized("x = t^3\ny = t^2", {.method = Method::linear}).method, Method::linear);
    EXPECT_NE(implicitized("x = t^3\ny = t^2+t").method, Method::toric);
    EXPECT_NE(implicitized("x = t^3\ny = t^2\nz = t").method, Method::toric);
    EXPECT_NE(implicitized("x = 0\ny = t^2").method, Method::toric);
    EXPECT_NE(implicitized("x = cos(u)\ny = sin(u)").method, Method::toric);
}

TEST(Toric, SaysWhatIsTooLarge) {
    EXPECT_THROW(implicitized("x = 2*t^99999999\ny = t^99999998"), OverflowError);
    EXPECT_THROW(implicitized("x = s^4611686018427387904*t\ny = s*t^4611686018427387904\nz = s*t^2"),
                 OverflowError);
}

TEST(Toric, CertificatesOfOtherEquationsAreRejected) {
    const Certificate good = certificate_of("x = 2*t^9\ny = -3*t^12");
    EXPECT_EQ(good.claims.theorem, Theorem::toric);
    ASSERT_EQ(good.equations, std::vector<std::string>{"27*x^4+16*y^3"});
    EXPECT_TRUE(holds(good));
    for (const char* equation : {"27*x^4-16*y^3", "16*x^4+27*y^3", "27*x^4+16*y^3+1", "x^4", "27*x^3+16*y^4",
                                 "729*x^8-256*y^6", "x*y-1", "27*x^4*y+16*y^4"}) {
        Certificate wrong = good;
        wrong.equations = {equation};
        EXPECT_FALSE(holds(wrong)) << equation;
        wrong.claims.degrees = {8};
        EXPECT_FALSE(holds(wrong)) << equation;
        wrong.claims.degrees = {5};
        EXPECT_FALSE(holds(wrong)) << equation;
    }
    Certificate wrong = good;
    wrong.input.coordinates.front().second = "2*t^9+1";
    EXPECT_FALSE(holds(wrong));
    wrong = good;
    wrong.claims.codimension = 0;
    EXPECT_FALSE(holds(wrong));
    wrong = good;
    wrong.claims.vanishing.emplace_back();
    EXPECT_FALSE(holds(wrong));
}

} // namespace
} // namespace eliminant::implicit
