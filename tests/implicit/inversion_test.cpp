// Inversion formulas: put into the map they are the parameters, as rational functions; and there is none
// where several parameter values have one image.
#include "eliminant/implicit/inversion.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/rational_function.hpp"
#include "eliminant/base/error.hpp"
#include "implicit/support.hpp"

#include <algorithm>

namespace eliminant::implicit {
namespace {

Inversion inversion_of(const std::string& text) {
    base::Run run;
    return inversion(parametrization_of(text), run);
}

/// f at the coordinates of the parametrization, by the arithmetic of rational functions.
RationalFunction on_image(const Polynomial& f, const Parametrization& parametrization) {
    base::Run run;
    const Ring& ring = parametrization.ring();
    std::vector<RationalFunction> values;
    for (const Coordinate& coordinate : parametrization.coordinates()) values.push_back(coordinate.value);
    for (const std::size_t constant : parametrization.constants())
        values.emplace_back(Polynomial::variable(ring, constant));
    RationalFunction sum{Polynomial(ring)};
    for (std::size_t i = 0; i < f.size(); ++i) {
        RationalFunction term{Polynomial::constant(ring, f.coefficient(i))};
        for (std::size_t j = 0; j < values.size(); ++j) {
            const std::uint64_t e = f.exponent(i, j);
            term.numerator *= algebra::pow(values[j].numerator, e);
            term.denominator *= algebra::pow(values[j].denominator, e);
        }
        sum = in_lowest_terms({sum.numerator * term.denominator + term.numerator * sum.denominator,
                               sum.denominator * term.denominator},
                              run);
    }
    return sum;
}

/// Whether a polynomial is zero where the squares of cosine and sine add up to 1.
bool is_zero_on_rotations(const Polynomial& f, const Parametrization& parametrization) {
    base::Run run;
    const std::vector<Polynomial> circles = parametrization.rotation_relations();
    return normal_form(f, circles, run).is_zero();
}

void expect_inverse(const std::string& text) {
    const Parametrization parametrization = parametrization_of(text);
    const Inversion found = inversion_of(text);
    EXPECT_EQ(found.parametrization_degree, 1U) << text;
    ASSERT_EQ(found.parameters.size(), parametrization.parameters().size()) << text;
    for (const auto& [name, value] : found.parameters) {
        const Polynomial t = Polynomial::variable(parametrization.ring(), name);
        const RationalFunction top = on_image(value.numerator, parametrization);
        const RationalFunction bottom = on_image(value.denominator, parametrization);
        EXPECT_FALSE(is_zero_on_rotations(bottom.numerator, parametrization)) << text;
        EXPECT_TRUE(is_zero_on_rotations(
            t * bottom.numerator * top.denominator - top.numerator * bottom.denominator, parametrization))
            << text << '\n'
            << name << " = " << to_string(value);
    }
}

std::string formulas_of(const std::string& text) {
    std::string result;
    for (const auto& [name, value] : inversion_of(text).parameters)
        result.append(name).append(" = ").append(to_string(value)).append("\n");
    return result;
}

/// A dense polynomial with small coefficients.
std::string random_polynomial(std::mt19937_64& random, std::uint32_t degree_s, std::uint32_t degree_t) {
    std::string text = "0*t";
    for (std::uint32_t i = 0; i <= degree_s; ++i)
        for (std::uint32_t j = 0; j <= degree_t; ++j)
            text += " + (" + std::to_string(static_cast<int>(random() % 19) - 9) + ")" +
                    (i > 0 ? "*s^" + std::to_string(i) : "") + "*t^" + std::to_string(j);
    return text;
}

TEST(Inversion, IsTheInverseOfKnownMaps) {
    const std::vector<std::string> maps = {
        "x = (1-t^2)/(1+t^2)\ny = 2*t/(1+t^2)",
        "x = t^2-1\ny = t^3-t",
        "x = 3*t/(1+t^3)\ny = 3*t^2/(1+t^3)",
        "x = t^4\ny = t^6\nz = t^7/(t-2)",
        "x = t^3+t/3\ny = t^5-1/7\nz = t^2\nw = t^9",
        "x = s*t\ny = s\nz = t^2",
        "x = s*t\ny = s+t\nz = s-2*t+s*t",
        "x = s*t/(1+s^2+t^2)\ny = s/(1+s^2+t^2)\nz = t/(1+s^2+t^2)",
        "x = 2*s/(1+s^2+t^2)\ny = 2*t/(1+s^2+t^2)\nz = (1-s^2-t^2)/(1+s^2+t^2)",
        "x = 3*s+3*s*t^2-s^3\ny = 3*t+3*s^2*t-t^3\nz = 3*s^2-3*t^2",
        "x = s\ny = s*t\nz = s*t^2\nw = s*t^3",
        "x = r\ny = r*s\nz = r*t+s\nw = s*t",
    };
    for (const std::string& text : maps) expect_inverse(text);
}

TEST(Inversion, HasAnglesAndConstants) {
    expect_inverse("x = cos(u)\ny = sin(u)");
    expect_inverse("constants r\nx = r*cos(u)\ny = r*sin(u)+r^2");
    expect_inverse("constants R, r\nx = (R+r*cos(u))*cos(v)\ny = (R+r*cos(u))*sin(v)\nz = r*sin(u)");
    expect_inverse("constants a\nx = t^2-a\ny = t^3-a*t");
}

TEST(Inversion, IsTheInverseOfRandomMaps) {
    std::mt19937_64 random(5);
    for (int i = 0; i < 4; ++i) {
        const std::string curve = random_polynomial(random, 0, 4);
        expect_inverse("x = " + curve + "\ny = " + random_polynomial(random, 0, 5));
        const std::string bottom = random_polynomial(random, 0, 3);
        std::string rational = "x = (" + random_polynomial(random, 0, 3);
        rational.append(")/(").append(bottom).append(")\ny = (").append(random_polynomial(random, 0, 3));
        expect_inverse(rational.append(")/(").append(bottom).append(")"));
        expect_inverse("x = " + random_polynomial(random, 1, 1) + "\ny = " + random_polynomial(random, 1, 1) +
                       "\nz = " + random_polynomial(random, 1, 1));
        expect_inverse("x = " + random_polynomial(random, 1, 2) + "\ny = " + random_polynomial(random, 1, 1) +
                       "\nz = " + random_polynomial(random, 1, 1));
    }
}

TEST(Inversion, IsOfLeastDegree) {
    EXPECT_EQ(formulas_of("x = t^2\ny = t^3"), "t = (y)/(x)\n");
    EXPECT_EQ(formulas_of("x = t^7\ny = t/2"), "t = 2*y\n");
    EXPECT_EQ(formulas_of("x = s*t\ny = s\nz = t^2"), "s = y\nt = (x)/(y)\n");
    EXPECT_EQ(formulas_of("x = (1-t^2)/(1+t^2)\ny = -2*t/(1+t^2)"), "t = (x-1)/(y)\n");
    // Curves of degree n in the plane have a formula of degree n − 2 (there are more monomials than
    // conditions).
    const Inversion quintic = inversion_of("x = t^5+3*t^2-t\ny = t^4-t^3+2");
    EXPECT_LE(quintic.parameters.at(0).value.denominator.total_degree(), 3);
    EXPECT_LE(quintic.parameters.at(0).value.numerator.total_degree(), 3);
}

TEST(Inversion, OfPlaneCurvesOfHighDegreeComesFromMovingLines) {
    std::mt19937_64 random(7);
    const auto expect_degree = [](const std::string& text, std::int64_t degree) {
        // The identity is what inversion() proves; here it is looked at again at a point.
        const Inversion found = inversion_of(text);
        ASSERT_EQ(found.parameters.size(), 1U) << text;
        const auto& [numerator, denominator] = found.parameters[0].value;
        EXPECT_EQ(std::max(numerator.total_degree(), denominator.total_degree()), degree) << text;
        const Parametrization parametrization = parametrization_of(text);
        for (const mpq_class& t : {mpq_class(2), mpq_class(-3, 7)}) {
            std::vector<mpq_class> point;
            for (const Coordinate& coordinate : parametrization.coordinates())
                point.emplace_back(evaluate(coordinate.value.numerator, std::span(&t, 1)) /
                                   evaluate(coordinate.value.denominator, std::span(&t, 1)));
            EXPECT_EQ(evaluate(numerator, point), t * evaluate(denominator, point)) << text;
            EXPECT_NE(evaluate(denominator, point), 0) << text;
        }
    };
    for (const std::uint32_t degree : {18U, 21U}) {
        const std::string x = random_polynomial(random, 0, degree);
        const std::string y = random_polynomial(random, 0, degree);
        const std::string w = random_polynomial(random, 0, degree);
        std::string polynomial = "x = ";
        expect_degree(polynomial.append(x).append("\ny = ").append(y), degree - 2);
        std::string rational = "x = (";
        rational.append(x).append(")/(").append(w).append(")\ny = (").append(y);
        expect_degree(rational.append(")/(").append(w).append(")"), degree - 2);
    }
    expect_degree("x = t^30+t^2\ny = t^29-t", 28);
    expect_degree("x = t^40\ny = t", 1);
}

TEST(Inversion, NeedsAnInjectiveMap) {
    const Inversion twice = inversion_of("x = t^2\ny = t^4+t^2");
    EXPECT_EQ(twice.parametrization_degree, 2U);
    EXPECT_TRUE(twice.parameters.empty());
    EXPECT_EQ(inversion_of("x = s+t\ny = s*t\nz = s^2*t^2-s-t").parametrization_degree, 2U);
    EXPECT_EQ(inversion_of("x = s+t\ny = (s+t)^3\nz = 1").parametrization_degree, std::nullopt);
    EXPECT_EQ(inversion_of("parameters s, t\nx = t\ny = t^3").parametrization_degree, std::nullopt);
    EXPECT_EQ(inversion_of("x = cos(u)\ny = cos(2*u)").parametrization_degree, 2U);
    const Inversion point = inversion_of("x = 1\ny = 2");
    EXPECT_EQ(point.parametrization_degree, 1U);
    EXPECT_TRUE(point.parameters.empty());
}

TEST(Inversion, RefusesRelationsAndCanBeStopped) {
    EXPECT_THROW(inversion_of("relation s^2 = t^3\nx = s\ny = t"), DomainError);
    EXPECT_THROW(inversion_of("x = t^1000000000\ny = t^1000000001"), DomainError);
    base::Run run;
    run.request_stop();
    EXPECT_THROW(inversion(parametrization_of("x = t^2\ny = t^3"), run), Stopped);
}

} // namespace
} // namespace eliminant::implicit
