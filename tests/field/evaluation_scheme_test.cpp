// Which scheme is chosen, and that structured and centered ones compute the same polynomial within their
// bounds.
#include "eliminant/field/compiled_polynomial.hpp"

#include "eliminant/algebra/calculus.hpp"
#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/base/error.hpp"

#include "field/batch.hpp"
#include "field/surfaces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace eliminant {
namespace {

CompiledPolynomial formula(const std::string& text) {
    base::Run run;
    return CompiledPolynomial::of_formula(text, run);
}

std::array<double, 10> components(const Jet& jet) {
    const SymmetricMatrix& h = jet.hessian;
    return {jet.value, jet.gradient.x, jet.gradient.y, jet.gradient.z, h.xx, h.xy, h.xz, h.yy, h.yz, h.zz};
}

/// f and its nine derivatives, unscaled.
std::vector<Polynomial> with_derivatives(const Polynomial& f) {
    std::vector<Polynomial> result = {f};
    for (std::size_t i = 0; i < 3; ++i) result.push_back(derivative(f, i));
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i; j < 3; ++j) result.push_back(derivative(result[1 + i], j));
    return result;
}

double bound_for(const JetError& error, std::size_t component) {
    return component == 0 ? error.value : component < 4 ? error.gradient : error.hessian;
}

/// Jets one by one and in batches of doubles and floats, on every unit, at points of a box.
void expect_right(const std::string& name, const CompiledPolynomial& f, const glm::dvec3& lower,
                  const glm::dvec3& upper, std::mt19937_64& random) {
    constexpr std::size_t count = 19;
    const std::vector<Polynomial> exact = with_derivatives(f.polynomial());
    std::array<std::vector<double>, 3> in;
    std::array<std::vector<float>, 3> in_floats;
    std::array<std::vector<double>, 10> out;
    std::array<std::vector<float>, 10> out_floats;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < count; ++k) {
            const double t = std::uniform_real_distribution<double>(0, 1)(random);
            const auto axis = static_cast<int>(i);
            in_floats[i].push_back(static_cast<float>((1 - t) * lower[axis] + t * upper[axis]));
            in[i].push_back(in_floats[i].back());
        }
    for (auto& column : out) column.resize(count);
    for (auto& column : out_floats) column.resize(count);
    const double scale = std::ldexp(1.0, f.scale_exponent_float());
    for (const base::VectorUnit unit : base::available_vector_units()) {
        field::evaluate_with(unit, f, PointArrays<double>{in[0], in[1], in[2]},
                             JetArrays<double>{out[0],
                                               {out[1], out[2], out[3]},
                                               {out[4], out[5], out[6], out[7], out[8], out[9]}});
        field::evaluate_with(unit, f, PointArrays<float>{in_floats[0], in_floats[1], in_floats[2]},
                             JetArrays<float>{out_floats[0],
                                              {out_floats[1], out_floats[2], out_floats[3]},
                                              {out_floats[4], out_floats[5], out_floats[6], out_floats[7],
                                               out_floats[8], out_floats[9]}});
        for (std::size_t k = 0; k < count; ++k) {
            const glm::dvec3 p(in[0][k], in[1][k], in[2][k]);
            const mpq_class point[] = {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
            const std::array<double, 10> jet = components(f.jet(p));
            for (std::size_t c = 0; c < 10; ++c) {
                const mpq_class truth = evaluate(exact[c], point);
                const auto off = [&](double found) {
                    return mpq_class(abs(truth - mpq_class(found))).get_d();
                };
                ASSERT_LE(off(jet[c]), bound_for(f.close_error_bound(p), c)) << name << ' ' << c;
                ASSERT_LE(off(jet[c]), bound_for(f.error_bound(p), c)) << name << ' ' << c;
                ASSERT_LE(off(out[c][k]), bound_for(f.close_error_bound(p), c))
                    << name << ' ' << c << ' ' << base::name(unit);
                ASSERT_LE(off(out_floats[c][k] * scale), bound_for(f.error_bound_float(p), c) * scale)
                    << name << ' ' << c << ' ' << base::name(unit);
            }
            ASSERT_LE(std::abs(f.value(p) - jet[0]), 2 * f.error_bound(p).value);
            ASSERT_EQ(f.sign(p), sgn(evaluate(exact[0], point))) << name;
        }
    }
}

