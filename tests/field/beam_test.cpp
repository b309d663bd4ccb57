// Polynomials on beams of rays: the exact ones against substitution, the rounded ones within their own
// bounds.
#include "field/beam.hpp"

#include "field/beam_rows.hpp"
#include "field/exact_beam.hpp"
#include "field/surfaces.hpp"

#include "eliminant/algebra/evaluation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

namespace eliminant::field {
namespace {

mpq_class value(const LinearForm& form, const mpq_class& u, const mpq_class& v, const mpq_class& w) {
    return form.constant + form.u * u + form.v * v + form.w * w;
}

mpq_class power(const mpq_class& base, std::size_t exponent) {
    mpq_class result = 1;
    for (std::size_t i = 0; i < exponent; ++i) result *= base;
    return result;
}

/// The homogenised f at the forms, from its definition.
mpq_class definition(const algebra::Polynomial& f, const BeamForms& forms, const mpq_class& u,
                     const mpq_class& v, const mpq_class& w) {
    const mpq_class t = value(forms[3], u, v, w);
    const std::array<mpq_class, 3> point{value(forms[0], u, v, w) / t, value(forms[1], u, v, w) / t,
                                         value(forms[2], u, v, w) / t};
    return evaluate(f, point) * power(t, static_cast<std::size_t>(f.total_degree()));
}

mpq_class value(const ExactBeam& beam, const mpq_class& u, const mpq_class& v, const mpq_class& w) {
    const BeamLayout& layout = beam.layout();
    const std::size_t n = layout.degree();
    mpq_class sum = 0;
    for (std::size_t k = 0; k <= n; ++k)
        for (std::size_t b = 0; b <= layout.rows(k, n); ++b)
            for (std::size_t a = 0; a <= layout.columns(k, b, n); ++a)
                sum += beam.coefficients()[layout.start(k, b) + a] * power(u, a) * power(v, b) * power(w, k);
    return sum;
}

class Beams : public testing::Test {
  protected:
    static constexpr unsigned seed = 17;
    /// Within [−1, 1].
    mpq_class number() { return mpq_class(static_cast<double>(random_() % 65) / 32.0 - 1.0); }
    /// A pencil: t = −w varies, positive on w ∈ [−1, 1].
    BeamForms pencil() {
        BeamForms forms;
        for (std::size_t i = 0; i < 3; ++i) forms[i] = {number() * 3, number() / 4, number() / 4, number()};
        forms[3] = {mpq_class(3, 2), 0, 0, mpq_class(-1, 2)};
        return forms;
    }
    std::mt19937_64 random_{seed};
};

TEST_F(Beams, ExactOnesAreSubstitution) {
    base::Run run;
    for (const char* text : {"x^2+y^2+z^2-1", "x*y*z-2*x+5", "3*z^5-x^2*y+1/7*y", "-4", "x-y"}) {
        const algebra::Polynomial f = test::polynomial(text);
        const BeamForms forms = pencil();
        const ExactBeam beam(f, forms, run);
        const mpq_class u0 = number();
        const mpq_class ratio = value(beam, u0, u0, u0) / definition(f, forms, u0, u0, u0);
        EXPECT_GT(ratio, 0) << text;
        for (int i = 0; i < 5; ++i) {
            const mpq_class u = number();
            const mpq_class v = number();
            const mpq_class w = number();
            EXPECT_EQ(value(beam, u, v, w), ratio * definition(f, forms, u, v, w)) << text;
            // The ray (u, v): the same values up to a positive factor.
            const auto on_ray = beam.on_ray(u, v);
            mpq_class sum = 0;
            for (std::size_t k = 0; k < on_ray.size(); ++k) sum += on_ray[k] * power(w, k);
            EXPECT_EQ(sgn(sum), sgn(value(beam, u, v, w))) << text;
        }
    }
}

/// Absolute coefficients in powers of u, v and w of the exact beam, brought to part of the box.
std::vector<mpq_class> exact_part(const ExactBeam& beam, const mpq_class& scale, std::array<Span, 3> spans) {
    const BeamLayout& layout = beam.layout();
    const std::size_t n = layout.degree();
    std::vector<mpq_class> p;
    for (const mpz_class& c : beam.coefficients()) p.emplace_back(c / scale);
    const auto change = [&p](std::size_t m, const Span& span, const auto& index) {
        for (std::size_t i = 0; i < m; ++i)
            for (std::size_t j = m; j-- > i;) p[index(j)] += p[index(j + 1)] * mpq_class(span.center);
        for (std::size_t i = 0; i <= m; ++i) p[index(i)] *= power(mpq_class(span.radius), i);
    };
    for (std::size_t k = 0; k <= n; ++k)
        for (std::size_t b = 0; b + k <= n; ++b)
            change(n - k - b, spans[0], [&](std::size_t a) { return layout.start(k, b) + a; });
    for (std::size_t k = 0; k <= n; ++k)
        for (std::size_t a = 0; a + k <= n; ++a)
            change(n - k - a, spans[1], [&](std::size_t b) { return layout.start(k, b) + a; });
    for (std::size_t b = 0; b <= n; ++b)
        for (std::size_t a = 0; a + b <= n; ++a)
            change(n - a - b, spans[2], [&](std::size_t k) { return layout.start(k, b) + a; });
    return p;
}

TEST_F(Beams, RoundedOnesStayWithinTheirBounds) {
    base::Run run;
    for (const char* name : {"sphere", "barth6", "endrass8", "bicubic18"}) {
        const ExactBeam exact(test::surface(name), pencil(), run);
        const WideBeam wide(exact);
        std::size_t bits = 0;
        for (const mpz_class& c : exact.coefficients())
            bits = std::max(bits, mpz_sizeinbase(c.get_mpz_t(), 2));
        mpq_class scale = 1;
        mpz_mul_2exp(scale.get_num_mpz_t(), scale.get_num_mpz_t(), bits);
        for (int round = 0; round < 3; ++round) {
            const double part = round == 0 ? 0.5 : 0.03125;
            std::array<Span, 3> spans;
            for (Span& span : spans) span = {mpq_class(number() * mpq_class(1.0 - part)).get_d(), part};
            const Beam beam = wide.part(spans[0], spans[1]).slab(spans[2]);
            const auto truth = exact_part(exact, scale, spans);
            mpq_class error = 0;
            mpq_class magnitude = 0;
            for (std::size_t i = 0; i < truth.size(); ++i) {
                error += abs(mpq_class(beam.coefficients[i]) - truth[i]);
                magnitude += abs(mpq_class(beam.coefficients[i]));
            }
            const std::string what = std::string(name) + ", seed " + std::to_string(seed);
            EXPECT_LE(error, mpq_class(beam.error)) << what;
            EXPECT_LE(magnitude, mpq_class(beam.magnitude)) << what;
            EXPECT_LE(beam.error, 1e-10 * beam.magnitude) << what; // and the bound is worth something
            if (beam.has_no_zero()) {
                for (int i = 0; i < 10; ++i) {
                    const mpq_class u = mpq_class(spans[0].center) + mpq_class(part) * number();
                    const mpq_class v = mpq_class(spans[1].center) + mpq_class(part) * number();
                    const mpq_class w = mpq_class(spans[2].center) + mpq_class(part) * number();
                    EXPECT_EQ(sgn(value(exact, u, v, w)), beam.coefficients[0] > 0 ? 1 : -1) << what;
                }
            }
        }
    }
}

TEST_F(Beams, RowsAreTheBeamAtTheirV) {
    base::Run run;
    const ExactBeam exact(test::surface("torus"), pencil(), run);
    const Beam beam = WideBeam(exact).part({0.25, 0.5}, {-0.25, 0.25}).slab({0.0, 0.5});
    const BeamLayout& layout = exact.layout();
    const std::size_t n = layout.degree();
    std::vector<double> row(BeamRow::most_coefficients);
    std::vector<double> derivative(row.size());
    const double v = 0.375;
    beam.collapse_rows(layout, v, row.data(), derivative.data());
    for (std::size_t k = 0; k <= n; ++k)
        for (std::size_t a = 0; a + k <= n; ++a) {
            double sum = 0.0;
            double slope = 0.0;
            for (std::size_t b = 0; a + b + k <= n; ++b) {
                const double c = beam.coefficients[layout.start(k, b) + a];
                sum += c * std::pow(v, static_cast<double>(b));
                if (b > 0) slope += c * static_cast<double>(b) * std::pow(v, static_cast<double>(b) - 1.0);
            }
            EXPECT_NEAR(row[k * (n + 1) + a], sum, 1e-14 * beam.magnitude);
            EXPECT_NEAR(derivative[k * (n + 1) + a], slope, 1e-13 * beam.magnitude);
        }
}

/// All rays of a row at once against one by one in twice the precision.
TEST_F(Beams, RowsOfRaysAgreeOnEveryVectorUnit) {
    base::Run run;
    for (const char* name : {"sphere", "torus", "barth6", "endrass8", "bicubic18"}) {
        const ExactBeam exact(test::surface(name), pencil(), run);
        const WideBeam wide(exact);
        const Beam beam = wide.part({0.0, 1.0}, {0.0, 1.0}).slab({0.0, 1.0});
        const std::size_t n = exact.layout().degree();
        std::vector<double> row(BeamRow::most_coefficients);
        std::vector<double> derivative(row.size());
        const double v = 0.125;
        beam.collapse_rows(exact.layout(), v, row.data(), derivative.data());
        constexpr std::size_t count = 32;
        std::vector<double> u(count);
        std::vector<double> lower(count, -1.0);
        std::vector<double> upper(count, 1.0);
        for (std::size_t i = 0; i < count; ++i) u[i] = (static_cast<double>(i) - 15.5) / 16.0;
        lower[7] = 1.0;
        upper[7] = -1.0;
        for (const base::VectorUnit unit : base::available_vector_units()) {
            std::vector<RayState> state(count);
            std::vector<double> root(count), du(count), dv(count), dw(count);
            std::vector<std::int8_t> side(count);
            std::vector<std::uint8_t> steps(count);
            beam_row_solver(unit)({.degree = n,
                                   .coefficients = row.data(),
                                   .v_derivative = derivative.data(),
                                   .bernstein = bernstein_matrix(n),
                                   .error = beam.error + beam_row_rounding(n) * beam.magnitude,
                                   .count = count,
                                   .u = u.data(),
                                   .lower = lower.data(),
                                   .upper = upper.data(),
                                   .state = state.data(),
                                   .root = root.data(),
                                   .du = du.data(),
                                   .dv = dv.data(),
                                   .dw = dw.data(),
                                   .side = side.data(),
                                   .steps = steps.data()});
            EXPECT_EQ(state[7], RayState::no_root);
            for (std::size_t i = 0; i < count; ++i) {
                if (i == 7 || state[i] == RayState::undecided) continue;
                const std::string what = std::string(name) + ", " + std::string(base::name(unit)) + ", ray " +
                                         std::to_string(i) + ", seed " + std::to_string(seed);
                double error = 0.0;
                const FirstRootAnswer truth = first_root(wide.on_ray(u[i], v, error), error, -1.0, 1.0);
                if (truth.state == RayState::undecided) continue;
                ASSERT_EQ(state[i], truth.state) << what;
                if (side[i] != 0 && truth.side != 0) {
                    EXPECT_EQ(side[i], truth.side) << what;
                }
                if (truth.state != RayState::root) continue;
                EXPECT_NEAR(root[i], truth.root, 2.0 * root_precision) << what;
                // The sign falls or rises as the derivative along the ray says.
                EXPECT_LT(side[i] * dw[i], 0.0) << what;
                // du, dv against differences of the exact polynomial.
                const mpq_class h(1, 1 << 20);
                const mpq_class w(root[i]);
                const mpq_class x(u[i]);
                const mpq_class y(v);
                std::size_t bits = 0;
                for (const mpz_class& c : exact.coefficients())
                    bits = std::max(bits, mpz_sizeinbase(c.get_mpz_t(), 2));
                mpq_class scale = 1;
                mpz_mul_2exp(scale.get_num_mpz_t(), scale.get_num_mpz_t(), bits);
                if (n > 8 || i % 8 != 0) continue;
                const double by_u =
                    mpq_class((value(exact, x + h, y, w) - value(exact, x - h, y, w)) / (2 * h * scale))
                        .get_d();
                const double by_v =
                    mpq_class((value(exact, x, y + h, w) - value(exact, x, y - h, w)) / (2 * h * scale))
                        .get_d();
                EXPECT_NEAR(du[i], by_u, 1e-7 * beam.magnitude) << what;
                EXPECT_NEAR(dv[i], by_v, 1e-7 * beam.magnitude) << what;
            }
        }
    }
}

} // namespace
} // namespace eliminant::field
