// Ranges on boxes and certain signs on regions, against exact values at points in them.
#include "eliminant/field/range.hpp"

#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/base/error.hpp"

#include "field/surfaces.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace eliminant {
namespace {

using field::Box;

constexpr RangeForm forms[] = {RangeForm::horner, RangeForm::taylor, RangeForm::bernstein,
                               RangeForm::automatic};

mpq_class exact_value(const CompiledPolynomial& f, const glm::dvec3& p) {
    const mpq_class point[] = {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
    mpq_class value = evaluate(f.polynomial(), point);
    if (f.scale_exponent() > 0)
        mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(f.scale_exponent()));
    return value;
}

glm::dvec3 random_vector(std::mt19937_64& random, double size) {
    std::uniform_real_distribution<double> coordinate(-size, size);
    return {coordinate(random), coordinate(random), coordinate(random)};
}

/// A corner, or any point, of a box.
glm::dvec3 random_point_of(const Box& box, std::mt19937_64& random) {
    glm::dvec3 p;
    for (int i = 0; i < 3; ++i) {
        const double t = std::uniform_real_distribution<double>(0, 1)(random);
        p[i] = random() % 3 == 0 ? box.lower[i]
               : random() % 2 == 0
                   ? box.upper[i]
                   : std::clamp((1 - t) * box.lower[i] + t * box.upper[i], box.lower[i], box.upper[i]);
    }
    return p;
}

TEST(Range, contains_all_values) {
    std::mt19937_64 random(1);
    for (const test::Surface& surface : test::surfaces()) {
        const DistanceField f(surface.polynomial);
        const int boxes = surface.polynomial.size() > 1000 ? 3 : 40;
        for (int i = 0; i < boxes; ++i) {
            const double size = std::ldexp(1.0, -static_cast<int>(random() % 30));
            const glm::dvec3 center = random_vector(random, 2);
            const Box box{center - glm::abs(random_vector(random, size)),
                          center + glm::abs(random_vector(random, size))};
            for (const RangeForm form : forms) {
                const Range found = range(f, box, form);
                for (int k = 0; k < 4; ++k) {
                    const mpq_class value = exact_value(f.polynomial(), random_point_of(box, random));
                    ASSERT_TRUE(std::isfinite(found.lower) && std::isfinite(found.upper));
                    EXPECT_LE(mpq_class(found.lower), value) << surface.name << ' ' << to_string(form);
                    EXPECT_GE(mpq_class(found.upper), value) << surface.name << ' ' << to_string(form);
                }
            }
        }
    }
}

TEST(Range, bernstein_and_taylor_are_tighter_than_interval_horner) {
    std::mt19937_64 random(2);
    for (const test::Surface& surface : test::surfaces()) {
        if (surface.polynomial.size() > 1000) continue;
        const DistanceField f(surface.polynomial);
        double logarithms[4] = {};
        constexpr int boxes = 50;
        for (int i = 0; i < boxes; ++i) {
            const glm::dvec3 center = random_vector(random, 1.5);
            const Box box{center - glm::dvec3(0.05), center + glm::dvec3(0.05)};
            double width[4];
            for (std::size_t k = 0; k < 4; ++k) {
                const Range found = range(f, box, forms[k]);
                width[k] = found.upper - found.lower;
                logarithms[k] += std::log(width[k]) / boxes;
            }
            EXPECT_LE(width[3], width[1]) << surface.name; // the intersection
        }
        EXPECT_LT(logarithms[2], logarithms[0] + 1e-9) << surface.name;
        EXPECT_LT(logarithms[1], logarithms[0] + 0.05) << surface.name;
        RecordProperty(surface.name, std::to_string(std::exp(logarithms[0] - logarithms[2])));
    }
}

TEST(Range, bernstein_form_is_exact_where_it_must_be) {
    // Extreme coefficients at corners are values.
    const DistanceField linear(test::polynomial("3x-2y+z/4-1"));
    const Range of_linear = range(linear, {{-1, 0, 2}, {1, 3, 4}}, RangeForm::bernstein);
    EXPECT_NEAR(of_linear.lower, -9.5, 1e-12);
    EXPECT_NEAR(of_linear.upper, 3, 1e-12);
    const DistanceField monotone(test::polynomial("(x+y+z)^5*x*y*z"));
    const Range of_monotone = range(monotone, {{1, 1, 1}, {2, 2, 2}}, RangeForm::bernstein);
    EXPECT_NEAR(of_monotone.lower, 243, 1e-7);
    EXPECT_NEAR(of_monotone.upper, 62208, 1e-7);
    // x² − x on [0, 1]: from −1/2 to 0; interval Horner gives [−1, 0].
    const DistanceField parabola(test::polynomial("x^2-x"));
    const Range of_parabola = range(parabola, {{0, 0, 0}, {1, 0, 0}}, RangeForm::bernstein);
    EXPECT_NEAR(of_parabola.lower, -0.5, 1e-13);
    EXPECT_NEAR(of_parabola.upper, 0, 1e-13);
    EXPECT_LT(range(parabola, {{0, 0, 0}, {1, 0, 0}}, RangeForm::horner).lower, -0.99);
}

TEST(Range, overflow_and_hostile_boxes) {
    const DistanceField f(test::surface("chmutov8"));
    for (const RangeForm form : forms) {
        const Range far = range(f, {glm::dvec3(-1e200), glm::dvec3(1e300)}, form);
        EXPECT_EQ(far.lower, -INFINITY) << to_string(form);
        EXPECT_EQ(far.upper, INFINITY) << to_string(form);
        const Range point = range(f, {glm::dvec3(0), glm::dvec3(0)}, form);
        EXPECT_NEAR(point.lower, 4, 1e-12) << to_string(form);
        EXPECT_NEAR(point.upper, 4, 1e-12) << to_string(form);
        EXPECT_THROW(range(f, {{1, 0, 0}, {0, 1, 1}}, form), DomainError);
        EXPECT_THROW(range(f, {{std::nan(""), 0, 0}, {0, 1, 1}}, form), DomainError);
        EXPECT_THROW(range(f, {{-INFINITY, 0, 0}, {0, 1, 1}}, form), DomainError);
        const Range zero = range(DistanceField(test::polynomial("0")), {glm::dvec3(0), glm::dvec3(1)}, form);
        EXPECT_EQ(zero.lower, 0);
        EXPECT_EQ(zero.upper, 0);
    }
    // Too large to be expanded: interval Horner is left.
    const DistanceField large(test::polynomial("x^200*y^200*z^200+x^2+y^2+z^2-1"));
    EXPECT_EQ(range(large, {glm::dvec3(0), glm::dvec3(1)}, RangeForm::bernstein).upper, INFINITY);
    EXPECT_LT(range(large, {glm::dvec3(0), glm::dvec3(0.25)}).upper, 0);
}

TEST(CertainSign, is_that_of_every_point) {
    std::mt19937_64 random(3);
    for (const test::Surface& surface : test::surfaces()) {
        const bool is_large = surface.polynomial.size() > 1000;
        const DistanceField f(surface.polynomial);
        int certain = 0;
        const int regions = is_large ? 10 : 200;
        for (int i = 0; i < regions; ++i) {
            const glm::dvec3 center = random_vector(random, 1.5);
            const double size = is_large ? 1e-4 : 0.02;
            const Box box{center - size, center + size};
            const CertainSign on_box = sign_on_box(f, box);
            const CertainSign on_ball = sign_on_ball(f, center, size);
            for (int k = 0; k < 4; ++k) {
                glm::dvec3 direction = random_vector(random, 1);
                if (glm::dot(direction, direction) > 0.99) direction = glm::dvec3(0);
                if (on_box != CertainSign::unknown) {
                    EXPECT_EQ(f.polynomial().sign(random_point_of(box, random)), static_cast<int>(on_box));
                }
                if (on_ball != CertainSign::unknown) {
                    EXPECT_EQ(f.polynomial().sign(center + size * direction), static_cast<int>(on_ball));
                }
            }
            if (on_box != CertainSign::unknown) ++certain;
        }
        EXPECT_GT(certain, regions / 2) << surface.name;
    }
    const DistanceField sphere(test::surface("sphere"));
    EXPECT_EQ(sign_on_ball(sphere, {0, 0, 0}, 0.999), CertainSign::negative);
    EXPECT_EQ(sign_on_ball(sphere, {0, 0, 0}, 1), CertainSign::unknown);
    EXPECT_EQ(sign_on_ball(sphere, {3, 0, 0}, 1.999), CertainSign::positive);
    EXPECT_EQ(sign_on_box(sphere, {{2, 2, 2}, {3, 3, 3}}), CertainSign::positive);
    EXPECT_EQ(sign_on_box(sphere, {{0, 0, 0}, {3, 3, 3}}), CertainSign::unknown);
    EXPECT_THROW(sign_on_ball(sphere, {0, 0, 0}, -1), DomainError);
    // A point 1e-17 from the surface in a box of a single point: only exact arithmetic tells.
    const glm::dvec3 close(std::nextafter(1.0, 2.0), 0, 0);
    EXPECT_EQ(sign_on_box(sphere, {close, close}), CertainSign::positive);
}

} // namespace
} // namespace eliminant