TEST(EvaluationScheme, structure_is_kept_where_it_saves_operations) {
    // 286 terms expanded.
    const CompiledPolynomial power = formula("(x^2+2*y^2+3*z^2+x*y-1)^10 = 0");
    ASSERT_EQ(power.schemes().size(), 2U);
    EXPECT_EQ(power.schemes()[0].kind, SchemeKind::structured);
    EXPECT_LT(power.schemes()[0].operations * 4, power.schemes()[1].operations);
    EXPECT_EQ(power.schemes()[0].description, "(5 terms)^10");
    EXPECT_EQ(power.polynomial(), test::polynomial("(x^2+2*y^2+3*z^2+x*y-1)^10"));
    // The same is found in the expanded polynomial, and factors free of a coordinate are.
    const CompiledPolynomial found(power.polynomial());
    EXPECT_EQ(found.schemes()[0].kind, SchemeKind::structured);
    const CompiledPolynomial product(test::polynomial("(x^3+y^2*x+y+7)^4*(z^4+x^2*z-3)^3*x^2*5/7"));
    EXPECT_EQ(product.schemes()[0].kind, SchemeKind::structured);
    // A sum of few powers is best expanded.
    const CompiledPolynomial sphere = formula("(x-1)^2+(y+2)^2+z^2-1");
    EXPECT_EQ(sphere.schemes()[0].kind, SchemeKind::horner);
    EXPECT_EQ(sphere.polynomial(), test::polynomial("(x-1)^2+(y+2)^2+z^2-1"));
}

TEST(EvaluationScheme, the_first_has_the_least_expected_cost) {
    base::Run run;
    for (const test::Surface& surface : test::surfaces()) {
        const field::Box box{glm::dvec3(0.25), glm::dvec3(0.75)};
        for (const CompiledPolynomial& f :
             {CompiledPolynomial(surface.polynomial), CompiledPolynomial(surface.polynomial, box, run)}) {
            ASSERT_FALSE(f.schemes().empty());
            for (const EvaluationScheme& scheme : f.schemes()) {
                EXPECT_GE(scheme.expected_cost(), f.schemes()[0].expected_cost()) << surface.name;
                EXPECT_GT(scheme.operations, 0);
                EXPECT_GE(scheme.uncertainty, 0);
                EXPECT_LE(scheme.uncertainty, 1);
                EXPECT_FALSE(scheme.description.empty());
            }
        }
    }
}

TEST(EvaluationScheme, an_expansion_at_the_center_of_a_box_saves_digits) {
    base::Run run;
    // Near (1000, 0, 0) the expanded form loses 18 digits.
    const Polynomial f = test::polynomial("((x-1000)^2+y^2+z^2)^3-x*y*z/1000");
    const field::Box box{{999, -1, -1}, {1001, 1, 1}};
    const CompiledPolynomial global(f);
    const CompiledPolynomial local(f, box, run);
    EXPECT_EQ(local.schemes()[0].kind, SchemeKind::taylor);
    const glm::dvec3 p(1000.25, 0.5, -0.25);
    EXPECT_LT(local.error_bound(p).value * 1e6, global.error_bound(p).value);
    std::mt19937_64 random(2);
    expect_right("local", local, box.lower, box.upper, random);
    EXPECT_THROW(CompiledPolynomial(f, field::Box{{1, 0, 0}, {0, 1, 1}}, run), DomainError);
    EXPECT_THROW(CompiledPolynomial(f, field::Box{{0, 0, 0}, {0, 1, INFINITY}}, run), DomainError);
}

