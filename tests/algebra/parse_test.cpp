#include "eliminant/algebra/parse.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/print.hpp"

#include "support/random_polynomials.hpp"

#include <gtest/gtest.h>

#include <optional>

using namespace eliminant;

namespace {

const Ring rational_ring(CoefficientField::rationals(), {"x", "y", "z", "e"});

std::string reread(const std::string& text) { return to_string(parse_polynomial(rational_ring, text)); }

std::string parenthesised(const std::string& text) {
    return std::string("(").append(text).append(")"); // GCC 12 warns of a bug in "(" + text
}

/// The error that reading ends in; a failure of the test if there is none.
template <class Read>
ParseError error_of(Read&& read) {
    try {
        read();
    } catch (const ParseError& error) {
        return error;
    }
    ADD_FAILURE() << "no error";
    return {{"", 0, 0}, "", "", ""};
}

ParseError polynomial_error(const Ring& ring, std::string_view text) {
    return error_of([&] { parse_polynomial(ring, SourceText(text, "text")); });
}

struct Wrong {
    std::string_view text;
    std::size_t line;
    std::size_t column;
    std::string_view expected; ///< a part of it
    std::string_view found;
};

void expect_errors(std::span<const Wrong> cases) {
    for (const Wrong& wrong : cases) {
        SCOPED_TRACE(wrong.text);
        const ParseError error = polynomial_error(rational_ring, wrong.text);
        EXPECT_EQ(error.where().line, wrong.line);
        EXPECT_EQ(error.where().column, wrong.column);
        EXPECT_NE(error.expected().find(wrong.expected), std::string::npos) << error.what();
        EXPECT_EQ(error.found(), wrong.found);
    }
}

TEST(Parse, ReadsTheOperators) {
    EXPECT_EQ(reread("x+y-z"), "x+y-z");
    EXPECT_EQ(reread("(x+1)*(x-1)"), "x^2-1");
    EXPECT_EQ(reread("((x))"), "x");
    EXPECT_EQ(reread("x**2*y^3"), "x^2*y^3");
    EXPECT_EQ(reread("(x+y)^3-(x+y)**3"), "0");
    EXPECT_EQ(reread("x/2/3"), "1/6*x");
    EXPECT_EQ(reread("6/2*3"), "9");
    EXPECT_EQ(reread("x/(3-1)"), "1/2*x");
    EXPECT_EQ(reread("x - (y - (z - 1))"), "x-y+z-1");
    EXPECT_EQ(reread("(x+y)*(x-x)"), "0");
}

TEST(Parse, BindsAMinusLooserThanAPower) {
    EXPECT_EQ(reread("-x^2"), "-x^2");
    EXPECT_EQ(reread("-2^2"), "-4");
    EXPECT_EQ(reread("(-x)^2"), "x^2");
    EXPECT_EQ(reread("x*-y^2"), "-x*y^2");
    EXPECT_EQ(reread("--x"), "x");
    EXPECT_EQ(reread("x--y"), "x+y");
    EXPECT_EQ(reread("+x-+-y"), "x+y");
    EXPECT_EQ(reread("x/-2"), "-1/2*x");
}

TEST(Parse, ReadsNumbersExactly) {
    EXPECT_EQ(reread("3/4"), "3/4");
    EXPECT_EQ(reread("0.25"), "1/4");
    EXPECT_EQ(reread(".5"), "1/2");
    EXPECT_EQ(reread("1.5e-3"), "3/2000");
    EXPECT_EQ(reread("1.5E+3"), "1500");
    EXPECT_EQ(reread("0.1+0.2-0.3"), "0");
    EXPECT_EQ(reread("007"), "7");
    EXPECT_EQ(reread("123456789012345678"), "123456789012345678");
    EXPECT_EQ(reread("1234567890123456789012345678901234567890*x"),
              "1234567890123456789012345678901234567890*x");
    EXPECT_EQ(reread("999999999999999999*x"), "999999999999999999*x");
    EXPECT_EQ(reread("9999999999999999999*x"), "9999999999999999999*x");
    EXPECT_EQ(reread("2^-3"), "1/8");
    EXPECT_EQ(reread("(2/3)^-2"), "9/4");
    EXPECT_EQ(reread("(-1)^9223372036854775807"), "-1");
}

TEST(Parse, TakesAnEWithDigitsForADecimal) {
    EXPECT_EQ(reread("2e-3"), "1/500"); // also where e is a variable
    EXPECT_EQ(reread("2e3"), "2000");
    EXPECT_EQ(reread("2e3*x"), "2000*x");
    EXPECT_EQ(reread("2e"), "2*e");
    EXPECT_EQ(reread("2e-x"), "-x+2*e");
    EXPECT_EQ(reread("2 e-3"), "2*e-3");
    EXPECT_EQ(reread("2*e-3"), "2*e-3");
    EXPECT_EQ(reread("2e^2"), "2*e^2");
    const Ring ring(CoefficientField::rationals(), {"e", "ex", "e3"});
    EXPECT_EQ(to_string(parse_polynomial(ring, "2ex")), "2*ex");
    EXPECT_EQ(to_string(parse_polynomial(ring, "2*e3+2e + 3")), "2*e+2*e3+3");
    EXPECT_EQ(to_string(parse_polynomial(ring, "2e-3")), "1/500");
    EXPECT_EQ(polynomial_error(ring, "1+2e3").where().column, 3U);
}

TEST(Parse, MultipliesOnlyANumberByWhatFollows) {
    EXPECT_EQ(reread("2x"), "2*x");
    EXPECT_EQ(reread("2 x"), "2*x");
    EXPECT_EQ(reread("2x^2"), "2*x^2");
    EXPECT_EQ(reread("3(x+1)"), "3*x+3");
    EXPECT_EQ(reread("3(x+1)^2"), "3*x^2+6*x+3");
    EXPECT_EQ(reread("2x*3y"), "6*x*y");
    EXPECT_EQ(reread("-2x/3"), "-2/3*x");
    EXPECT_EQ(reread("x*2(y+1)"), "2*x*y+2*x");
    EXPECT_EQ(reread("2(3)"), "6");
    EXPECT_EQ(reread("0.5x"), "1/2*x");
}

TEST(Parse, DividesByNegativeNumbers) {
    EXPECT_EQ(reread("x/(-1)"), "-x");
    EXPECT_EQ(reread("x+1/(-1)"), "x-1");
    EXPECT_EQ(reread("(x+y)/(1-2)"), "-x-y");
    EXPECT_EQ(reread("x/(-1)+y/2"), "-x+1/2*y");
    EXPECT_EQ(reread("(x/(-1))^3+(-1)^(-1)"), "-x^3-1");
    EXPECT_EQ(reread("x/(-2)+3/(-4)"), "-1/2*x-3/4");
    EXPECT_EQ(reread("(-1)/(-1)*x-1/(-1)/(-1)"), "x-1");
    const Ring ring(CoefficientField::prime(7), {"x"});
    EXPECT_EQ(to_string(parse_polynomial(ring, "x/(-1)+1/(-2)")), "6*x+3");
}

TEST(Parse, NeverGuessesAProduct) {
    const Wrong cases[] = {
        {"x y", 1, 3, "an operator", "'y'"},
        {"xy", 1, 1, "one of the variables x, y, z, e", "'xy'"},
        {"x 1", 1, 3, "an operator", "'1'"},
        {"x1", 1, 1, "one of the variables", "'x1'"},
        {"(x)(y)", 1, 4, "an operator", "'('"},
        {"x(y)", 1, 2, "an operator", "'('"},
        {"cos(x)", 1, 4, "there are no functions", "'('"},
        {"(x)y", 1, 4, "an operator", "'y'"},
        {"(x)2", 1, 4, "an operator", "'2'"},
        {"2 3", 1, 3, "an operator", "'3'"},
        {"2x y", 1, 4, "an operator", "'y'"},
        {"2x(y)", 1, 3, "an operator", "'('"},
        {"1/2x", 1, 4, "needs a '*'", "'x'"},
        {"1/2 x", 1, 5, "needs a '*'", "'x'"},
        {"1/2(x)", 1, 4, "needs a '*'", "'('"},
        {"x/2y", 1, 4, "needs a '*'", "'y'"},
        {"1/2x+y", 1, 4, "needs a '*'", "'x'"},
        {"x^2y", 1, 4, "needs a '*'", "'y'"},
        {"x^2 y", 1, 5, "needs a '*'", "'y'"},
        {"x^2(y)", 1, 4, "needs a '*'", "'('"},
        {"2^3x", 1, 4, "needs a '*'", "'x'"},
        {"x²y", 1, 3, "needs a '*'", "'y'"},
        {"2e3x", 1, 4, "an operator after the decimal", "'x'"},
        {"2e-3x", 1, 5, "an operator after the decimal", "'x'"},
        {"2ex", 1, 2, "one of the variables", "'ex'"},
        {"2^3^2", 1, 4, "parentheses", "'^'"},
        {"x²^3", 1, 3, "parentheses", "'^'"},
        {"x^2³", 1, 4, "parentheses", "'³'"},
    };
    expect_errors(cases);
}

TEST(Parse, SaysWhereAFormulaBreaks) {
    const Wrong cases[] = {
        {"", 1, 1, "a number, a name or a parenthesis", "end of text"},
        {"# only a comment", 1, 17, "a number, a name or a parenthesis", "end of text"},
        {"x+", 1, 3, "a number, a name or a parenthesis", "end of text"},
        {"x+\ny*\n", 3, 1, "a number, a name or a parenthesis", "end of text"},
        {"*x", 1, 1, "a number, a name or a parenthesis", "'*'"},
        {"()", 1, 2, "a number, a name or a parenthesis", "')'"},
        {"((x)", 1, 5, "')'", "end of text"},
        {"(x", 1, 3, "')'", "end of text"},
        {"x)", 1, 2, "an operator or the end", "')'"},
        {"x = y", 1, 3, "an operator or the end", "'='"},
        {"x, y", 1, 2, "an operator or the end", "','"},
        {"x;", 1, 2, "an operator or the end", "';'"},
        {"x $", 1, 3, "an operator or the end", "'$'"},
        {"_x", 1, 1, "a number, a name or a parenthesis", "'_x'"},
        {"5.", 1, 2, "an operator or the end", "'.'"},
        {"1.2.3", 1, 4, "an operator or the end", "'.'"},
        {"1..2", 1, 2, "an operator or the end", "'.'"},
        {"x+\r\n  w", 2, 3, "one of the variables", "'w'"},
        {"α+1", 1, 1, "a number, a name or a parenthesis", "'α'"},
        {"x²+ß", 1, 4, "a number, a name or a parenthesis", "'ß'"},
        {"x\x01", 1, 2, "an operator or the end", "the control character 0x01"},
        {"averyverylongnamethatnobodyknows", 1, 1, "variables", "'averyverylongnamethatnob…'"},
    };
    expect_errors(cases);
}

TEST(Parse, RefusesWhatHasNoMeaning) {
    const Wrong cases[] = {
        {"x/0", 1, 3, "not zero", "'0'"},
        {"x/ (y-y)", 1, 4, "not zero", "'('"},
        {"0^-1", 1, 3, "not zero", "'-'"},
        {"0.0/0", 1, 5, "not zero", "'0'"},
        {"1/x", 1, 3, "divided by constants only", "'x'"},
        {"(x^2-1)/(x-1)", 1, 9, "divided by constants only", "'('"},
        {"x^-1", 1, 3, "not negative", "'-'"},
        {"x^(-1)", 1, 3, "not negative", "'('"},
        {"x⁻¹", 1, 2, "not negative", "'⁻'"},
        {"x^(1/2)", 1, 3, "an integer exponent", "(1/2)"},
        {"x^0.5", 1, 3, "an integer exponent", "'0.5'"},
        {"x^y", 1, 3, "an integer exponent", "'y'"},
        {"x^(y)", 1, 4, "an exponent is a constant", "'y'"},
        {"x^", 1, 3, "an integer exponent", "end of text"},
        {"x⁻", 1, 2, "an integer exponent", "'⁻'"},
        {"x⁻⁻¹", 1, 2, "an integer exponent", "'⁻'"},
    };
    expect_errors(cases);
}

TEST(Parse, TakesAnExponentByItsValue) {
    EXPECT_EQ(reread("x^(1+1)"), "x^2");
    EXPECT_EQ(reread("x^(4/2)"), "x^2");
    EXPECT_EQ(reread("x^2.0"), "x^2");
    EXPECT_EQ(reread("x^1e2"), "x^100");
    EXPECT_EQ(reread("x^0"), "1");
    EXPECT_EQ(reread("0^0"), "1");
    EXPECT_EQ(reread("(x-x)^0"), "1");
    EXPECT_EQ(reread("x^+2"), "x^2");
    // Exponents are integers also where coefficients are not: 1 + 1 = 0 in GF(2).
    const Ring ring(CoefficientField::prime(2), {"x"});
    EXPECT_EQ(to_string(parse_polynomial(ring, "x^(1+1)")), "x^2");
}

TEST(Parse, BoundsWhatItComputes) {
    const Wrong cases[] = {
        {"x^9223372036854775808", 1, 3, "below 2^63", "'9223372036854775808'"},
        {"x^99999999999999999999999999", 1, 3, "below 2^63", "'999999999999999999999999…'"},
        {"x^9223372036854775807*x", 1, 22, "below 2^63", "'*'"},
        {"x^4611686018427387904*x^4611686018427387904", 1, 22, "below 2^63", "'*'"},
        {"(x^4611686018427387904)^2", 1, 24, "below 2^63", "'^'"},
        {"x^(2^62)*(x^(2^62)+1)", 1, 9, "below 2^63", "'*'"},
        {"2^(10^12)", 1, 2, "bits", "'^'"},
        {"1+2^4000000*2^4000000", 1, 12, "bits", "'*'"},
        {"(((9^99999)^99999)^99999)", 1, 12, "bits", "'^'"},
        {"(x+y+z)^100000", 1, 8, "4 GiB", "a larger power"},
        {"(x+y)^9223372036854775807", 1, 6, "4 GiB", "a larger power"},
        {"(x+y+z+e)^1000*(x-y-z+1)^1000", 1, 10, "4 GiB", "a larger power"},
        {"1e1000000000", 1, 3, "a decimal exponent", "'1000000000'"},
        {"1e-99999999999999999999", 1, 3, "a decimal exponent", "'-'"},
    };
    expect_errors(cases);
    EXPECT_EQ(reread("x^9223372036854775807"), "x^9223372036854775807");
    EXPECT_EQ(reread("1^(10^12)"), "1");
    // A literal has no limit but its own length.
    const std::string digits(2'000'000, '7');
    EXPECT_EQ(reread(digits + "*x"), digits + "*x");
    EXPECT_EQ(reread(parenthesised(digits + "*x/3")), digits + "/3*x");
}

TEST(Parse, WeightedDegreesThatOverflowAreErrors) {
    const Ring ring(CoefficientField::rationals(), {"x", "y"},
                    MonomialOrder::weighted({1000, 1}, MonomialOrder::TieBreak::lex));
    EXPECT_EQ(polynomial_error(ring, "y+x^9223372036854775807").where().column, 2U);
    EXPECT_EQ(polynomial_error(ring, "(y+x^9223372036854775807)").where().column, 3U);
}

TEST(Parse, LimitsNesting) {
    const auto nested = [](std::size_t depth) {
        return std::string(depth, '(') + "x" + std::string(depth, ')');
    };
    EXPECT_EQ(reread(nested(Expression::max_nesting)), "x");
    const ParseError error = polynomial_error(rational_ring, nested(Expression::max_nesting + 1));
    EXPECT_EQ(error.where().column, Expression::max_nesting + 1);
    EXPECT_EQ(polynomial_error(rational_ring, nested(1'000'000)).where().column, Expression::max_nesting + 1);
    EXPECT_EQ(polynomial_error(rational_ring, std::string(1'000'000, '(')).where().column,
              Expression::max_nesting + 1);
    std::string exponents = "x";
    for (int i = 0; i < 1'000'000; ++i) exponents += "^(1";
    EXPECT_THROW(parse_polynomial(rational_ring, exponents), ParseError);
    EXPECT_EQ(reread(std::string(1'000'000, '-') + "x"), "x"); // signs nest nothing
}

TEST(Parse, ReadsWhatIsPastedFromPapers) {
    EXPECT_EQ(reread("x² − 2·x⋅y × z"), "-2*x*y*z+x^2");
    EXPECT_EQ(reread("x¹²⁰–3∗y"), "x^120-3*y");
    EXPECT_EQ(reread("x⁺²"), "x^2");
    EXPECT_EQ(reread("2⁻¹∕3 + 1⁄3"), "1/2");
    EXPECT_EQ(reread("x\u00A0+\u2009y\u202F-\u3000z"), "x+y-z");
    EXPECT_EQ(reread("\uFEFFx + y\r\n"), "x+y");
    EXPECT_EQ(reread("x # first\n + y # second"), "x+y");
    EXPECT_EQ(polynomial_error(rational_ring, "\uFEFFx + w").where().column, 5U);
    EXPECT_EQ(polynomial_error(rational_ring, "x\uFEFF").where().column, 2U);
}

TEST(Parse, RefusesBytesThatAreNoText) {
    const Wrong cases[] = {
        {std::string_view("x\0y", 3), 1, 2, "UTF-8", "a NUL byte"},
        {"x + \xff", 1, 5, "UTF-8", "the byte 0xff, which is not UTF-8"},
        {"é\xc3", 1, 2, "UTF-8", "the byte 0xc3, which is not UTF-8"},
        {"x # \xc0\x80", 1, 5, "UTF-8", "the byte 0xc0, which is not UTF-8"},                  // overlong
        {"x+y+z+e+12345678\xed\xa0\x80", 1, 17, "UTF-8", "the byte 0xed, which is not UTF-8"}, // surrogate
        {"\xf4\x90\x80\x80", 1, 1, "UTF-8", "the byte 0xf4, which is not UTF-8"}, // above U+10FFFF
    };
    expect_errors(cases);
}

TEST(Parse, ReportsTheLine) {
    const ParseError error = polynomial_error(rational_ring, "x +\r\n  2 y z\r\n+ 1");
    EXPECT_EQ(error.line_text(), "  2 y z");
    EXPECT_STREQ(error.what(), "text:2:7: expected an operator or the end of the formula, found 'z'");
}

TEST(Parse, WorksInPrimeFields) {
    const Ring ring(CoefficientField::prime(5), {"x"});
    const auto read = [&](std::string_view text) { return to_string(parse_polynomial(ring, text)); };
    EXPECT_EQ(read("-x"), "4*x");
    EXPECT_EQ(read("7/3*x"), "4*x");
    EXPECT_EQ(read("(7/3)*x"), "4*x");
    EXPECT_EQ(read("5*x"), "0");
    EXPECT_EQ(read("2^(10^12)"), "1");
    EXPECT_EQ(read("3^-1"), "2");
    EXPECT_EQ(read("12345678901234567890123*x"), "3*x");
    EXPECT_EQ(polynomial_error(ring, "x + 1/10").where().column, 7U);
    EXPECT_EQ(polynomial_error(ring, "0.1x").where().column, 1U);
    EXPECT_EQ(polynomial_error(ring, "5^-1").where().column, 3U);
}

TEST(Parse, ReadsConstantsWhereThereAreNoVariables) {
    const Ring ring(CoefficientField::rationals(), {});
    EXPECT_EQ(to_string(parse_polynomial(ring, "2/3+1")), "5/3");
    EXPECT_EQ(polynomial_error(ring, "1+x").expected(), "a number, as there are no variables");
}

TEST(Parse, ReadsEquations) {
    base::Run run;
    EXPECT_EQ(to_string(parse_equation(rational_ring, "x^2 = y + 1", run)), "x^2-y-1");
    EXPECT_EQ(to_string(parse_equation(rational_ring, "x^2", run)), "x^2");
    const auto column = [&](std::string_view text) {
        return error_of([&] { parse_equation(rational_ring, text, run); }).where().column;
    };
    EXPECT_EQ(column("x = y = z"), 7U);
    EXPECT_EQ(column("x == y"), 4U);
    EXPECT_EQ(column("x ="), 4U);
    EXPECT_EQ(column("= x"), 1U);
}

TEST(Parse, ReadsRationalFunctionsInLowestTerms) {
    const auto read = [](std::string_view text) {
        return to_string(parse_rational_function(rational_ring, text));
    };
    EXPECT_EQ(read("x+1"), "x+1");
    EXPECT_EQ(read("2x/(1+x^2)"), "(2*x)/(x^2+1)");
    EXPECT_EQ(read("1/x+1/y"), "(x+y)/(x*y)");
    EXPECT_EQ(read("1/x-1/x"), "0");
    EXPECT_EQ(read("(x^2-1)/(x-1)"), "x+1");
    EXPECT_EQ(read("x^-2"), "(1)/(x^2)");
    EXPECT_EQ(read("(x/y)^-3"), "(y^3)/(x^3)");
    EXPECT_EQ(read("((x+1)/y)^0"), "1");
    EXPECT_EQ(read("1/(1/x)"), "x");
    EXPECT_EQ(read("(x+1)/(x^2-1)+1/(x-1)"), "(2)/(x-1)");
    EXPECT_EQ(read("1/(1-x)"), "(-1)/(x-1)"); // the denominator's leading coefficient is positive
    const auto column = [](std::string_view text) {
        return error_of([&] { parse_rational_function(rational_ring, text); }).where().column;
    };
    EXPECT_EQ(column("x/(y-y)"), 3U);
    EXPECT_EQ(column("1/(1/x-1/x)"), 3U);
    EXPECT_EQ(column("(x-x)^-1"), 7U);
    EXPECT_EQ(column("x/w"), 3U);
    EXPECT_EQ(column("cos(x)"), 4U);
}

TEST(Parse, RationalFunctionsAreAField) {
    std::mt19937_64 random(11);
    for (const Ring& ring : eliminant::testing::sample_rings()) {
        const Polynomial a = eliminant::testing::random_polynomial(ring, random, 2, 1);
        const Polynomial b = eliminant::testing::random_nonzero(ring, random, 2, 1);
        const Polynomial c = eliminant::testing::random_nonzero(ring, random, 2, 1);
        const auto text = [](const Polynomial& f) { return parenthesised(to_string(f)); };
        SCOPED_TRACE(ring.to_string() + " " + text(a) + text(b) + text(c));
        const auto f = parse_rational_function(ring, text(a) + "/" + text(b) + "-" + text(b) + "/" + text(c));
        EXPECT_EQ(f.numerator * b * c, f.denominator * (a * c - b * b));
        const auto again = parse_rational_function(ring, to_string(f));
        EXPECT_EQ(again.numerator, f.numerator);
        EXPECT_EQ(again.denominator, f.denominator);
    }
}

TEST(Parse, ReadsLongSumsOfEveryKind) {
    // Each in linear time: a quadratic one would take minutes.
    std::string plain;
    std::string general;
    for (int i = 0; i < 50'000; ++i) {
        const std::string coefficient = std::to_string(i % 7 + 1);
        const std::string exponent = std::to_string(i);
        plain.append("+").append(coefficient).append("*x^").append(exponent).append("*y");
        general.append("+").append(coefficient).append("·(x^").append(exponent).append(")·y");
    }
    const Polynomial f = parse_polynomial(rational_ring, plain);
    EXPECT_EQ(f.size(), 50'000U);
    EXPECT_EQ(parse_polynomial(rational_ring, general), f);
    EXPECT_EQ(parse_polynomial(rational_ring, parenthesised(plain)), f);
    EXPECT_EQ(parse_rational_function(rational_ring, general).numerator, f);
}

TEST(Parse, CanBeStopped) {
    for (const char* text : {"x+y", "(x+y)^2", "(x+1)/(y+1)"}) {
        base::Run run;
        run.request_stop();
        EXPECT_THROW(parse_rational_function(rational_ring, text, run), Stopped);
        EXPECT_THROW(parse_polynomial(rational_ring, text, run), Stopped);
    }
    base::Run run(RunOptions{.time_limit_seconds = 0.05});
    EXPECT_THROW(parse_polynomial(rational_ring, "(x+y+z+e+1)^60", run), Stopped);
}

TEST(Parse, FindsTheNamesOfAText) {
    const std::vector<std::string> expected = {"t", "cos", "u_1", "x"};
    EXPECT_EQ(names_in("3t^2*cos(u_1) - x/t # not w\n + u_1"), expected);
    EXPECT_EQ(names_in("2e-3 + 2ex"), std::vector<std::string>{"ex"});
    EXPECT_TRUE(names_in("1 + 2").empty());
    EXPECT_THROW(names_in("x\xff"), ParseError);
}

TEST(Parse, ReadsListsOfNames) {
    EXPECT_EQ(parse_names("x, y_1 ,z"), (std::vector<std::string>{"x", "y_1", "z"}));
    const auto column = [](std::string_view text) {
        return error_of([&] { parse_names(text); }).where().column;
    };
    EXPECT_EQ(column(""), 1U);
    EXPECT_EQ(column("x,"), 3U);
    EXPECT_EQ(column("x y"), 3U);
    EXPECT_EQ(column("x,y,x"), 5U);
    EXPECT_EQ(column("x,2"), 3U);
}

TEST(Parse, ReadsRationals) {
    EXPECT_EQ(parse_rational("3/4"), mpq_class(3, 4));
    EXPECT_EQ(parse_rational("-0.5"), mpq_class(-1, 2));
    EXPECT_EQ(parse_rational("0"), 0);
    EXPECT_THROW(parse_rational("x"), ParseError);
    EXPECT_THROW(parse_rational("1 2"), ParseError);
    EXPECT_THROW(parse_rational(""), ParseError);
}

TEST(Parse, ReadsOrders) {
    const std::vector<std::string> names = {"x", "y", "z"};
    const auto read = [&](std::string_view text) { return parse_order(text, names).to_string(names); };
    EXPECT_EQ(read("lex"), "lex");
    EXPECT_EQ(read(" deglex "), "deglex");
    EXPECT_EQ(read("degrevlex"), "degrevlex");
    EXPECT_EQ(read("weight(1,2,3;lex)"), "weight(1,2,3;lex)");
    EXPECT_EQ(read("weight( 1, 2, 3 )"), "weight(1,2,3;revlex)");
    EXPECT_EQ(read("elim(z,x)"), "elim(z,x)");
    EXPECT_EQ(read("elim(z;x)"), "elim(z;x)");
    EXPECT_EQ(read("matrix(1,1,1;0,0,-1;0,-1,0)"), "matrix(1,1,1;0,0,-1;0,-1,0)");
    const auto column = [&](std::string_view text) {
        return error_of([&] { parse_order(text, names); }).where().column;
    };
    EXPECT_EQ(column("revlex"), 1U);
    EXPECT_EQ(column(""), 1U);
    EXPECT_EQ(column("lex x"), 5U);
    EXPECT_EQ(column("weight(1,2)"), 1U);
    EXPECT_EQ(column("weight(1,2,-3)"), 12U);
    EXPECT_EQ(column("weight(1,2,3;dp)"), 14U);
    EXPECT_EQ(column("weight(1,2,0;revlex)"), 1U);
    EXPECT_EQ(column("elim(x,w)"), 8U);
    EXPECT_EQ(column("elim(x,x)"), 1U);
    EXPECT_EQ(column("elim(x"), 7U);
    EXPECT_EQ(column("matrix(1,1;0,-1)"), 1U);
    EXPECT_EQ(column("matrix(1,1,1;0,0,1.5;0,1,0)"), 18U);
    const auto reason = [&](std::string_view text) {
        return error_of([&] { parse_order(text, names); }).found();
    };
    EXPECT_NE(reason("matrix(1,1,1;0,0,-1;0,0,-2)").find("rank"), std::string::npos);
    EXPECT_NE(reason("matrix(-1,1,1;0,0,-1;0,-1,0)").find("column 1 is negative"), std::string::npos);
}

TEST(Parse, ReadsFields) {
    EXPECT_EQ(parse_field(" QQ ").to_string(), "QQ");
    EXPECT_EQ(parse_field("GF(2147483647)").to_string(), "GF(2147483647)");
    const auto column = [](std::string_view text) {
        return error_of([&] { parse_field(text); }).where().column;
    };
    EXPECT_EQ(column("GF(10)"), 4U);
    EXPECT_EQ(column("GF(0)"), 4U);
    EXPECT_EQ(column("GF(2147483659)"), 4U); // the next prime above 2^31
    EXPECT_EQ(column("GF(99999999999999999999)"), 4U);
    EXPECT_EQ(column("GF(-7)"), 4U);
    EXPECT_EQ(column("GF 7"), 4U);
    EXPECT_EQ(column("ZZ"), 1U);
    EXPECT_EQ(column(""), 1U);
    EXPECT_EQ(column("QQ x"), 4U);
}

} // namespace
