// The parts of the resultant method on their own, each against its definition.
#include "implicit/line_fibres.hpp"
#include "implicit/line_interpolation.hpp"

#include "algebra/random.hpp"
#include "algebra/univariate_mod_p.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace eliminant::implicit {
namespace {

using algebra::PrimeField;
using algebra::Random;
namespace dense = algebra::dense;

const PrimeField field(algebra::previous_prime(short_prime_bound));

Residue random_residue(Random& random) { return random.below(field.characteristic()); }

Residues random_residues(std::size_t count, Random& random) {
    Residues result;
    for (std::size_t i = 0; i < count; ++i) result.push_back(random_residue(random));
    return result;
}

Residues with_roots(const Residues& roots) {
    Residues f = {1};
    for (const Residue root : roots) dense::multiply_by_root(field, f, root);
    return f;
}

Residue value(const Residues& f, Residue x) { return dense::evaluate<PrimeField>(field, f, x); }

// Dimensions around the number of products that a word takes, where sums are reduced in between.
const std::vector<std::size_t> dimensions = {1, 2, 3, 18, 31, 32, 33, 62, 63, 64, 65, 130};

TEST(QuotientAlgebra, ItsElementsAreFunctionsOnTheRoots) {
    base::Run run;
    Random random(1);
    for (const std::size_t n : dimensions) {
        const Residues roots = random_residues(n, random);
        const QuotientAlgebra A(field, with_roots(roots), run);
        const Residues a = random_residues(n, random);
        const Residues b = random_residues(n, random);
        const Residues product = A.multiply(a, b);
        const Residues long_polynomial = random_residues(3 * n + 1, random);
        const Residues element = A.element(long_polynomial);
        const auto inverse = A.inverse(a);
        ASSERT_TRUE(inverse) << n;
        const std::vector<Residues> coefficients = {a, b, long_polynomial};
        const Residues horner = A.value(coefficients, b);
        for (const Residue root : roots) {
            const Residue at = value(a, root);
            const Residue bt = value(b, root);
            EXPECT_EQ(value(product, root), field.multiply(at, bt)) << n;
            EXPECT_EQ(value(element, root), value(long_polynomial, root)) << n;
            EXPECT_EQ(field.multiply(value(*inverse, root), at), 1U) << n;
            const Residue expected = field.add(
                at, field.multiply(bt, field.add(bt, field.multiply(bt, value(long_polynomial, root)))));
            EXPECT_EQ(value(horner, root), expected) << n;
        }
    }
}

TEST(QuotientAlgebra, ZeroDivisorsHaveNoInverse) {
    base::Run run;
    const QuotientAlgebra A(field, with_roots({3, 5, 7}), run);
    EXPECT_FALSE(A.inverse(A.element(with_roots({5}))));
    EXPECT_FALSE(A.inverse(A.element({})));
    EXPECT_TRUE(A.inverse(A.element(with_roots({4}))));
}

TEST(QuotientAlgebra, TracesOfPowersAreThePowerSumsOfTheValues) {
    base::Run run;
    Random random(2);
    for (const std::size_t n : dimensions) {
        Residues roots = random_residues(n, random);
        if (n > 2) roots[1] = roots[0]; // multiplicities count
        const QuotientAlgebra A(field, with_roots(roots), run);
        const Residues a = random_residues(n, random);
        for (const std::size_t count : {std::size_t{1}, n, n + 2}) {
            const Residues traces = A.traces_of_powers(a, count);
            ASSERT_EQ(traces.size(), count);
            for (std::size_t k = 1; k <= count; ++k) {
                Residue sum = 0;
                for (const Residue root : roots) sum = field.add(sum, field.power(value(a, root), k));
                EXPECT_EQ(traces[k - 1], sum) << n << ", power " << k;
            }
        }
        Residues values;
        for (const Residue root : roots) values.push_back(value(a, root));
        EXPECT_EQ(from_power_sums(field, A.traces_of_powers(a, n)), with_roots(values)) << n;
    }
}

/// A random polynomial of degree at most m in s and n in t.
FormRows random_form(std::size_t m, std::size_t n, Random& random) {
    FormRows rows;
    for (std::size_t i = 0; i <= m; ++i) rows.push_back(random_residues(n + 1, random));
    return rows;
}

Residue value(const FormRows& form, Residue s, Residue t) {
    Residues in_s;
    for (const Residues& row : form) in_s.push_back(value(row, t));
    return value(in_s, s);
}

/// The image of (s, t), and the base point of the line through it.
struct ImagePoint {
    Residues base;
    Residue height;

