// The file format of parametrizations, and every error in it.
#include "implicit/support.hpp"

#include <array>

namespace eliminant::implicit {
namespace {

std::vector<std::string> names_of(const Parametrization& parametrization,
                                  const std::vector<std::size_t>& indices) {
    std::vector<std::string> names;
    for (const std::size_t i : indices) names.push_back(parametrization.ring().names()[i]);
    return names;
}

using Names = std::vector<std::string>;

TEST(ParseParametrization, ReadsEveryKindOfStatement) {
    const Parametrization p = parametrization_of("# comment\r\n"
                                                 "\n"
                                                 "constants r   # a radius\n"
                                                 "parameters s, t\n"
                                                 "  x = (r*s)/(s^2+t^2+1)\n"
                                                 "y=2t\n"
                                                 "relation s^2+t^2=1\n");
    EXPECT_EQ(names_of(p, p.parameters()), (Names{"s", "t"}));
    EXPECT_EQ(names_of(p, p.constants()), Names{"r"});
    ASSERT_EQ(p.coordinates().size(), 2U);
    EXPECT_EQ(p.coordinates()[0].name, "x");
    EXPECT_EQ(to_string(p.coordinates()[0].value.numerator), "s*r");
    EXPECT_EQ(to_string(p.coordinates()[0].value.denominator), "s^2+t^2+1");
    EXPECT_EQ(to_string(p.coordinates()[1].value.numerator), "2*t");
    ASSERT_EQ(p.relations().size(), 1U);
    EXPECT_EQ(to_string(p.relations()[0]), "s^2+t^2-1");
    EXPECT_TRUE(p.warnings().empty());
}

TEST(ParseParametrization, TakesUnknownNamesForParametersWithoutAList) {
    const Parametrization p = parametrization_of("x = b*a\ny = b\nrelation c = a^2\nconstants b");
    EXPECT_EQ(names_of(p, p.parameters()), (Names{"a", "c"}));
    EXPECT_EQ(names_of(p, p.constants()), Names{"b"});
}

TEST(ParseParametrization, ReadsStatementsGivenOneByOne) {
    base::Run run;
    const std::array<SourceText, 2> statements = {SourceText("x = t^2", "argument 1"),
                                                  SourceText("y = t^3", "argument 2")};
    const Parametrization p = parse_parametrization(statements, run);
    EXPECT_EQ(p.coordinates().size(), 2U);
    EXPECT_EQ(names_of(p, p.parameters()), Names{"t"});
}

TEST(ParseParametrization, LetsStatementWordsBeCoordinates) {
    const Parametrization p = parametrization_of("parameters = t\nconstants = t^2\nrelation = t^3");
    EXPECT_EQ(p.coordinates().size(), 3U);
}

TEST(ParseParametrization, AllowsNoParametersAtAll) {
    const Parametrization p = parametrization_of("x = 1/2\ny = 3");
    EXPECT_TRUE(p.parameters().empty());
}

TEST(ParseParametrization, TurnsAnglesIntoPairs) {
    const Parametrization p = parametrization_of("x = cos(2u)\ny = sin(4*u) + sin(-2u)\nz = cos(v+v+v)^2");
    EXPECT_EQ(names_of(p, p.parameters()), (Names{"cos_2u", "sin_2u", "cos_3v", "sin_3v"}));
    ASSERT_EQ(p.rotations().size(), 2U);
    EXPECT_EQ(to_string(p.coordinates()[0].value.numerator), "cos_2u"); // of the angle 2u
    EXPECT_EQ(to_string(p.coordinates()[1].value.numerator), "2*cos_2u*sin_2u-sin_2u");
    EXPECT_EQ(to_string(p.coordinates()[2].value.numerator), "cos_3v^2");
    EXPECT_TRUE(p.warnings().empty());
}

TEST(ParseParametrization, ExpandsMultiplesOfAnAngle) {
    // The numbers cos(kθ), sin(kθ) at the rational point (3/5, 4/5) of the circle, by multiplication of 3/5 +
    // 4i/5.
    std::string text = "x = cos(u)\n";
    for (int k = 0; k <= 12; ++k) {
        const std::string number = std::to_string(k);
        const std::string multiple = k == 0 ? std::string("u") : number + "*u";
        text.append("c").append(number).append(" = cos(").append(multiple).append(")\n");
        text.append("s").append(number).append(" = sin(").append(multiple).append(")\n");
    }
    const Parametrization p = parametrization_of(text);
    const std::array<mpq_class, 2> point = {mpq_class(3, 5), mpq_class(4, 5)};
    mpq_class c = 1;
    mpq_class s = 0;
    for (std::size_t k = 0; k <= 12; ++k) {
        const std::size_t first = 1 + 2 * k;
        if (k != 0) {
            EXPECT_EQ(evaluate(p.coordinates()[first].value.numerator, point), c) << k;
            EXPECT_EQ(evaluate(p.coordinates()[first + 1].value.numerator, point), s) << k;
        }
        const mpq_class next = c * point[0] - s * point[1];
        s = s * point[0] + c * point[1];
        c = next;
    }
}

TEST(ParseParametrization, AvoidsNamesThatAreTaken) {
    const Parametrization p = parametrization_of("cos_u = cos(u)\ny = sin(u) + sin_u");
    EXPECT_EQ(names_of(p, p.parameters()), (Names{"cos_u_", "sin_u_", "sin_u"}));
}

TEST(ParseParametrization, WarnsOfAnAngleThatIsAlsoANumber) {
    const Parametrization p = parametrization_of("x = s*cos(t)\ny = s*sin(t)\nz = t");
    ASSERT_EQ(p.warnings().size(), 1U);
    EXPECT_NE(p.warnings()[0].find("parameter t"), std::string::npos);
    EXPECT_EQ(names_of(p, p.parameters()), (Names{"s", "t", "cos_t", "sin_t"}));
}

struct BadInput {
    std::string text;
    std::size_t line;
    std::size_t column;
    std::string message; ///< a part of it
};

TEST(ParseParametrization, SaysWhereAndWhatIsWrong) {
    const std::vector<BadInput> inputs = {
        {"", 1, 1, "expected a coordinate, as x = s*t, found end of text"},
        {"# nothing\nparameters s, t\n", 3, 1, "expected a coordinate"},
        {"x = s\nx = t", 2, 1, "'x', which is already a coordinate"},
        {"x = s\ny = x + t", 2, 5, "'x', which is a coordinate"},
        {"y = x + t\nx = s", 1, 5, "'x', which is a coordinate"},
        {"parameters s\nx = s\ny = s*u", 3, 7, "'u', which is neither"},
        {"parameters s\nx = s\ny = cos(u)", 3, 9, "'u', which is neither"},
        {"parameters s, t\nconstants r, t\nx = s", 2, 14, "'t', which is already a parameter"},
        {"constants r\nparameters r\nx = r", 2, 12, "'r', which is already a constant"},
        {"parameters s, s\nx = s", 1, 15, "found 's'"},
        {"parameters\nx = 1", 1, 11, "found end of line"},
        {"parameters s t\nx = s", 1, 14, "found 't'"},
        {"constants x\nx = 1", 2, 1, "'x', which is already a constant"},
        {"x = 1/(s-s)", 1, 7, "expected a denominator that is not zero"},
        {"x = s\ny = 1/(cos(u)^2+sin(u)^2-1)", 2, 5, "expected a denominator that is not zero"},
        {"x = s +", 1, 8, "end of text"},
        {"x = s + # and what", 1, 9, "end of line"},
        {"x s", 1, 3, "expected '=', found 's'"},
        {"x", 1, 2, "expected '=', found end of text"},
        {"2x = s", 1, 1, "expected the name of a coordinate"},
        {"= s", 1, 1, "expected the name of a coordinate"},
        {"x == s", 1, 4, "'='"},
        {"x = s = t", 1, 7, "'='"},
        {"x = s t", 1, 7, "'t'"},
        {"x = tan(s)", 1, 8, "'('"},
        {"cos = s", 1, 1, "found 'cos'"},
        {"parameters sin\nx = 1", 1, 12, "found 'sin'"},
        {"x = cos", 1, 8, "end of text"},
        {"x = cos(1)", 1, 5, "expected an integer multiple of one parameter"},
        {"x = cos(u/2)", 1, 5, "expected an integer multiple of one parameter"},
        {"x = cos(u^2)", 1, 5, "expected an integer multiple of one parameter"},
        {"x = cos(1/u)", 1, 5, "expected an integer multiple of one parameter"},
        {"x = cos(u+1)", 1, 5, "expected an integer multiple of one parameter"},
        {"x = cos(u-u)", 1, 5, "expected an integer multiple of one parameter"},
        {"x = cos(u+v)", 1, 11, "expected an integer multiple of one parameter"},
        {"constants r\nx = u*cos(r)", 2, 11, "expected an integer multiple of one parameter"},
        {"x = cos(sin(u))", 1, 9, "expected an integer multiple of one parameter"},
        {"x = cos(u) + cos(100000u)", 1, 14, "expected at most 2000 times"},
        {"x = sin(9223372036854775808u)", 1, 5, "below 2^62"},
        {"x = s\nrelation s^2", 2, 13, "expected '='"},
        {"x = s\nrelation 1/s = 0", 2, 10, "expected a polynomial"},
        {"x = s\nrelation x = 0", 2, 10, "'x', which is a coordinate"},
        {"x = s\nrelation s = t = 0", 2, 16, "'='"},
        {"x = s^99999999999999999999", 1, 7, "exponent"},
        {"x = \xff", 1, 5, "0xff"},
        {"x = \xe2\x88\x92s + \xc3\xa9", 1, 10, "found"},
    };
    for (const BadInput& input : inputs) {
        try {
            parametrization_of(input.text);
            ADD_FAILURE() << "no error in: " << input.text;
        } catch (const ParseError& error) {
            EXPECT_EQ(error.where().line, input.line) << input.text << '\n' << error.what();
            EXPECT_EQ(error.where().column, input.column) << input.text << '\n' << error.what();
            EXPECT_NE(std::string(error.what()).find(input.message), std::string::npos) << input.text << '\n'
                                                                                        << error.what();
        }
    }
}

TEST(Parametrization, RejectsWhatItsPartsDoNotFit) {
    const Ring ring(CoefficientField::rationals(), {"c", "s", "r"});
    const auto variable = [&](const char* name) { return Polynomial::variable(ring, name); };
    const Polynomial one = Polynomial::constant(ring, 1);
    const Coordinate x{"x", algebra::RationalFunction(variable("c"))};
    const auto with = [&](std::vector<std::size_t> constants, std::vector<Coordinate> coordinates,
                          std::vector<Rotation> rotations = {}) {
        return Parametrization(ring, std::move(constants), std::move(coordinates), std::move(rotations));
    };
    EXPECT_NO_THROW(with({2}, {x}, {{0, 1}}));
    EXPECT_THROW(with({3}, {x}), DomainError);
    EXPECT_THROW(with({2, 2}, {x}), DomainError);
    EXPECT_THROW(with({}, {}), DomainError);
    EXPECT_THROW(with({}, {x, x}), DomainError);
    EXPECT_THROW(with({}, {{"r", x.value}}), DomainError);
    EXPECT_THROW(with({}, {{"2", x.value}}), DomainError);
    EXPECT_THROW(with({2}, {x}, {{0, 2}}), DomainError);
    EXPECT_THROW(with({}, {x}, {{0, 0}}), DomainError);
    EXPECT_THROW(with({}, {x}, {{0, 1}, {1, 2}}), DomainError);
    const Polynomial circle = variable("c") * variable("c") + variable("s") * variable("s") - one;
    EXPECT_THROW(with({}, {{"x", algebra::RationalFunction(one, circle)}}, {{0, 1}}), DomainError);
    EXPECT_NO_THROW(with({}, {{"x", algebra::RationalFunction(one, circle)}}));
    const Ring modular(CoefficientField::prime(7), {"t"});
    EXPECT_THROW(Parametrization(modular, {}, {{"x", algebra::RationalFunction(Polynomial(modular))}}),
                 DomainError);
    EXPECT_THROW(Parametrization(ring, {},
                                 {{"x", algebra::RationalFunction(Polynomial::variable(
                                            ring.with_order(MonomialOrder::lex()), "c"))}}),
                 RingMismatchError);
}

} // namespace
} // namespace eliminant::implicit
