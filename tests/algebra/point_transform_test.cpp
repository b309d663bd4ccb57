#include "algebra/point_transform.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace eliminant;
using algebra::AxisLayout;
using algebra::ExponentSet;
using algebra::PointTransform;
using algebra::ResidueFactor;
using algebra::ResidueRows;

namespace {

struct Case {
    std::vector<std::uint32_t> bounds;
    std::uint32_t degree;
};

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {{{7}, 7},          {{0}, 3},         {{5}, 3},
                                          {{4, 6}, 10},      {{6, 6}, 6},      {{1, 9}, 7},
                                          {{3, 3, 3}, 3},    {{2, 5, 1}, 6},   {{4, 0, 4}, 5},
                                          {{3, 2, 4, 2}, 5}, {{12, 300}, 312}, {{2, 2, 2, 2, 2, 2}, 4},
                                          {{20, 20, 20}, 20}};
    return all;
}

std::vector<std::vector<std::uint32_t>> points_of(const ExponentSet& set) {
    std::vector<std::vector<std::uint32_t>> points;
    set.for_each_run([&](std::span<const std::uint32_t> e, std::uint32_t run) {
        for (std::uint32_t t = 0; t < run; ++t) {
            points.emplace_back(e.begin(), e.end());
            points.back().back() = t;
        }
    });
    return points;
}

TEST(ExponentSet, EnumeratesAndCountsItsPoints) {
    for (const Case& c : cases()) {
        const ExponentSet set(c.bounds, c.degree);
        const auto points = points_of(set);
        // By definition: every vector of the box, in lexicographic sequence, that is below the plane.
        std::size_t found = 0;
        double degrees = 0;
        std::vector<std::uint32_t> e(c.bounds.size(), 0);
        for (;;) {
            std::uint32_t degree = 0;
            for (const std::uint32_t x : e) degree += x;
            if (degree <= c.degree) {
                ASSERT_LT(found, points.size());
                EXPECT_EQ(points[found], e);
                EXPECT_EQ(set.rank(e), found);
                ++found;
                degrees += degree;
            }
            std::size_t axis = e.size();
            while (axis > 0 && e[axis - 1] == c.bounds[axis - 1]) e[--axis] = 0;
            if (axis == 0) break;
            ++e[axis - 1];
        }
        EXPECT_EQ(points.size(), found);
        EXPECT_EQ(set.size(), found);
        const ExponentSet::Census census = ExponentSet::census(c.bounds, c.degree);
        EXPECT_EQ(census.points, static_cast<double>(found));
        EXPECT_EQ(census.degrees, degrees);
    }
}

TEST(AxisLayout, ColumnsAreLinesAlongTheAxis) {
    for (const Case& c : cases()) {
        const ExponentSet set(c.bounds, c.degree);
        const auto points = points_of(set);
        for (std::size_t axis = 0; axis < set.axes(); ++axis) {
            const AxisLayout layout(set, axis);
            std::vector<std::vector<std::uint32_t>> placed(set.size());
            for (std::size_t i = 0; i < points.size(); ++i) placed[layout.positions()[i]] = points[i];
            for (std::size_t k = 0; k < layout.rows(); ++k) {
                ASSERT_TRUE(k == 0 || layout.row_size(k) <= layout.row_size(k - 1));
                for (std::size_t i = 0; i < layout.row_size(k); ++i) {
                    auto expected = placed[layout.row_begin(0) + i];
                    expected[axis] = static_cast<std::uint32_t>(k);
                    EXPECT_EQ(placed[layout.row_begin(k) + i], expected);
                }
            }
        }
    }
}

