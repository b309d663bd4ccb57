#include "eliminant/algebra/system.hpp"

#include "eliminant/algebra/parse.hpp"
#include "eliminant/algebra/print.hpp"

#include "support/random_polynomials.hpp"

#include <gtest/gtest.h>

using namespace eliminant;

namespace {

System read(std::string_view text, SystemFormat format = SystemFormat::guess,
            const SystemOverrides& overrides = {}) {
    base::Run run;
    return parse_system(SourceText(text, "file"), format, overrides, run);
}

std::vector<std::string> texts_of(const System& system) {
    std::vector<std::string> texts;
    for (const Polynomial& f : system.polynomials) texts.push_back(to_string(f));
    return texts;
}

using Texts = std::vector<std::string>;

struct Wrong {
    std::string_view text;
    std::size_t line;
    std::size_t column;
};

void expect_errors(SystemFormat format, std::span<const Wrong> cases) {
    for (const Wrong& wrong : cases) {
        SCOPED_TRACE(wrong.text);
        try {
            read(wrong.text, format);
            ADD_FAILURE() << "no error";
        } catch (const ParseError& error) {
            EXPECT_EQ(error.where().line, wrong.line) << error.what();
            EXPECT_EQ(error.where().column, wrong.column) << error.what();
        }
    }
}

TEST(System, ReadsOurFormat) {
    const System system = read("# a system\r\n"
                               "variables x, y, z\r\n"
                               "order elim(z)\n"
                               "field GF(101)\n"
                               "\n"
                               "x^2 + y = 3*z   # an equation\n"
                               "  (x+y)^2/2\n");
    EXPECT_EQ(system.ring.to_string(), "GF(101)[x, y, z], elim(z)");
    EXPECT_EQ(texts_of(system), (Texts{"98*z+x^2+y", "51*x^2+x*y+51*y^2"}));
}

TEST(System, TakesTheNamesInOrderOfAppearance) {
    EXPECT_EQ(read("z*a - b\nx = a").ring.names(), (Texts{"z", "a", "b", "x"}));
    EXPECT_EQ(read("order elim(b)\na-b^2\n").ring.to_string(), "QQ[a, b], elim(b)");
    EXPECT_EQ(read("").polynomials.size(), 0U);
    EXPECT_EQ(read("2\n3/4").ring.variable_count(), 0U);
}

TEST(System, LetsVariablesBeCalledAsKeywords) {
    const System system = read("variables order, field\norder lex\norder + field\nfield^2 = 1\n");
    EXPECT_EQ(texts_of(system), (Texts{"order+field", "field^2-1"}));
    const System unit = parse_system(std::vector<SourceText>{"order"}, {}, *std::make_unique<base::Run>());
    EXPECT_EQ(texts_of(read(to_string(unit))), Texts{"order"});
}

TEST(System, SaysWhereOurFormatBreaks) {
    const Wrong cases[] = {
        {"variables x\nx + w\n", 2, 5},
        {"x + y\nx y\n", 2, 3},
        {"x, y\n", 1, 2},
        {"(x +\ny)\n", 1, 5},
        {"variables x\nvariables y\nx", 2, 1},
        {"x\nvariables x\n", 2, 1},
        {"variables\nx", 1, 10},
        {"variables x, x\nx", 1, 14},
        {"field GF(10)\nx", 1, 10},
        {"order foo\nx", 1, 7},
        {"variables x\norder elim(y)\nx", 2, 12},
        {"variables x,y\norder weight(1)\nx", 2, 7},
        {"field GF(5)\nx\nx/10", 3, 3},
        {"x = y = z", 1, 7},
        {"x\n\xff", 2, 1},
        {"\xEF\xBB\xBFx + )", 1, 5},
    };
    expect_errors(SystemFormat::eliminant, cases);
}

TEST(System, ReadsMsolvesFormat) {
    const System system = read("x,y\n1073741827\nx^2-1/2*y,\n y\n +1,x*y\n");
    EXPECT_EQ(system.ring.to_string(), "GF(1073741827)[x, y], degrevlex");
    EXPECT_EQ(texts_of(system), (Texts{"x^2+536870913*y", "y+1", "x*y"}));
    EXPECT_EQ(read("x\n0\nx^2-2", SystemFormat::msolve).ring.to_string(), "QQ[x], degrevlex");
    const Wrong cases[] = {
        {"x,y\n0\nx+y,\n", 4, 1}, {"x,y\n10\nx", 2, 1}, {"x,x\n0\nx", 1, 3}, {"x y\n0\nx", 1, 3},
        {"x,y\n0\nx;y", 3, 2},    {"x\n0\nx=1", 3, 2},  {"x\n0\n", 3, 1},    {"", 1, 1},
    };
    expect_errors(SystemFormat::msolve, cases);
}

TEST(System, ReadsSingularsFormat) {
    const System system = read("// from a paper\n"
                               "LIB \"general.lib\"; // with a comment\n"
                               "ring r = 32003,(x,y,z),(dp(1),wp(2,3));\n"
                               "option(redSB); short=0;\n"
                               "poly f = 3x2y - z3; /* two\n lines */ poly g = x*f;\n"
                               "ideal I = f, g + 1, -xyz;\n");
    EXPECT_EQ(system.ring.to_string(), "GF(32003)[x, y, z], matrix(1,0,0;0,2,3;0,0,-1)");
    EXPECT_EQ(texts_of(system), (Texts{"3*x^2*y+32002*z^3", "3*x^3*y+32002*x*z^3+1", "32002*x*y*z"}));
    EXPECT_EQ(texts_of(read("ring r=0,x,lp; poly f=x2-1; poly g=x3;")), (Texts{"x^2-1", "x^3"}));
}

// What Singular 4.3.1 prints for these.
TEST(System, MeansWhatSingularMeans) {
    const auto one = [](std::string_view text) {
        return to_string(
            read("ring r=0,(x,y,z),dp; poly f=" + std::string(text) + ";", SystemFormat::singular)
                .polynomials.front());
    };
    EXPECT_EQ(one("4/3x2y"), "4/3*x^2*y");
    EXPECT_EQ(one("2x^2"), "4*x^2");
    EXPECT_EQ(one("1/2x^2"), "1/4*x^2");
    EXPECT_EQ(one("x2^3"), "x^6");
    EXPECT_EQ(one("x2y^2"), "x^4*y^2");
    EXPECT_EQ(one("xy^2"), "x^2*y^2");
    EXPECT_EQ(one("x10y"), "x^10*y");
    EXPECT_EQ(one("3xx"), "3*x^2");
    EXPECT_EQ(one("5/3^2"), "25/9");
    EXPECT_EQ(one("x^2*2/4y"), "1/2*x^2*y");
    EXPECT_EQ(one("x*7/2"), "7/2*x");
    EXPECT_EQ(one("2*3x"), "6*x");
    EXPECT_EQ(one("-x^2"), "-x^2");
    EXPECT_EQ(one("x**2/2"), "1/2*x^2");
    const System names = read("ring r=0,(x,x2,xy),dp; ideal I=x2,x22,xy,2x2;");
    EXPECT_EQ(texts_of(names), (Texts{"x2", "x^22", "xy", "2*x2"}));
}

TEST(System, ReadsSingularsOrders) {
    const auto order = [](const std::string& text) {
        return read("ring r=0,(x,y,z)," + text + "; ideal I=x;").ring.order();
    };
    EXPECT_EQ(order("lp"), MonomialOrder::lex());
    EXPECT_EQ(order("Dp"), MonomialOrder::deglex());
    EXPECT_EQ(order("(dp,C)"), MonomialOrder::degrevlex());
    EXPECT_EQ(order("(c,dp(3))"), MonomialOrder::degrevlex());
    EXPECT_EQ(order("wp(1,2,3)"), MonomialOrder::weighted({1, 2, 3}, MonomialOrder::TieBreak::revlex));
    EXPECT_EQ(order("Wp(1,2,3)"), MonomialOrder::weighted({1, 2, 3}, MonomialOrder::TieBreak::lex));
    EXPECT_EQ(order("(dp(2),dp)"), MonomialOrder::elimination({0, 1}));
    EXPECT_EQ(order("(a(1,1),lp)"), MonomialOrder::matrix({{1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    EXPECT_EQ(order("(lp(1),Dp)"), MonomialOrder::matrix({{1, 0, 0}, {0, 1, 1}, {0, 1, 0}}));
    EXPECT_EQ(order("M(1,1,1,0,0,-1,0,-1,0)"), MonomialOrder::matrix({{1, 1, 1}, {0, 0, -1}, {0, -1, 0}}));
    EXPECT_EQ(read("ring r=QQ[x,y]; ideal I=x;").ring.to_string(), "QQ[x, y], degrevlex");
    EXPECT_EQ(read("ring r=ZZ/7,(x,y),lp; ideal I=x;").ring.to_string(), "GF(7)[x, y], lex");
}

TEST(System, SaysWhatOfSingularItDoesNotRead) {
    const Wrong cases[] = {
        {"ring r=0,(x,y),ds; ideal I=x;", 1, 16},
        {"ring r=(0,a),(x,y),dp; ideal I=x;", 1, 10},
        {"ring r=0,x(1..3),dp;", 1, 11},
        {"ring r=6,(x,y),dp;", 1, 8},
        {"ring r=0,(x,y),(dp(1));", 1, 16},
        {"ring r=0,(x,y),(dp(3));", 1, 17},
        {"ring r=0,(x,y),wp(0,1); ideal I=x;", 1, 1},
        {"ring r=0,(x,x),dp; ideal I=x;", 1, 1},
        {"ring r=0,(x,y),M(1,2,3); ideal I=x;", 1, 16},
        {"ring r=0,(x,y),dp; ideal I=x w;", 1, 30},
        {"ring r=0,(x,y),dp; ideal I=x,2 y;", 1, 32},
        {"ring r=0,(x,y),dp; ideal I=xw;", 1, 29},
        {"ring r=0,(x,y),dp; ideal I=3/(2);", 1, 29},
        {"ring r=0,(x,y),dp; ideal I=x/y;", 1, 30},
        {"ring r=0,(x,y),dp; ideal I=x2(y);", 1, 30},
        {"ring r=0,(x,y),dp; ideal I=x; ideal J=y;", 1, 31},
        {"ring r=0,(x,y),dp; ring s=0,x,dp;", 1, 20},
        {"ring r=0,(x,y),dp;\nstd(I);", 2, 1},
        {"ring r=0,(x,y),dp; ideal I=x", 1, 29},
        {"ring r=0,(x,y),dp; ideal I=x; /* open", 1, 31},
        {"LIB \"a", 1, 5},
        {"poly f=x;", 1, 8},
        {"ring r=0,(x,y),dp; poly x=y;", 1, 25},
        {"short=0;", 1, 9},
    };
    expect_errors(SystemFormat::singular, cases);
}

TEST(System, GuessesOnlyWhatIsCertain) {
    EXPECT_EQ(read("x,y\n0\nx-y").polynomials.size(), 1U);
    EXPECT_EQ(read("/* c */ ring r=0,x,dp; ideal i=x;").polynomials.size(), 1U);
    EXPECT_EQ(read("x\ny\n").polynomials.size(), 2U);
    EXPECT_EQ(read("x\n0+x\n").polynomials.size(), 2U);
    EXPECT_THROW(read("x\n0\nx^2-1\n"), ParseError); // three polynomials, or msolve's format
    EXPECT_EQ(read("variables x\nx\n0\nx^2-1\n").polynomials.size(), 3U);
}

TEST(System, LetsTheCallerOverride) {
    SystemOverrides overrides;
    overrides.field = CoefficientField::prime(7);
    overrides.order = "elim(y)";
    overrides.variables = Texts{"y", "x"};
    for (const char* text : {"variables x, y\nfield QQ\norder lex\nx-8*y", "x,y\n0\nx-8*y",
                             "ring r=0,(x,y),lp; ideal I=x-8y;"}) {
        const System system = read(text, SystemFormat::guess, overrides);
        EXPECT_EQ(system.ring.to_string(), "GF(7)[y, x], elim(y)");
        EXPECT_EQ(texts_of(system), Texts{"6*y+x"});
    }
    overrides.variables = Texts{"x"};
    overrides.order.reset();
    EXPECT_THROW(read("x-8*y", SystemFormat::guess, overrides), ParseError);
    overrides.order = "elim(w)";
    EXPECT_THROW(read("x", SystemFormat::guess, overrides), ParseError);
}

TEST(System, ReadsTextsOneByOne) {
    base::Run run;
    const std::vector<SourceText> texts = {{"x*t = 1", "argument 1"}, {"y - t", "argument 2"}};
    const System system = parse_system(texts, {}, run);
    EXPECT_EQ(system.ring.to_string(), "QQ[x, t, y], degrevlex");
    EXPECT_EQ(texts_of(system), (Texts{"x*t-1", "-t+y"}));
    const std::vector<SourceText> wrong = {{"x", "argument 1"}, {"y +", "argument 2"}};
    try {
        parse_system(wrong, {}, run);
        ADD_FAILURE() << "no error";
    } catch (const ParseError& error) {
        EXPECT_EQ(error.where().source, "argument 2");
        EXPECT_EQ(error.where().column, 4U);
    }
}

TEST(System, ReadsBackWhatItWrites) {
    std::mt19937_64 random(8);
    for (const Ring& ring : eliminant::testing::sample_rings()) {
        System system{ring, {}};
        for (int i = 0; i < 4; ++i)
            system.polynomials.push_back(
                eliminant::testing::random_polynomial(ring, random, random() % 6, 4));
        const System again = read(to_string(system), SystemFormat::eliminant);
        EXPECT_EQ(again.ring, ring);
        EXPECT_EQ(again.polynomials, system.polynomials) << to_string(system);
    }
}

} // namespace
