// Values, derivatives, their error bounds and signs, against exact evaluation.
#include "eliminant/field/compiled_polynomial.hpp"

#include "eliminant/algebra/calculus.hpp"
#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/algebra/parse.hpp"
#include "eliminant/algebra/print.hpp"
#include "eliminant/base/error.hpp"

#include "field/batch.hpp"
#include "field/surfaces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace eliminant {
namespace {

mpq_class exact_value(const Polynomial& f, const glm::dvec3& p) {
    const mpq_class point[] = {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
    return evaluate(f, point);
}

/// f and its nine derivatives in the order of Jet, times 2^-scale.
std::vector<Polynomial> with_derivatives(const CompiledPolynomial& compiled) {
    mpq_class factor = 1;
    const int e = compiled.scale_exponent();
    if (e > 0) mpq_div_2exp(factor.get_mpq_t(), factor.get_mpq_t(), static_cast<mp_bitcnt_t>(e));
    if (e < 0) mpq_mul_2exp(factor.get_mpq_t(), factor.get_mpq_t(), static_cast<mp_bitcnt_t>(-e));
    const Polynomial f = compiled.polynomial().scaled(factor);
    std::vector<Polynomial> result = {f};
    for (std::size_t i = 0; i < 3; ++i) result.push_back(derivative(f, i));
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i; j < 3; ++j) result.push_back(derivative(result[1 + i], j));
    return result;
}

std::array<double, 10> components(const Jet& jet) {
    const SymmetricMatrix& h = jet.hessian;
    return {jet.value, jet.gradient.x, jet.gradient.y, jet.gradient.z, h.xx, h.xy, h.xz, h.yy, h.yz, h.zz};
}

/// Points at random, with many coordinates 0, small or large.
glm::dvec3 random_point(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    glm::dvec3 p(normal(random), normal(random), normal(random));
    for (int i = 0; i < 3; ++i) {
        const auto kind = random() % 8;
        if (kind == 0) p[i] = 0;
        if (kind == 1) p[i] *= 1e-9;
        if (kind == 2) p[i] *= 50;
    }
    return p;
}

double bound_for(const JetError& error, std::size_t component) {
    return component == 0 ? error.value : component < 4 ? error.gradient : error.hessian;
}

void expect_within_bounds(const std::string& name, const CompiledPolynomial& f, const glm::dvec3& p,
                          const std::vector<Polynomial>& exact, const std::array<double, 10>& found) {
    const JetError fast = f.error_bound(p);
    const JetError close = f.close_error_bound(p);
    for (std::size_t i = 0; i < 10; ++i) {
        const mpq_class error = abs(exact_value(exact[i], p) - mpq_class(found[i]));
        EXPECT_LE(error, mpq_class(bound_for(close, i)))
            << name << " component " << i << " at " << p.x << ' ' << p.y << ' ' << p.z;
        EXPECT_LE(error, mpq_class(bound_for(fast, i)))
            << name << " component " << i << " at " << p.x << ' ' << p.y << ' ' << p.z;
    }
    EXPECT_LE(close.value, fast.value * (1 + 1e-9));
}

TEST(CompiledPolynomial, jet_is_within_its_bounds) {
    std::mt19937_64 random(20240901);
    for (const test::Surface& surface : test::surfaces()) {
        const CompiledPolynomial f(surface.polynomial);
        const std::vector<Polynomial> exact = with_derivatives(f);
        const int points = surface.polynomial.size() > 1000 ? 5 : 100;
        for (int i = 0; i < points; ++i) {
            const glm::dvec3 p = random_point(random);
            expect_within_bounds(surface.name, f, p, exact, components(f.jet(p)));
            EXPECT_LE(abs(exact_value(exact[0], p) - mpq_class(f.value(p))),
                      mpq_class(f.close_error_bound(p).value));
        }
    }
}

/// Columns of a batch.
template <class Real>
struct Columns {
    std::array<std::vector<Real>, 3> in;
    std::array<std::vector<Real>, 10> out;
    explicit Columns(std::size_t count) {
        for (auto& column : in) column.resize(count);
        for (auto& column : out) column.resize(count, Real(12345));
    }
    PointArrays<Real> points() const { return {in[0], in[1], in[2]}; }
    JetArrays<Real> jets() {
        return {out[0], {out[1], out[2], out[3]}, {out[4], out[5], out[6], out[7], out[8], out[9]}};
    }
    std::array<Real, 10> jet(std::size_t i) const {
        std::array<Real, 10> result;
        for (std::size_t k = 0; k < 10; ++k) result[k] = out[k][i];
        return result;
    }
};

TEST(CompiledPolynomial, batches_agree_with_the_bounds_on_every_unit_and_for_every_length) {
    std::mt19937_64 random(5);
    for (const test::Surface& surface : test::surfaces()) {
        const CompiledPolynomial f(surface.polynomial);
        const bool is_large = surface.polynomial.size() > 1000;
        const std::vector<Polynomial> exact = with_derivatives(f);
        for (const base::VectorUnit unit : base::available_vector_units())
            for (const std::size_t count : {0UL, 1UL, 7UL, 8UL, 9UL, 33UL}) {
                if (is_large && count > 1) continue;
                Columns<double> columns(count);
                std::vector<glm::dvec3> points;
                for (std::size_t i = 0; i < count; ++i) {
                    points.push_back(random_point(random));
                    for (int k = 0; k < 3; ++k) columns.in[static_cast<std::size_t>(k)][i] = points[i][k];
                }
                field::evaluate_with(unit, f, columns.points(), columns.jets());
                for (std::size_t i = 0; i < count; ++i)
                    expect_within_bounds(surface.name + " " + std::string(name(unit)), f, points[i], exact,
                                         columns.jet(i));
            }
    }
}

TEST(CompiledPolynomial, batches_of_floats_are_doubles_rounded_more) {
    std::mt19937_64 random(6);
    std::uniform_real_distribution<float> coordinate(-1, 1);
    for (const test::Surface& surface : test::surfaces()) {
        const CompiledPolynomial f(surface.polynomial);
        const double scale = std::ldexp(1.0, f.scale_exponent_float() - f.scale_exponent());
        for (const base::VectorUnit unit : base::available_vector_units()) {
            Columns<float> columns(37);
            for (auto& column : columns.in)
                for (float& x : column) x = coordinate(random);
            field::evaluate_with(unit, f, columns.points(), columns.jets());
            for (std::size_t i = 0; i < 37; ++i) {
                const glm::dvec3 p(columns.in[0][i], columns.in[1][i], columns.in[2][i]);
                const std::array<double, 10> jet = components(f.jet(p));
                const JetError error = f.error_bound(p);
                for (std::size_t k = 0; k < 10; ++k) // the same number of roundings, each 2^29 times as large
                    EXPECT_NEAR(columns.out[k][i] * scale, jet[k], bound_for(error, k) * 0x1.1p29)
                        << surface.name << ' ' << name(unit) << ' ' << k;
            }
        }
    }
}

TEST(CompiledPolynomial, jet_of_random_sparse_polynomials) {
    std::mt19937_64 random(99);
    for (int repeat = 0; repeat < 300; ++repeat) {
        // Exponents that are multiples of 1, 2 or 3, so that powers of coordinates occur.
        PolynomialBuilder builder(test::xyz());
        const std::uint64_t steps[] = {1 + random() % 3, 1 + random() % 3, 1 + random() % 3};
        for (auto terms = random() % 8; terms-- > 0;) {
            const std::uint64_t exponents[] = {steps[0] * (random() % 4), steps[1] * (random() % 3),
                                               steps[2] * (random() % 4)};
            builder.add(Integer(static_cast<std::int64_t>(random() % 19) - 9), Integer(1 + random() % 7),
                        exponents);
        }
        const CompiledPolynomial f(builder.build());
        const std::vector<Polynomial> exact = with_derivatives(f);
        const glm::dvec3 p = random_point(random);
        expect_within_bounds(to_string(f.polynomial()), f, p, exact, components(f.jet(p)));
    }
}

TEST(CompiledPolynomial, sign_is_exact) {
    std::mt19937_64 random(17);
    const CompiledPolynomial sphere(test::polynomial("x^2+y^2+z^2-1"));
    EXPECT_EQ(sphere.sign({1, 0, 0}), 0);
    EXPECT_EQ(sphere.sign({std::nextafter(1.0, 2.0), 0, 0}), 1);
    EXPECT_EQ(sphere.sign({1, 1e-200, 0}), 1); // 1e-400 off: only rationals can tell
    EXPECT_EQ(sphere.sign({1e200, 1, 1}), 1);
    EXPECT_EQ(CompiledPolynomial(test::polynomial("x^3-y^3")).sign({1e-110, 2e-110, 0}), -1);
    EXPECT_EQ(CompiledPolynomial(test::polynomial("0")).sign({1, 2, 3}), 0);
    for (const test::Surface& surface : test::surfaces()) {
        const CompiledPolynomial f(surface.polynomial);
        const int points = surface.polynomial.size() > 1000 ? 10 : 100;
        for (int i = 0; i < points; ++i) {
            // Toward the surface by Newton's iteration, until doubles see nothing but noise.
            glm::dvec3 p = random_point(random);
            for (int k = 0; k < 30; ++k) {
                const Jet jet = f.jet(p);
                const double square = glm::dot(jet.gradient, jet.gradient);
                if (!(square > 0) || !std::isfinite(square)) break;
                p -= (jet.value / square) * jet.gradient;
            }
            if (!(glm::length(p) < 1e6)) continue;
            const mpq_class exact = exact_value(surface.polynomial, p);
            EXPECT_EQ(f.sign(p), sgn(exact)) << surface.name;
            const Approximation value = f.reliable_value(p);
            EXPECT_LE(value.error, 0x1p-30 * std::abs(value.value));
            EXPECT_LE(abs(exact_value(with_derivatives(f)[0], p) - mpq_class(value.value)),
                      mpq_class(value.error));
        }
    }
}

TEST(CompiledPolynomial, region_is_substituted_exactly) {
    base::Run run;
    const Region region{{mpq_class(1, 3), mpq_class(-2, 7), mpq_class(5)}, mpq_class(1, 9)};
    const CompiledPolynomial f(test::surface("klein"), region, run);
    const mpq_class q[] = {mpq_class(2, 5), mpq_class(-1, 3), mpq_class(1, 8)};
    mpq_class p[3];
    for (std::size_t i = 0; i < 3; ++i) p[i] = region.center[i] + region.scale * q[i];
    EXPECT_EQ(evaluate(f.polynomial(), q), evaluate(test::surface("klein"), p));
    EXPECT_THROW(CompiledPolynomial(test::surface("klein"), Region{{0, 0, 0}, 0}, run), DomainError);
}

TEST(CompiledPolynomial, extreme_coefficients_are_scaled) {
    const std::string huge = "1" + std::string(400, '0');
    const CompiledPolynomial f(test::polynomial(huge + "*x^2-" + huge + "*y+1/" + huge));
    EXPECT_NE(f.scale_exponent(), 0);
    EXPECT_NEAR(f.value({1, 0, 0}) / f.value({2, 0, 0}), 0.25, 1e-15);
    EXPECT_EQ(f.sign({0, 0, 0}), 1);
    EXPECT_EQ(f.sign({3, 9, 0}), 1);
    EXPECT_EQ(CompiledPolynomial(test::polynomial("3x^2-7")).scale_exponent(), 0);
}

TEST(CompiledPolynomial, two_variables_need_no_z) {
    const Ring plane(CoefficientField::rationals(), {"s", "t"});
    const CompiledPolynomial f(parse_polynomial(plane, {"s^2*t-3t+1", "test"}));
    std::vector<double> s{2, 0}, t{5, 1};
    Columns<double> columns(2);
    f.evaluate(PointArrays<double>{s, t, {}}, columns.jets());
    EXPECT_EQ(columns.jet(0), (std::array<double, 10>{6, 20, 1, 0, 10, 4, 0, 0, 0, 0}));
    EXPECT_EQ(columns.jet(1), (std::array<double, 10>{-2, 0, -3, 0, 2, 0, 0, 0, 0, 0}));
}

TEST(CompiledPolynomial, what_it_refuses) {
    const auto compile = [](const Ring& ring, const char* text) {
        return CompiledPolynomial(parse_polynomial(ring, {text, "test"}));
    };
    EXPECT_THROW(compile(Ring(CoefficientField::prime(101), {"x", "y", "z"}), "x+1"), DomainError);
    const Ring with_constant(CoefficientField::rationals(), {"x", "y", "z", "r"});
    EXPECT_THROW(compile(with_constant, "x-r"), DomainError);
    EXPECT_EQ(compile(with_constant, "x-1").sign({2, 0, 0}), 1);
    EXPECT_THROW(compile(test::xyz(), "x^1001"), OverflowError);
    EXPECT_EQ(compile(test::xyz(), "x^1000-y").sign({0.5, 0, 0}), 1);
    const CompiledPolynomial f = compile(test::xyz(), "x*z");
    Columns<double> columns(4);
    PointArrays<double> short_points = columns.points();
    short_points.y = short_points.y.first(3);
    EXPECT_THROW(f.evaluate(short_points, columns.jets()), DomainError);
    EXPECT_THROW(f.evaluate(PointArrays<double>{columns.in[0], columns.in[1], {}}, columns.jets()),
                 DomainError);
    EXPECT_THROW(f.sign({std::nan(""), 0, 0}), DomainError);
    EXPECT_EQ(f.error_bound({INFINITY, 0, 0}).value, INFINITY);
}

} // namespace
} // namespace eliminant