TEST(PointTransform, FindsValuesAndGoesBack) {
    const base::Run run;
    for (const std::uint32_t p : {313U, 65537U, 2147483647U}) {
        const PrimeField field(p);
        std::mt19937_64 random(p);
        for (const Case& c : cases()) {
            const ExponentSet set(c.bounds, c.degree);
            const PointTransform transform(set);
            const auto points = points_of(set);
            const auto first = transform.first_positions();
            PointTransform::Values values(set.size());
            for (auto& x : values) x = static_cast<std::uint32_t>(random() % p);
            const PointTransform::Values monomials = values;
            transform.monomials_to_newton(values, field, run);
            const PointTransform::Values newton = values;
            transform.newton_to_values(values, field, run);
            const PointTransform::Values found = values;
            for (std::size_t check = 0; check < 20; ++check) {
                const std::size_t at = random() % points.size();
                std::uint32_t sum = 0;
                for (std::size_t i = 0; i < points.size(); ++i) {
                    std::uint32_t term = monomials[first[i]];
                    for (std::size_t axis = 0; axis < set.axes(); ++axis)
                        term = field.multiply(term, field.power(points[at][axis], points[i][axis]));
                    sum = field.add(sum, term);
                }
                EXPECT_EQ(found[first[at]], sum) << "p = " << p << ", point " << at;
            }
            transform.values_to_newton(values, field, run);
            EXPECT_EQ(values, newton);
            transform.newton_to_monomials(values, field, run);
            EXPECT_EQ(values, monomials);
        }
    }
}

TEST(ResidueRows, EveryUnitAgreesWithTheDefinition) {
    for (const std::uint32_t p : {3U, 7U, 65537U, 1073741827U, 2147483647U}) {
        std::mt19937_64 random(p);
        const PrimeField field(p);
        for (const std::size_t n : {0U, 1U, 5U, 8U, 37U, 64U}) {
            // The largest residues are among them.
            std::vector<std::uint32_t> x(n);
            std::vector<std::uint32_t> y(n);
            for (auto* row : {&x, &y}) {
                for (auto& value : *row)
                    value = random() % 4 == 0 ? p - 1 : static_cast<std::uint32_t>(random() % p);
            }
            const std::uint32_t c = n % 2 == 0 ? p - 1 : static_cast<std::uint32_t>(random() % p);
            for (const base::VectorUnit unit : base::available_vector_units()) {
                const ResidueRows& rows = algebra::residue_rows(unit);
                std::vector<std::uint32_t> sum = x;
                std::vector<std::uint32_t> difference = x;
                std::vector<std::uint32_t> combination = x;
                std::vector<std::uint32_t> scaled = x;
                std::vector<std::uint32_t> product = x;
                rows.add(sum.data(), y.data(), n, p);
                rows.subtract(difference.data(), y.data(), n, p);
                rows.add_multiple(combination.data(), y.data(), n, ResidueFactor(c, p), p);
                rows.scale(scaled.data(), n, ResidueFactor(c, p), p);
                std::vector<std::uint32_t> mixture = x;
                if (n > 0) rows.combine(mixture.data(), y.data(), n - 1, {p - 1, p}, {c, p}, {p - 2, p}, p);
                for (std::size_t i = 0; i + 1 < n; ++i) {
                    const std::uint32_t rest =
                        field.add(field.multiply(c, y[i]), field.multiply(p - 2, y[i + 1]));
                    EXPECT_EQ(mixture[i], field.subtract(rest, x[i])) << base::name(unit) << ", p = " << p;
                }
                rows.multiply(product.data(), y.data(), n, p);
                for (std::size_t i = 0; i < n; ++i) {
                    EXPECT_EQ(sum[i], field.add(x[i], y[i])) << base::name(unit) << ", p = " << p;
                    EXPECT_EQ(difference[i], field.subtract(x[i], y[i])) << base::name(unit) << ", p = " << p;
                    EXPECT_EQ(combination[i], field.add(x[i], field.multiply(c, y[i]))) << base::name(unit);
                    EXPECT_EQ(scaled[i], field.multiply(c, x[i])) << base::name(unit) << ", p = " << p;
                    EXPECT_EQ(product[i], field.multiply(x[i], y[i])) << base::name(unit) << ", p = " << p;
                }
            }
        }
    }
}

} // namespace
