// Values, derivatives, their error bounds and signs, against exact evaluation.
#include "eliminant/field/compiled_polynomial.hpp"

#include "eliminant/algebra/calculus.hpp"
#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/algebra/parse.hpp"
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

} // namespace
} // namespace eliminant