    ImagePoint(std::span<const FormRows> forms, std::span<const Residue> direction, Residue s, Residue t) {
        const Residue scale = field.inverse(value(forms[0], s, t));
        height = field.multiply(scale, value(forms.back(), s, t));
        for (std::size_t i = 0; i < direction.size(); ++i)
            base.push_back(field.subtract(field.multiply(scale, value(forms[i + 1], s, t)),
                                          field.multiply(direction[i], height)));
    }
};

/// Over the line through the image of a point there is this point, with its height.
void expect_point(const LineFibre& fibre, Residue t, Residue height) {
    EXPECT_EQ(value(fibre.algebra.modulus(), t), 0U);
    EXPECT_EQ(value(fibre.height, t), height);
}

TEST(CurveFibres, HoldTheParametersOfALine) {
    base::Run run;
    Random random(3);
    for (const std::size_t n : {1U, 2U, 5U, 12U}) {
        const std::array forms = {random_form(0, n, random), random_form(0, n, random),
                                  random_form(0, n, random)};
        const Residues direction = random_residues(1, random);
        const Residue t = random_residue(random);
        const ImagePoint point(forms, direction, 0, t);
        const auto fibre = curve_fibres(field, forms, direction, run)->over(point.base);
        ASSERT_TRUE(fibre);
        EXPECT_EQ(fibre->algebra.dimension(), n);
        expect_point(*fibre, t, point.height);
    }
}

TEST(SurfaceFibres, HoldTheParametersOfALine) {
    base::Run run;
    Random random(4);
    for (const auto& [m, n] : {std::pair(1, 1), {1, 4}, {2, 1}, {2, 2}, {3, 3}, {4, 2}}) {
        const auto rows = static_cast<std::size_t>(m);
        const auto columns = static_cast<std::size_t>(n);
        std::vector<FormRows> forms;
        for (int i = 0; i < 4; ++i) forms.push_back(random_form(rows, columns, random));
        const Residues direction = random_residues(2, random);
        const Residue s = random_residue(random);
        const Residue t = random_residue(random);
        const ImagePoint point(forms, direction, s, t);
        const auto nodes = needed_nodes(field, forms, random(), run);
        ASSERT_TRUE(nodes);
        EXPECT_EQ(nodes->count, sufficient_nodes(forms).count) << "dense forms need all nodes";
        const auto maps = surface_fibres(field, forms, direction, *nodes, random(), run);
        ASSERT_TRUE(maps);
        const auto fibre = maps->over(point.base);
        ASSERT_TRUE(fibre) << m << ", " << n;
        EXPECT_EQ(fibre->algebra.dimension(), 2 * rows * columns) << "Bernstein's number";
        expect_point(*fibre, t, point.height);
    }
}

TEST(SurfaceFibres, LeaveOutBasePoints) {
    // All forms vanish at (2, 3): of the 2·2·2 common zeros of two of them, 7 move with the line.
    base::Run run;
    Random random(5);
    std::vector<FormRows> forms;
    for (int i = 0; i < 4; ++i) {
        forms.push_back(random_form(2, 2, random));
        forms.back()[0][0] = field.subtract(forms.back()[0][0], value(forms.back(), 2, 3));
    }
    const Residues direction = random_residues(2, random);
    const auto maps = surface_fibres(field, forms, direction, sufficient_nodes(forms), random(), run);
    ASSERT_TRUE(maps);
    const auto fibre = maps->over(random_residues(2, random));
    ASSERT_TRUE(fibre);
    EXPECT_EQ(fibre->algebra.dimension(), 7U);
    EXPECT_NE(value(fibre->algebra.modulus(), 3), 0U);
}

TEST(SurfaceFibres, ThereAreNoneIfTheEquationsHaveACommonFactor) {
    base::Run run;
    Random random(6);
    std::vector<FormRows> forms;
    for (int i = 0; i < 4; ++i) { // (s + t)·random
        const FormRows factor = random_form(1, 1, random);
        FormRows form(3, Residues(3, 0));
        for (std::size_t row = 0; row < 2; ++row) {
            for (std::size_t column = 0; column < 2; ++column) {
                for (Residue* cell : {&form[row + 1][column], &form[row][column + 1]})
                    *cell = field.add(*cell, factor[row][column]);
            }
        }
        forms.push_back(std::move(form));
    }
    EXPECT_FALSE(surface_fibres(field, forms, random_residues(2, random), sufficient_nodes(forms), 7, run));
}

/// A dense polynomial of a degree by its coefficients in the sequence of `exponents`.
struct DensePolynomial {
    std::vector<std::vector<std::uint64_t>> exponents;
    Residues coefficients;

