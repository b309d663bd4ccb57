// Packed monomials: their fields, and the deciding ones, which give all others.
#include "eliminant/algebra/monomial_layout.hpp"

#include "eliminant/algebra/print.hpp"
#include "support/random_polynomials.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace eliminant;
using eliminant::algebra::MonomialLayout;

namespace {

/// Σ (value of a deciding field) · column, word by word.
std::vector<std::uint64_t> from_deciding_fields(const MonomialLayout& layout, const std::uint64_t* monomial) {
    std::vector<std::uint64_t> sum(layout.words(), 0);
    const auto deciding = layout.deciding_fields();
    for (std::size_t i = 0; i < deciding.size(); ++i)
        for (std::size_t w = 0; w < sum.size(); ++w)
            sum[w] += layout.field_value(monomial, deciding[i]) * layout.column(i)[w];
    return sum;
}

void expect_fields_decided(const Ring& ring, std::mt19937_64& random) {
    for (const unsigned bits : {8U, 16U, 32U, 64U}) {
        const MonomialLayout& layout = ring.layout(bits);
        EXPECT_LE(layout.deciding_fields().size(), layout.field_count());
        for (int round = 0; round < 20; ++round) {
            std::vector<std::uint64_t> exponents(ring.variable_count());
            for (auto& e : exponents) e = random() % 4;
            std::vector<std::uint64_t> monomial(layout.words());
            if (!layout.encode(exponents, monomial.data())) continue;
            EXPECT_EQ(from_deciding_fields(layout, monomial.data()), monomial)
                << ring << ", " << bits << " bits";
        }
    }
}

TEST(MonomialLayout, DecidingFieldsGiveTheMonomial) {
    constexpr std::uint64_t seed = 7;
    std::mt19937_64 random(seed);
    for (std::size_t n = 1; n <= 6; ++n) {
        for (const MonomialOrder& order : eliminant::testing::every_order(n, random))
            expect_fields_decided(
                Ring(CoefficientField::rationals(), eliminant::testing::variable_names(n), order), random);
    }
    for (int i = 0; i < 40; ++i) { // matrices, of which rows may be even or depend on others modulo 2^64
        const std::size_t n = 2 + random() % 3;
        std::vector<std::vector<std::int64_t>> rows(n + 1, std::vector<std::int64_t>(n));
        for (auto& row : rows)
            for (auto& entry : row) entry = static_cast<std::int64_t>(random() % 7);
        for (std::size_t j = 0; j < n; ++j) rows[0][j] = 2;
        try {
            expect_fields_decided(Ring(CoefficientField::rationals(), eliminant::testing::variable_names(n),
                                       MonomialOrder::matrix(rows)),
                                  random);
        } catch (const DomainError&) { // of too small a rank
            continue;
        }
    }
}

TEST(MonomialLayout, InDegrevlexOneExponentFollowsFromTheDegree) {
    const std::size_t n = 500;
    std::mt19937_64 random(1);
    const Ring ring(CoefficientField::rationals(), eliminant::testing::variable_names(n));
    EXPECT_EQ(ring.layout(16).field_count(), n + 1);
    EXPECT_EQ(ring.layout(16).deciding_fields().size(), n);
    expect_fields_decided(ring, random);
}

} // namespace
