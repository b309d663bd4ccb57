#include "algebra/chinese_remainders.hpp"
#include "algebra/galois_field.hpp"
#include "algebra/newton_interpolation.hpp"
#include "algebra/univariate_mod_p.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace eliminant;
using namespace eliminant::algebra;

namespace {

using dense::Vector;

/// Calls check(field) for prime fields and extensions, small and large.
template <class Check>
void for_each_field(const Check& check) {
    base::Run run;
    for (const std::uint64_t p : {2U, 3U, 101U, 65537U, 2147483647U}) check(PrimeField(p));
    for (const auto& [p, k] :
         {std::pair{2U, 2U}, {2U, 3U}, {3U, 2U}, {5U, 2U}, {2U, 12U}, {3U, 7U}, {101U, 2U}, {7U, 1U}})
        check(GaloisField(p, k, run));
}

template <class Field>
Vector random_vector(const Field& field, std::mt19937_64& random, std::size_t size) {
    Vector f(size);
    for (auto& c : f) c = static_cast<std::uint32_t>(random() % field_size(field));
    dense::trim(f);
    return f;
}

template <class Field>
Vector sum(const Field& field, Vector a, const Vector& b) {
    if (a.size() < b.size()) a.resize(b.size(), 0);
    dense::add_multiple<Field>(field, a, b, 1);
    dense::trim(a);
    return a;
}

TEST(GaloisField, IsAField) {
    base::Run run;
    for (const auto& [p, k] : {std::pair{2U, 2U}, {2U, 3U}, {3U, 2U}, {5U, 2U}, {3U, 3U}, {7U, 1U}}) {
        const GaloisField field(p, k, run);
        const std::uint32_t q = field.size();
        for (std::uint32_t a = 0; a < q; ++a) {
            EXPECT_EQ(field.add(a, 0), a);
            EXPECT_EQ(field.multiply(a, 1), a);
            EXPECT_EQ(field.add(a, field.negate(a)), 0U);
            if (a != 0) {
                EXPECT_EQ(field.multiply(a, field.inverse(a)), 1U);
            }
            EXPECT_EQ(field.power(a, q), a);
            for (std::uint32_t b = 0; b < q; ++b) {
                EXPECT_EQ(field.add(a, b), field.add(b, a));
                EXPECT_EQ(field.subtract(field.add(a, b), b), a);
                EXPECT_EQ(field.multiply(a, b), field.multiply(b, a));
                for (std::uint32_t c = 0; c < q; ++c) {
                    EXPECT_EQ(field.add(field.add(a, b), c), field.add(a, field.add(b, c)));
                    EXPECT_EQ(field.multiply(field.multiply(a, b), c),
                              field.multiply(a, field.multiply(b, c)));
                    EXPECT_EQ(field.multiply(a, field.add(b, c)),
                              field.add(field.multiply(a, b), field.multiply(a, c)));
                }
            }
        }
    }
}

TEST(GaloisField, ContainsItsPrimeField) {
    base::Run run;
    for (const auto& [p, k] : {std::pair{2U, 5U}, {3U, 4U}, {101U, 2U}}) {
        const GaloisField field(p, k, run);
        const PrimeField prime(p);
        std::size_t found = 0;
        for (std::uint32_t a = 0; a < field.size(); ++a) found += field.residue(a).has_value() ? 1 : 0;
        EXPECT_EQ(found, p);
        for (std::uint32_t a = 0; a < p; ++a) {
            EXPECT_EQ(field.residue(field.embed(a)), a);
            for (std::uint32_t b = 0; b < p; ++b) {
                EXPECT_EQ(field.add(field.embed(a), field.embed(b)), field.embed(prime.add(a, b)));
                EXPECT_EQ(field.multiply(field.embed(a), field.embed(b)), field.embed(prime.multiply(a, b)));
            }
        }
    }
    EXPECT_EQ(GaloisField::degree_for(2, 4096), 12U);
    EXPECT_EQ(GaloisField::degree_for(101, 10202), 3U);
    EXPECT_FALSE(GaloisField::degree_for(65537, 65538));
}

TEST(Univariate, DivisionAndGcdSatisfyTheirDefinitions) {
    std::mt19937_64 random(31);
    base::Run run;
    for_each_field([&](const auto& field) {
        for (int round = 0; round < 30; ++round) {
            const Vector a = random_vector(field, random, random() % 20);
            const Vector b = random_vector(field, random, random() % 12);
            if (!b.empty()) {
                Vector remainder = a;
                const Vector quotient = dense::divide(field, remainder, b);
                EXPECT_LT(remainder.size(), b.size());
                EXPECT_EQ(sum(field, dense::multiply(field, quotient, b), remainder), a);
            }
            const Vector h = random_vector(field, random, random() % 6);
            const Vector f = dense::multiply(field, a, h);
            const Vector g = dense::multiply(field, b, h);
            const Vector d = dense::gcd(field, f, g, run);
            if (f.empty() && g.empty()) {
                EXPECT_TRUE(d.empty());
                continue;
            }
            EXPECT_EQ(d.back(), 1U);
            Vector cofactors[2] = {f, g};
            for (Vector& cofactor : cofactors) {
                Vector rest = cofactor;
                cofactor = dense::divide(field, rest, d);
                EXPECT_TRUE(rest.empty());
            }
            EXPECT_EQ(dense::gcd(field, cofactors[0], cofactors[1], run), Vector{1});
            if (!h.empty()) {
                Vector rest = d;
                dense::divide(field, rest, h);
                EXPECT_TRUE(rest.empty());
            }
        }
    });
}

TEST(Univariate, InterpolationUndoesEvaluation) {
    std::mt19937_64 random(32);
    for_each_field([&](const auto& field) {
        using Field = std::decay_t<decltype(field)>;
        const std::size_t count = std::min<std::size_t>(field_size(field), 15);
        const Vector f = random_vector(field, random, count);
        Vector points;
        Vector values;
        NewtonInterpolation<Field> newton(field, 1, count - 1);
        for (std::uint32_t point = 0; point < count; ++point) {
            points.push_back(point);
            values.push_back(dense::evaluate<Field>(field, f, point));
            EXPECT_EQ(values.back(), dense::dot(field, f, dense::powers(field, point, f.size())));
            newton.add(point, std::span(values).last(1));
        }
        EXPECT_EQ(dense::interpolate<Field>(field, points, values), f);
        Vector column(newton.column(0).begin(), newton.column(0).end());
        dense::trim(column);
        EXPECT_EQ(column, f);
        EXPECT_TRUE(newton.complete());
    });
}

TEST(ChineseRemainders, RecoverIntegersOfBothSigns) {
    std::mt19937_64 random(33);
    // Values at even places; some vanish modulo the first prime and are not reported there.
    const std::uint64_t first_prime = previous_prime(PrimeField::max_characteristic);
    std::vector<Integer> expected;
    for (int i = 0; i < 40; ++i) {
        Integer value(static_cast<std::int64_t>(random() >> (random() % 60)));
        if (i % 3 == 0) value = value * value * value;
        if (i % 5 == 0) value *= Integer(first_prime);
        expected.push_back(i % 2 == 0 ? value : -value);
    }
    ChineseRemainders sum;
    std::uint64_t prime = PrimeField::max_characteristic;
    bool changed = true;
    for (int round = 0; round < 12; ++round) {
        prime = previous_prime(prime);
        const PrimeField field(prime);
        std::vector<std::size_t> places;
        std::vector<std::uint32_t> residues;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const std::uint32_t residue = field.from_integer(expected[i]);
            if (residue == 0) continue;
            places.push_back(2 * i);
            residues.push_back(residue);
        }
        changed = sum.add(field, places, residues);
    }
    EXPECT_FALSE(changed);
    ASSERT_EQ(sum.places().size(), expected.size());
    EXPECT_EQ(sum.values(), expected);
    EXPECT_FALSE(ChineseRemainders().small() && !sum.small());
}

} // namespace
