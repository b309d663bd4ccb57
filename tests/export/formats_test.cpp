#include "eliminant/export/formats.hpp"

#include "eliminant/algebra/parse.hpp"
#include "eliminant/algebra/print.hpp"
#include "eliminant/algebra/system.hpp"

#include "support/random_polynomials.hpp"

#include <gtest/gtest.h>

using namespace eliminant;

namespace {

const Ring rational_ring(CoefficientField::rationals(), {"x", "y", "z"});

Polynomial read(const Ring& ring, std::string_view text) { return parse_polynomial(ring, text); }

TEST(Formats, WritesFormulasInLatex) {
    const auto latex = [](const Ring& ring, std::string_view text) {
        return formula(read(ring, text), Format::latex);
    };
    EXPECT_EQ(latex(rational_ring, "x^2-3/4*x*y^10-z+1"), "-\\frac{3}{4} x y^{10}+x^{2}-z+1");
    EXPECT_EQ(latex(rational_ring, "-1"), "-1");
    EXPECT_EQ(latex(rational_ring, "0"), "0");
    EXPECT_EQ(latex(rational_ring, "-x-1/2"), "-x-\\frac{1}{2}");
    const Ring names(CoefficientField::rationals(), {"x1", "x_2", "alpha", "mu_12", "speed", "a_max", "b_i"});
    EXPECT_EQ(latex(names, "x1+x_2+alpha+mu_12+speed+a_max+b_i"),
              "x_{1}+x_{2}+\\alpha+\\mu_{12}+\\mathrm{speed}+a_{\\mathrm{max}}+b_{i}");
    const Ring alike(CoefficientField::rationals(), {"x1", "x_1"});
    EXPECT_EQ(latex(alike, "x1*x_1"), "\\mathtt{x1} \\mathtt{x\\_1}");
    EXPECT_EQ(declared(read(rational_ring, "x"), Format::latex), "\\[ x \\]\n");
    EXPECT_EQ(declared(rational_ring, std::vector{read(rational_ring, "x"), read(rational_ring, "2y")},
                       Format::latex),
              "\\begin{align*}\n  & x \\\\\n  & 2 y\n\\end{align*}\n");
}

TEST(Formats, WritesPolynomialsThatCanBePasted) {
    const Polynomial f = read(rational_ring, "x^2-1/2*y");
    EXPECT_EQ(declared(f, Format::text), "x^2-1/2*y\n");
    EXPECT_EQ(declared(f, Format::singular), "ring r = 0,(x,y,z),dp;\npoly f = x^2-1/2*y;\n");
    EXPECT_EQ(declared(f, Format::macaulay2),
              "R = QQ[x,y,z, MonomialOrder => GRevLex];\nf = sub(x^2-1/2*y,R);\n");
    EXPECT_EQ(declared(f, Format::sage),
              "R.<x,y,z> = PolynomialRing(QQ, order='degrevlex')\nf = R(x^2-1/2*y)\n");
    EXPECT_EQ(declared(f, Format::maple), "f := x^2-1/2*y;\n");
}

TEST(Formats, WritesIdealsThatCanBePasted) {
    const Ring ring(CoefficientField::prime(101), {"x", "y", "z"}, MonomialOrder::elimination({0}));
    const std::vector<Polynomial> generators = {read(ring, "x*y-1"), read(ring, "-z")};
    EXPECT_EQ(declared(ring, generators, Format::text), "x*y+100\n100*z\n");
    EXPECT_EQ(declared(ring, generators, Format::singular),
              "ring r = 101,(x,y,z),(dp(1),dp(2));\nideal I =\n  x*y+100,\n  100*z;\n");
    EXPECT_EQ(declared(ring, generators, Format::macaulay2),
              "R = ZZ/101[x,y,z, MonomialOrder => {GRevLex=>1,GRevLex=>2}];\n"
              "I = sub(ideal(\n  x*y+100,\n  100*z), R);\n");
    EXPECT_EQ(declared(ring, generators, Format::sage),
              "R.<x,y,z> = PolynomialRing(GF(101), order=TermOrder('degrevlex',1)+TermOrder('degrevlex',2))\n"
              "I = R.ideal([\n  x*y+100,\n  100*z])\n");
    EXPECT_EQ(declared(ring, generators, Format::maple),
              "# over GF(p): give the commands characteristic=101\n"
              "F := [\n  x*y+100,\n  100*z]:\nT := lexdeg([x],[y,z]):\n");
    EXPECT_THROW(declared(rational_ring, generators, Format::sage), RingMismatchError);
}

TEST(Formats, ReplacesNamesThatMeanSomethingElse) {
    const Ring ring(CoefficientField::rationals(), {"lambda", "I", "x_1", "x1", "f"}, MonomialOrder::lex());
    const Polynomial f = read(ring, "lambda+I+x_1*x1-f");
    EXPECT_EQ(formula(f, Format::text), "lambda+I+x_1*x1-f");
    EXPECT_EQ(formula(f, Format::sage), "lambdav+Iv+x_1*x1-fv");
    EXPECT_EQ(formula(f, Format::macaulay2), "lambda+Iv+x1v*x1-fv");
    EXPECT_EQ(formula(f, Format::maple), "lambda+Iv+x_1*x1-fv");
    EXPECT_EQ(declared(f, Format::singular), "// Iv stands for I\n// fv stands for f\n"
                                             "ring r = 0,(lambda,Iv,x_1,x1,fv),lp;\n"
                                             "poly f = lambda+Iv+x_1*x1-fv;\n");
}

TEST(Formats, WritesEveryOrder) {
    const auto order_in = [](MonomialOrder order, Format format) {
        const Ring ring(CoefficientField::rationals(), {"x", "y", "z"}, std::move(order));
        const std::string text = declared(ring, {}, format);
        const std::string line = text.substr(0, text.find('\n'));
        return format == Format::maple
                   ? text.substr(text.find("T := ") + 5, text.size() - text.find("T := ") - 7)
                   : line.substr(line.find(format == Format::singular ? "z)," : "rder") + 3);
    };
    EXPECT_EQ(order_in(MonomialOrder::deglex(), Format::singular), "Dp;");
    EXPECT_EQ(order_in(MonomialOrder::weighted({1, 2, 3}, MonomialOrder::TieBreak::revlex), Format::singular),
              "wp(1,2,3);");
    EXPECT_EQ(order_in(MonomialOrder::weighted({1, 0, 3}, MonomialOrder::TieBreak::lex), Format::singular),
              "(a(1,0,3),lp);");
    EXPECT_EQ(order_in(MonomialOrder::elimination({1}), Format::singular), "M(0,1,0,1,0,1,0,0,-1);");
    EXPECT_EQ(order_in(MonomialOrder::lex(), Format::maple), "plex(x,y,z)");
    EXPECT_EQ(order_in(MonomialOrder::elimination({1}), Format::maple),
              "'matrix'([[0,1,0],[1,0,1],[0,0,-1]],[x,y,z])");
    EXPECT_NE(
        order_in(MonomialOrder::elimination({1}), Format::sage).find("matrix(3,3,[0,1,0,1,0,1,0,0,-1])"),
        std::string::npos);
    EXPECT_NE(order_in(MonomialOrder::weighted({1, 2, 3}, MonomialOrder::TieBreak::lex), Format::macaulay2)
                  .find("{Weights=>{1,2,3},Lex}"),
              std::string::npos);
}

TEST(Formats, CanBeStopped) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    const std::vector<Polynomial> generators = {Polynomial::variable(ring, 0)};
    EXPECT_EQ(declared(ring, generators, Format::singular, run),
              declared(ring, generators, Format::singular));
    run.request_stop();
    EXPECT_THROW(static_cast<void>(formula(generators[0], Format::latex, run)), Stopped);
    EXPECT_THROW(static_cast<void>(declared(generators[0], Format::sage, run)), Stopped);
    EXPECT_THROW(static_cast<void>(declared(ring, generators, Format::singular, run)), Stopped);
}

TEST(Formats, SingularTextReadsBack) {
    std::mt19937_64 random(9);
    base::Run run;
    for (const Ring& ring : eliminant::testing::sample_rings()) {
        std::vector<Polynomial> generators;
        for (int i = 0; i < 3; ++i)
            generators.push_back(eliminant::testing::random_polynomial(ring, random, 5, 4));
        const std::string text = declared(ring, generators, Format::singular);
        const System system = parse_system(text, SystemFormat::guess, {}, run);
        ASSERT_EQ(system.polynomials.size(), 3U) << text;
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(system.polynomials[i].in_ring(ring), generators[i]) << text;
            // Written in another way, it is still the same order.
            for (std::size_t k = 0; k < generators[i].size(); ++k)
                EXPECT_EQ(system.polynomials[i].monomial(k).exponents(),
                          generators[i].monomial(k).exponents())
                    << text;
        }
    }
}

} // namespace
