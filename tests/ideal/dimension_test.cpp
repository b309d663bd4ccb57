#include "eliminant/ideal/dimension.hpp"

#include "eliminant/ideal/operations.hpp"
#include "ideal/support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

namespace eliminant::ideal {
namespace {

TEST(Dimension, OfKnownVarieties) {
    base::Run run;
    for (const Ring& ring : testing::sample_rings()) {
        const auto [x, y, z] = variables<3>(ring);
        const Polynomial one = number(ring, 1);
        EXPECT_EQ(dimension(Ideal(ring), run), 3);
        EXPECT_EQ(dimension(Ideal::unit(ring), run), -1);
        EXPECT_EQ(codimension(Ideal::unit(ring), run), 4);
        EXPECT_EQ(dimension(ideal_of({x * y, x * z}), run),
                  2); // Cox, Little, O'Shea, §9.1: a plane and a line
        EXPECT_EQ(dimension(ideal_of({x * y, y * z, x * z}), run), 1);
        EXPECT_EQ(dimension(ideal_of({y - x * x, z - x * y}), run), 1);
        EXPECT_EQ(dimension(ideal_of({x, y, z - one}), run), 0);
        EXPECT_EQ(codimension(ideal_of({x * x - y}), run), 1);
        EXPECT_EQ(maximal_independent_set(ideal_of({x * y, x * z}), run), (std::vector<std::size_t>{1, 2}));
        EXPECT_THROW(static_cast<void>(maximal_independent_set(Ideal::unit(ring), run)), DomainError);
    }
    const Ring nothing(CoefficientField::rationals(), {});
    EXPECT_EQ(dimension(Ideal(nothing), run), 0);
    EXPECT_EQ(dimension(Ideal::unit(nothing), run), -1);
    EXPECT_TRUE(maximal_independent_set(Ideal(nothing), run).empty());
}

TEST(Dimension, IndependentVariablesAreIndependent) {
    base::Run run;
    for_random_pairs(61, [&](const Ideal& I, const Ideal& J, Random&) {
        EXPECT_EQ(dimension(intersect(I, J, run), run), std::max(dimension(I, run), dimension(J, run)));
        EXPECT_EQ(dimension(product(I, J, run), run), std::max(dimension(I, run), dimension(J, run)));
        EXPECT_LE(dimension(sum(I, J), run), std::min(dimension(I, run), dimension(J, run)));
        if (I.is_unit(run)) return;
        const std::vector<std::size_t> free = maximal_independent_set(I, run);
        std::vector<std::size_t> bound;
        for (std::size_t i = 0; i < 3; ++i) {
            if (std::ranges::find(free, i) == free.end()) bound.push_back(i);
        }
        EXPECT_TRUE(eliminate(I, bound, run).is_zero());
        for (const std::size_t i : bound) {
            std::vector<std::size_t> others = bound;
            std::erase(others, i);
            EXPECT_FALSE(eliminate(I, others, run).is_zero()); // maximal
        }
    });
}

TEST(Dimension, OfEdgeIdealsIsTheIndependenceNumber) {
    // The edge ideal of a graph: its dimension is the size of the largest independent set of vertices.
    base::Run run;
    Random random(62);
    for (int round = 0; round < 20; ++round) {
        const std::size_t n = 1 + random() % 12;
        const Ring ring(CoefficientField::prime(7), testing::numbered_names(n));
        std::vector<Polynomial> edges;
        std::vector<std::uint32_t> masks;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                if (random() % 3 != 0) continue;
                edges.push_back(Polynomial::variable(ring, i) * Polynomial::variable(ring, j));
                masks.push_back((1U << i) | (1U << j));
            }
        }
        std::int64_t largest = 0;
        for (std::uint32_t set = 0; set < (1U << n); ++set) {
            const auto is_inside = [set](std::uint32_t edge) { return (edge & set) == edge; };
            if (std::ranges::none_of(masks, is_inside))
                largest = std::max<std::int64_t>(largest, std::popcount(set));
        }
        EXPECT_EQ(dimension(Ideal(ring, edges), run), largest) << describe(Ideal(ring, edges));
    }
}

} // namespace
} // namespace eliminant::ideal
