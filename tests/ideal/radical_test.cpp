#include "eliminant/ideal/radical.hpp"

#include "eliminant/ideal/dimension.hpp"
#include "eliminant/ideal/operations.hpp"
#include "eliminant/ideal/zero_dimensional.hpp"
#include "ideal/support.hpp"

#include <gtest/gtest.h>

namespace eliminant::ideal {
namespace {

const Ring xyz(CoefficientField::rationals(), {"x", "y", "z"});

TEST(ZeroDimensional, StandardMonomialsAreABasisOfTheQuotient) {
    base::Run run;
    Random random(81);
    int seen = 0;
    for (const Ring& ring : testing::sample_rings()) {
        const Ideal I = random_ideal(ring, random, 4, 3, 2);
        const auto size = vector_space_dimension(I, run);
        EXPECT_EQ(size.has_value(), dimension(I, run) <= 0) << describe(I);
        EXPECT_EQ(size.has_value(), is_zero_dimensional(I, run)) << describe(I);
        if (!size) {
            EXPECT_THROW(static_cast<void>(standard_monomials(I, run)), DomainError);
            continue;
        }
        ++seen;
        const std::vector<Monomial> standard = standard_monomials(I, run);
        EXPECT_EQ(*size, standard.size()) << describe(I);
        for (std::size_t i = 0; i < standard.size(); ++i) {
            const Polynomial m = Polynomial::term(standard[i], 1);
            EXPECT_EQ(I.normal_form(m, run), m) << describe(I);
            if (i > 0) {
                EXPECT_LT(standard[i - 1], standard[i]);
            }
        }
    }
    EXPECT_GT(seen, 5);
}

TEST(ZeroDimensional, MinimalPolynomialGeneratesTheEliminationIdeal) {
    base::Run run;
    Random random(82);
    for (const Ring& ring : testing::sample_rings()) {
        const Ideal I = random_ideal(ring, random, 4, 3, 2);
        if (!is_zero_dimensional(I, run)) continue;
        for (std::size_t x = 0; x < 3; ++x) {
            const Polynomial m = minimal_polynomial(I, Polynomial::variable(ring, x), run);
            const std::vector<std::size_t> map{0};
            std::vector<std::size_t> others{0, 1, 2};
            std::erase(others, x);
            const Ideal E = eliminate(I, others, run);
            EXPECT_EQ(E.generators(), std::vector{m.in_ring(E.ring(), map).primitive_part()}) << describe(I);
        }
        // Of an arbitrary element: it vanishes there, and no proper divisor by a root does (degree is
        // minimal).
        const Polynomial f = random_small(ring, random, 3, 2);
        const Polynomial m = minimal_polynomial(I, f, run);
        base::Run inner;
        Polynomial value(ring);
        for (std::int64_t k = m.total_degree(); k >= 0; --k) {
            const std::vector<std::uint64_t> exponents{static_cast<std::uint64_t>(k)};
            value = value * f + Polynomial::constant(ring, m.coefficient_of(Monomial(m.ring(), exponents)));
        }
        EXPECT_TRUE(I.contains(value, inner)) << describe(I) << describe(f);
    }
    EXPECT_THROW(static_cast<void>(minimal_polynomial(Ideal(xyz), Polynomial::variable(xyz, 0), run)),
                 DomainError);
    const Ring nothing(CoefficientField::rationals(), {});
    const Polynomial seven = number(nothing, 7);
    const Polynomial m = minimal_polynomial(Ideal(nothing), seven, run);
    EXPECT_EQ(m, Polynomial::variable(m.ring(), 0) - number(m.ring(), 7));
    EXPECT_TRUE(minimal_polynomial(Ideal::unit(nothing), seven, run).is_one());
}

TEST(Radical, OfKnownIdeals) {
    base::Run run;
    for (const Ring& ring : testing::sample_rings()) {
        const auto [x, y, z] = variables<3>(ring);
        const Polynomial one = number(ring, 1);
        EXPECT_TRUE(radical(Ideal(ring), run).is_zero());
        EXPECT_TRUE(radical(Ideal::unit(ring), run).is_unit(run));
        EXPECT_TRUE(radical(ideal_of({x * x * y * y * y}), run).equals(ideal_of({x * y}), run));
        EXPECT_TRUE(radical(ideal_of({x * x, y * y}), run).equals(ideal_of({x, y}), run));
        EXPECT_TRUE(radical(ideal_of({x * x, x * y}), run).equals(ideal_of({x}), run)); // an embedded point
        EXPECT_TRUE(radical(ideal_of({x * x - y * z, pow(y, 3)}), run).equals(ideal_of({x, y}), run));
        // A plane, a line and a point, each with its multiplicity.
        const Ideal plane = ideal_of({z});
        const Ideal line = ideal_of({x - one, y});
        const Ideal point = ideal_of({x, y - one, z - one});
        const Ideal thick =
            product(power(plane, 2, run), product(power(line, 2, run), power(point, 2, run), run), run);
        const Ideal thin = intersect(std::vector{plane, line, point}, run);
        EXPECT_TRUE(radical(thick, run).equals(thin, run)) << ring.to_string();
        // Two tangent curves.
        EXPECT_TRUE(radical(ideal_of({y - x * x, y * y}), run).equals(ideal_of({x, y}), run));
    }
}

TEST(Radical, DefinitionOnRandomIdeals) {
    base::Run run;
    Random random(83);
    for (const Ring& ring : testing::sample_rings()) {
        const Ideal I = random_ideal(ring, random, 2, 2, 2);
        const Ideal J = power(random_ideal(ring, random, 2, 2, 1), 2, run);
        for (const Ideal& K : {I, J, intersect(I, J, run)}) {
            const Ideal root = radical(K, run);
            EXPECT_TRUE(root.contains(K, run)) << describe(K);
            for (const Polynomial& f : root.generators())
                EXPECT_TRUE(radical_contains(K, f, run)) << describe(K);
            EXPECT_TRUE(radical(root, run).equals(root, run)) << describe(K);
            EXPECT_EQ(dimension(root, run), dimension(K, run)) << describe(K);
        }
        EXPECT_TRUE(
            radical(intersect(I, J, run), run).equals(intersect(radical(I, run), radical(J, run), run), run))
            << describe(I) << describe(J);
        EXPECT_TRUE(radical(product(I, J, run), run).equals(radical(intersect(I, J, run), run), run))
            << describe(I) << describe(J);
    }
}

TEST(Radical, WhereFieldsAreNotPerfect) {
    // Over GF(p)(z) the polynomials xᵖ − z and yᵖ − z are irreducible but have one p-fold root: the radical
    // of (xᵖ − z, yᵖ − z) has the generator x − y, which no squarefree part shows.
    base::Run run;
    for (const std::uint64_t p : {2U, 3U, 5U}) {
        const Ring ring(CoefficientField::prime(p), {"x", "y", "z"});
        const auto [x, y, z] = variables<3>(ring);
        const Ideal I = ideal_of({pow(x, p) - z, pow(y, p) - z});
        EXPECT_TRUE(radical(I, run).equals(ideal_of({x - y, pow(x, p) - z}), run)) << p;
        const Ideal J = ideal_of({pow(x, p * p) - z, pow(y, p) - z});
        EXPECT_TRUE(radical(J, run).equals(ideal_of({pow(x, p) - y, pow(y, p) - z}), run)) << p;
    }
}

TEST(Radical, CanBeStopped) {
    base::Run run({.time_limit_seconds = 0.05});
    EXPECT_THROW(static_cast<void>(radical(testing::long_work(), run)), Stopped);
}

} // namespace
} // namespace eliminant::ideal