TEST(EvaluationScheme, every_scheme_is_within_its_bounds) {
    std::mt19937_64 random(3);
    base::Run run;
    for (const char* text :
         {"(x^2+2*y^2+3*z^2+x*y-1)^10", "(x^3+y^2*x+y+7)^4*(z^4+x^2*z-3)^3*x^2*5/7",
          "-3*(x+y+z-1)^7*(x*y-z)^5 + 2*(x^2+y^2+z^2-1)^9 - (x-y)^11/7 + x - 1/3",
          "((x^2+y^2-1)^4+(y^2+z^2-1)^4)^2*((x-1)^2+z^4)^3 = 4*(x+y)^8*(x-y)^8*(z-1)^3 + 1",
          "-(-(x^2+y*z+1)^6)^3"}) {
        const CompiledPolynomial f = formula(text);
        EXPECT_EQ(f.schemes()[0].kind, SchemeKind::structured) << text;
        expect_right(text, f, glm::dvec3(-1.5), glm::dvec3(1.5), random);
    }
    for (const test::Surface& surface : test::surfaces()) {
        if (surface.polynomial.size() > 1000) continue;
        expect_right(surface.name,
                     CompiledPolynomial(surface.polynomial, field::Box{glm::dvec3(0.5), glm::dvec3(1)}, run),
                     glm::dvec3(0.5), glm::dvec3(1), random);
    }
}

TEST(EvaluationScheme, texts_denote_what_the_parser_says) {
    std::mt19937_64 random(4);
    // Random formulas, printed as they are built.
    for (int repeat = 0; repeat < 100; ++repeat) {
        std::vector<std::string> stack;
        const char* atoms[] = {"x", "y", "z", "2", "1/3", "(x-y)", "(x*z+1)", "(-y^2)"};
        for (int i = 0; i < 12; ++i) {
            const auto kind = random() % 4;
            if (stack.size() < 2 || kind == 0) {
                stack.emplace_back(atoms[random() % 8]);
                continue;
            }
            const std::string b = stack.back();
            stack.pop_back();
            std::string& a = stack.back();
            if (kind == 1)
                a = std::string("(").append(a).append(random() % 2 == 0 ? "+" : "-").append(b) + ")";
            if (kind == 2) a = std::string("(").append(a).append(")*(").append(b) + ")";
            if (kind == 3) a = std::string("-(").append(a).append(")^3-").append(b);
        }
        if (stack.back().size() > 120) continue;
        const CompiledPolynomial f = formula(stack.back());
        ASSERT_EQ(f.polynomial(), test::polynomial(stack.back())) << stack.back();
        ASSERT_NO_FATAL_FAILURE(expect_right(stack.back(), f, glm::dvec3(-1), glm::dvec3(1), random));
    }
    EXPECT_EQ(formula("x/(y-y+2)").polynomial(), test::polynomial("x/2"));
    EXPECT_EQ(formula("0*(x+y)^9+(x-x)^3").degree(), -1);
    EXPECT_EQ(formula("(x+y)^0*z").polynomial(), test::polynomial("z"));
    EXPECT_THROW(formula("(x+y"), ParseError);
    EXPECT_THROW(formula("w^2"), ParseError);
    EXPECT_THROW(formula("sin(x)"), ParseError);
}

TEST(EvaluationScheme, parts_that_would_overflow_are_expanded) {
    const std::string huge = "1" + std::string(30, '0');
    const CompiledPolynomial f = formula("(" + huge + "*x^2+y)^5*(x/" + huge + "+z/" + huge + ")^5-1");
    EXPECT_EQ(f.schemes()[0].kind, SchemeKind::horner);
    const CompiledPolynomial power = formula("(x^2+y^2+z^2+x*y-1)^9");
    ASSERT_EQ(power.schemes()[0].kind, SchemeKind::structured);
    EXPECT_EQ(power.error_bound({1e200, 0, 0}).value, INFINITY);
    EXPECT_EQ(power.sign({1e200, 0, 0}), 1);
    EXPECT_EQ(power.error_bound_float({1e30, 0, 0}).value, INFINITY);
}

} // namespace
} // namespace eliminant