    DensePolynomial(std::size_t variables, std::size_t degree, Random& random) {
        std::vector<std::uint64_t> e(variables, 0);
        for (e[0] = 0; e[0] <= degree; ++e[0])
            for (e[1] = 0; e[0] + e[1] <= degree; ++e[1])
                for (std::uint64_t last = 0; last + e[0] + e[1] <= degree; ++last) {
                    if (variables == 3) e[2] = last;
                    if (variables == 2 && last > 0) break;
                    exponents.push_back(e);
                }
        coefficients = random_residues(exponents.size(), random);
    }

    Residue at(const Residues& point) const {
        Residue sum = 0;
        for (std::size_t i = 0; i < exponents.size(); ++i) {
            Residue term = coefficients[i];
            for (std::size_t j = 0; j < point.size(); ++j)
                term = field.multiply(term, field.power(point[j], exponents[i][j]));
            sum = field.add(sum, term);
        }
        return sum;
    }
};

TEST(LineInterpolation, IsTheInverseOfRestriction) {
    Random random(8);
    for (const std::size_t variables : {2U, 3U}) {
        for (const std::size_t degree : {1U, 2U, 3U, 6U}) {
            const DensePolynomial F(variables, degree, random);
            const Residues direction = random_residues(variables - 1, random);
            LineInterpolation lines(field, degree, direction, random_residues(variables - 1, random));
            Residue scale = 0;
            for (std::size_t line = 0; line < lines.line_count(); ++line) {
                Residues heights;
                Residues values;
                for (std::size_t i = 0; i <= degree; ++i) {
                    heights.push_back(static_cast<Residue>(i));
                    Residues point = lines.base(line);
                    for (std::size_t j = 0; j < point.size(); ++j)
                        point[j] = field.add(point[j], field.multiply(direction[j], heights.back()));
                    point.push_back(heights.back());
                    values.push_back(F.at(point));
                }
                Residues restriction = dense::interpolate<PrimeField>(field, heights, values);
                ASSERT_EQ(restriction.size(), degree + 1);
                if (line == 0) scale = restriction.back();
                EXPECT_EQ(restriction.back(), scale) << "the same on all lines";
                dense::make_monic(field, restriction);
                lines.set(line, restriction);
            }
            const auto terms = lines.terms();
            EXPECT_EQ(terms.size(), F.exponents.size());
            for (const auto& [exponents, coefficient] : terms) {
                const auto place = std::ranges::find(F.exponents, exponents) - F.exponents.begin();
                EXPECT_EQ(field.multiply(coefficient, scale),
                          F.coefficients[static_cast<std::size_t>(place)]);
            }
        }
    }
}

} // namespace
} // namespace eliminant::implicit
