// The parts of the linear method against their definitions.
#include "implicit/nullvector.hpp"
#include "implicit/rational_interpolation.hpp"
#include "implicit/roots_modulo.hpp"
#include "implicit/support.hpp"
#include "implicit/vanishing_polynomial.hpp"

#include <algorithm>
#include <random>
#include <set>

namespace eliminant::implicit {
namespace {

const PrimeField field(536870909); // the greatest below 2^29

std::vector<std::uint32_t> random_residues(std::size_t count, std::mt19937_64& random) {
    std::vector<std::uint32_t> residues(count);
    for (auto& r : residues) r = static_cast<std::uint32_t>(random() % field.characteristic());
    return residues;
}

TEST(RowCombination, EveryVectorUnitAgreesWithTheDefinition) {
    std::mt19937_64 random(1);
    for (const base::VectorUnit unit : base::available_vector_units()) {
        for (const std::size_t count : {0U, 1U, 3U, 4U, 7U, 8U, 9U, 16U, 31U, 100U}) {
            std::vector<std::vector<std::uint32_t>> rows;
            for (int i = 0; i < 4; ++i) rows.push_back(random_residues(count + 1, random));
            const std::uint32_t* pointers[4] = {rows[0].data() + 1, rows[1].data() + 1, rows[2].data() + 1,
                                                rows[3].data() + 1}; // unaligned
            const std::vector<std::uint32_t> factors = random_residues(4, random);
            std::vector<std::uint64_t> sums(count + 2);
            for (auto& s : sums) s = random() >> 4;
            std::vector<std::uint64_t> expected = sums;
            for (std::size_t j = 0; j < count; ++j)
                for (std::size_t i = 0; i < 4; ++i) expected[j] += std::uint64_t{factors[i]} * rows[i][j + 1];
            row_combination(unit)(sums.data(), pointers, factors.data(), count);
            EXPECT_EQ(sums, expected) << base::name(unit) << ", " << count;
        }
    }
}

TEST(Echelon, FindsTheDependenceOfColumns) {
    // Column r is a combination of the columns before it; no earlier one is, nor need a later one be.
    std::mt19937_64 random(2);
    for (const std::size_t rank : {0U, 1U, 2U, 3U, 4U, 5U, 17U, 70U, 130U}) {
        const std::vector<std::uint32_t> v = random_residues(rank, random);
        Echelon echelon(field, rank + 3);
        const auto random_row = [&] {
            std::vector<std::uint32_t> row = random_residues(rank + 3, random);
            row[rank] = 0;
            for (std::size_t j = 0; j < rank; ++j)
                row[rank] = field.subtract(row[rank], field.multiply(v[j], row[j]));
            return row;
        };
        for (std::size_t i = 0; i < rank; ++i) EXPECT_TRUE(echelon.add(random_row()));
        EXPECT_FALSE(echelon.add(random_row()));
        std::vector<std::uint32_t> expected = v;
        expected.push_back(1);
        EXPECT_EQ(echelon.dependence(), expected);
    }
}

TEST(Echelon, LargestResiduesDoNotOverflow) {
    // p − 1 everywhere but on the diagonal: entries are as large as they can be.
    constexpr std::size_t n = 200;
    const std::uint32_t top = field.characteristic() - 1;
    Echelon echelon(field, n);
    for (std::size_t i = 0; i + 1 < n; ++i) {
        std::vector<std::uint32_t> row(n, top);
        row[i] = 1000;
        EXPECT_TRUE(echelon.add(row));
    }
    const auto v = echelon.dependence();
    for (std::size_t i = 0; i + 1 < n; ++i) {
        std::uint32_t sum = 0;
        for (std::size_t j = 0; j < n; ++j) sum = field.add(sum, field.multiply(v[j], j == i ? 1000 : top));
        EXPECT_EQ(sum, 0U);
    }
}

TEST(Support, EnumeratesByWeightedDegree) {
    const std::vector<std::uint64_t> weights = {2, 1, 3};
    const Support support = Support::up_to(weights, 7);
    EXPECT_EQ(support.size(), Support::count_up_to(weights, 7, 1000));
    EXPECT_EQ(Support::count_up_to(weights, 7, 5), 5U);
    std::set<std::vector<std::uint32_t>> seen;
    std::uint64_t last = 0;
    for (std::size_t i = 0; i < support.size(); ++i) {
        const std::uint64_t degree = 2 * support[i][0] + support[i][1] + 3 * support[i][2];
        EXPECT_GE(degree, last);
        last = degree;
        EXPECT_TRUE(seen.insert({support[i].begin(), support[i].end()}).second);
    }
    std::size_t count = 0;
    for (std::uint64_t a = 0; a <= 7; ++a)
        for (std::uint64_t b = 0; b <= 7; ++b)
            for (std::uint64_t c = 0; c <= 7; ++c) count += 2 * a + b + 3 * c <= 7 ? 1 : 0;
    EXPECT_EQ(support.size(), count);
}

TEST(Roots, AreThoseOfAProductOfLinearFactors) {
    base::Run run;
    std::mt19937_64 random(3);
    algebra::Random choices(1);
    for (int round = 0; round < 50; ++round) {
        // Distinct roots, some of them twice, and a factor t² − a without roots.
        std::uint32_t a = 2;
        while (field.power(a, (field.characteristic() - 1) / 2) == 1) ++a;
        algebra::dense::Vector f = {field.negate(a), 0, 1};
        std::vector<std::uint32_t> expected = random_residues(random() % 6, random);
        for (const std::uint32_t root : expected)
            for (std::uint64_t i = 0; i <= random() % 2; ++i)
                algebra::dense::multiply_by_root(field, f, root);
        auto found = roots(field, f, choices, run);
        std::ranges::sort(found);
        std::ranges::sort(expected);
        EXPECT_EQ(found, expected);
    }
    EXPECT_TRUE(roots(field, {5}, choices, run).empty());
    EXPECT_EQ(roots(field, {0, 7}, choices, run), std::vector<std::uint32_t>{0});
}

TEST(RationalInterpolation, FindsTheFunctionOfLeastDegree) {
    base::Run run;
    std::mt19937_64 random(4);
    for (std::size_t n = 0; n < 7; ++n)
        for (std::size_t d = 0; d < 5; ++d) {
            algebra::dense::Vector numerator = random_residues(n + 1, random);
            algebra::dense::Vector denominator = random_residues(d, random);
            denominator.push_back(1);
            const auto points = random_residues(n + d + 3, random);
            std::vector<std::uint32_t> values;
            for (const std::uint32_t z : points)
                values.push_back(field.multiply(
                    algebra::dense::evaluate<PrimeField>(field, numerator, z),
                    field.inverse(algebra::dense::evaluate<PrimeField>(field, denominator, z))));
            const auto found = rational_interpolant(field, points, values, 2, run);
            ASSERT_TRUE(found) << n << "/" << d;
            EXPECT_EQ(found->numerator, numerator);
            EXPECT_EQ(found->denominator, denominator);
            const auto fewer = std::span(points).first(n + d + 1);
            const auto few =
                rational_interpolant(field, fewer, std::span(values).first(fewer.size()), 1, run);
            EXPECT_FALSE(few) << n << "/" << d;
        }
}

TEST(LinearMethod, SectionsAgreeWithElimination) {
    // More than the coefficients that are found at once; symmetric maps, several parameters, constants.
    for (const char* text :
         {"x = s^3*t-t^2+1\ny = s*t^2-2*s\nz = s^2*t-s+5*t", "x = s^2*t+t\ny = s^4-t^2*s^2\nz = t^4-s^2",
          "x = (s^2+t)/(s*t+1)\ny = (s-t^2)/(s*t+1)\nz = s^2-t^2+3*s",
          "constants a, b\nx = a*t^2+b*t\ny = t^3-a*b",
          "constants R, r\nx = (R+r*cos(u))*cos(v)\ny = (R+r*cos(u))*sin(v)\nz = r*sin(u)",
          "x = s+u^2\ny = s^2-s*t\nz = t*u-s\nw = s*t^2-u"}) {
        const ImplicitResult linear = implicitized(text, {.method = Method::linear});
        EXPECT_EQ(linear.method, Method::linear) << linear.choice;
        EXPECT_EQ(joined(linear.equations), equations_of(text, {.method = Method::groebner})) << text;
    }
}

} // namespace
} // namespace eliminant::implicit
