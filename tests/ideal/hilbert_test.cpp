#include "eliminant/ideal/hilbert.hpp"

#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/groebner/buchberger.hpp"
#include "eliminant/ideal/dimension.hpp"
#include "eliminant/ideal/operations.hpp"
#include "eliminant/ideal/zero_dimensional.hpp"
#include "ideal/support.hpp"

#include <gtest/gtest.h>

namespace eliminant::ideal {
namespace {

/// The 2×2 minors of a matrix of variables x0, x1, … given by their indices.
Ideal two_minors(const Ring& ring, const std::vector<std::vector<std::size_t>>& matrix) {
    std::vector<Polynomial> minors;
    const auto x = [&](std::size_t i, std::size_t j) { return Polynomial::variable(ring, matrix[i][j]); };
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        for (std::size_t k = i + 1; k < matrix.size(); ++k) {
            for (std::size_t j = 0; j < matrix[i].size(); ++j) {
                for (std::size_t l = j + 1; l < matrix[i].size(); ++l)
                    minors.push_back(x(i, j) * x(k, l) - x(i, l) * x(k, j));
            }
        }
    }
    return {ring, std::move(minors)};
}

Ring projective(std::size_t coordinates) {
    return {CoefficientField::rationals(), testing::numbered_names(coordinates)};
}

long binomial(long n, long k) {
    long result = 1;
    for (long i = 0; i < k; ++i) result = result * (n - i) / (i + 1);
    return result;
}

/// dim R_d / I_d by counting the monomials outside the leading ideal: the slow twin.
long count_standard(const Ideal& I, std::uint64_t degree, bool up_to, base::Run& run) {
    const std::vector<Polynomial>& basis = I.groebner_basis(MonomialOrder::degrevlex(), run);
    const Ring ring = I.ring().with_order(MonomialOrder::degrevlex());
    const std::size_t n = ring.variable_count();
    long count = 0;
    std::vector<std::uint64_t> exponents(n, 0);
    const auto visit = [&](auto&& self, std::size_t variable, std::uint64_t left) -> void {
        if (variable == n) {
            if (left != 0 && !up_to) return;
            const Monomial m(ring, exponents);
            const auto divides = [&m](const Polynomial& f) { return f.leading_monomial().divides(m); };
            count += std::ranges::none_of(basis, divides) ? 1 : 0;
            return;
        }
        for (std::uint64_t e = 0; e <= left; ++e) {
            exponents[variable] = e;
            self(self, variable + 1, left - e);
        }
        exponents[variable] = 0;
    };
    visit(visit, 0, degree);
    return count;
}

TEST(Hilbert, FunctionCountsStandardMonomials) {
    base::Run run;
    Random random(71);
    for (int round = 0; round < 3; ++round) {
        for (const Ring& ring : testing::sample_rings()) {
            const Ideal I = random_ideal(ring, random, 1 + random() % 4, 2, 1 + random() % 3, true);
            const HilbertSeries series = hilbert_series(I, run);
            const Polynomial polynomial = series.hilbert_polynomial();
            const std::int64_t regular = series.regularity_index();
            for (std::uint64_t d = 0; d < 9; ++d) {
                EXPECT_EQ(series.value(d), count_standard(I, d, false, run)) << d << describe(I);
                const mpq_class expected =
                    evaluate(polynomial, std::vector<mpq_class>{mpq_class(static_cast<long>(d))});
                if (static_cast<std::int64_t>(d) >= regular) {
                    EXPECT_EQ(series.value(d), expected) << d << describe(I);
                }
                if (static_cast<std::int64_t>(d) + 1 == regular) {
                    EXPECT_NE(series.value(d), expected) << describe(I);
                }
            }
            EXPECT_EQ(series.pole_order(), dimension(I, run)) << describe(I);
            EXPECT_EQ(series.reduced(run).value(7), series.value(7)) << describe(I);
            EXPECT_EQ(series.multiplicity(), degree(I, run)) << describe(I);
        }
    }
}

TEST(Hilbert, AffineFunctionCountsStandardMonomialsUpToADegree) {
    base::Run run;
    Random random(72);
    for (const Ring& ring : testing::sample_rings()) {
        const Ideal I = random_ideal(ring, random, 1 + random() % 3, 3, 1 + random() % 3);
        const HilbertSeries series = affine_hilbert_series(I, run);
        for (std::uint64_t d = 0; d < 7; ++d)
            EXPECT_EQ(series.value(d), count_standard(I, d, true, run)) << d << describe(I);
        EXPECT_EQ(std::max<std::int64_t>(series.pole_order() - 1, -1),
                  I.is_unit(run) ? -1 : dimension(I, run))
            << describe(I);
    }
}

TEST(Hilbert, IsAdditiveOnIntersectionAndSum) {
    // 0 → R/(I ∩ J) → R/I ⊕ R/J → R/(I + J) → 0 is exact.
    base::Run run;
    Random random(73);
    for (const Ring& ring : testing::sample_rings()) {
        const Ideal I = random_ideal(ring, random, 2, 2, 2, true);
        const Ideal J = random_ideal(ring, random, 2, 2, 2, true);
        const auto numerator = [&](const Ideal& K) { return hilbert_series(K, run).numerator(); };
        EXPECT_EQ(numerator(intersect(I, J, run)) + numerator(sum(I, J)), numerator(I) + numerator(J))
            << describe(I) << describe(J);
        // 0 → R/(I : f)(−deg f) → R/I → R/(I + f) → 0 is exact.
        const Polynomial f = random_small(ring, random, 2, 2, true);
        if (f.is_zero()) continue;
        const Ring t = numerator(I).ring();
        EXPECT_EQ(numerator(I), numerator(sum(I, Ideal(ring, {f}))) +
                                    pow(Polynomial::variable(t, 0), 2) * numerator(quotient(I, f, run)))
            << describe(I) << describe(f);
    }
}

TEST(Hilbert, RationalNormalCurves) {
    base::Run run;
    for (std::size_t n = 2; n < 6; ++n) {
        std::vector<std::size_t> top;
        std::vector<std::size_t> bottom;
        for (std::size_t i = 0; i < n; ++i) {
            top.push_back(i);
            bottom.push_back(i + 1);
        }
        const Ideal curve = two_minors(projective(n + 1), {top, bottom});
        const HilbertSeries series = hilbert_series(curve, run);
        EXPECT_EQ(degree(curve, run), static_cast<long>(n));
        EXPECT_EQ(dimension(curve, run), 2);
        const Polynomial P = series.hilbert_polynomial();
        const Polynomial d = Polynomial::variable(P.ring(), 0);
        EXPECT_EQ(P, d.scaled(static_cast<long>(n)) + number(P.ring(), 1));
        // (1 + (n − 1)t)/(1 − t)²
        const HilbertSeries reduced = series.reduced(run);
        const Polynomial t = Polynomial::variable(reduced.numerator().ring(), 0);
        EXPECT_EQ(reduced.numerator(), number(t.ring(), 1) + t.scaled(static_cast<long>(n - 1)));
        EXPECT_EQ(reduced.denominator_exponent(), 2U);
    }
}

TEST(Hilbert, SegreAndVeroneseVarieties) {
    base::Run run;
    // P¹×P² in P⁵: degree C(3, 1), H(d) = (d + 1)·C(d + 2, 2).
    const Ideal segre = two_minors(projective(6), {{0, 1, 2}, {3, 4, 5}});
    EXPECT_EQ(degree(segre, run), 3);
    EXPECT_EQ(dimension(segre, run), 4);
    // P²×P² in P⁸: degree C(4, 2).
    const Ideal segre2 = two_minors(projective(9), {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}});
    EXPECT_EQ(degree(segre2, run), 6);
    EXPECT_EQ(dimension(segre2, run), 5);
    // The Veronese surface in P⁵, minors of a symmetric matrix: degree 4, H(d) = C(2d + 2, 2).
    const Ideal veronese = two_minors(projective(6), {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}});
    EXPECT_EQ(degree(veronese, run), 4);
    EXPECT_EQ(dimension(veronese, run), 3);
    for (long d = 0; d < 8; ++d) {
        const auto u = static_cast<std::uint64_t>(d);
        EXPECT_EQ(hilbert_series(segre, run).value(u), (d + 1) * binomial(d + 2, 2));
        EXPECT_EQ(hilbert_series(segre2, run).value(u), binomial(d + 2, 2) * binomial(d + 2, 2));
        EXPECT_EQ(hilbert_series(veronese, run).value(u), binomial(2 * d + 2, 2));
    }
}

TEST(Hilbert, CompleteIntersectionsObeyBezout) {
    base::Run run;
    Random random(74);
    const Ring ring(CoefficientField::prime(32003), testing::numbered_names(4));
    for (int round = 0; round < 10; ++round) {
        std::vector<Polynomial> forms;
        mpz_class product = 1;
        const std::size_t codim = 1 + random() % 3;
        for (std::size_t i = 0; i < codim; ++i) {
            const std::uint64_t d = 1 + random() % 3;
            forms.push_back(random_small(ring, random, 30, d, true));
            product *= static_cast<unsigned long>(d);
        }
        const Ideal I(ring, forms);
        if (codimension(I, run) != static_cast<std::int64_t>(codim)) continue;
        EXPECT_EQ(degree(I, run), product) << describe(I);
        Polynomial expected = number(hilbert_series(I, run).numerator().ring(), 1);
        for (const Polynomial& f : forms)
            expected *= number(expected.ring(), 1) - pow(Polynomial::variable(expected.ring(), 0),
                                                         static_cast<std::uint64_t>(f.total_degree()));
        EXPECT_EQ(hilbert_series(I, run).numerator(), expected) << describe(I);
    }
}

TEST(Hilbert, HugeExponentsAreNoProblem) {
    base::Run run;
    const Ring ring = projective(3);
    const std::uint64_t huge = std::uint64_t{1} << 40;
    const auto power = [&](std::size_t i, std::uint64_t e) {
        std::vector<std::uint64_t> exponents(3, 0);
        exponents[i] = e;
        return Polynomial::term(Monomial(ring, exponents), 1);
    };
    const Ideal I(ring, {power(0, huge), power(1, huge), power(2, 3) * power(0, 5)});
    // Of x0: either 5 of its powers and all of x2, …: dimension 1.
    EXPECT_EQ(dimension(I, run), 1);
    EXPECT_EQ(degree(I, run), mpz_class(5) * static_cast<unsigned long>(huge));
    const Ideal artinian = sum(I, Ideal(ring, {power(2, huge)}));
    EXPECT_EQ(vector_space_dimension(artinian, run),
              mpz_class(static_cast<unsigned long>(huge)) *
                  (5 * mpz_class(static_cast<unsigned long>(huge)) +
                   3 * mpz_class(static_cast<unsigned long>(huge - 5))));
}

TEST(Hilbert, DegenerateIdeals) {
    base::Run run;
    for (std::size_t n : {0U, 1U, 3U}) {
        const Ring ring = projective(n);
        EXPECT_EQ(hilbert_series(Ideal(ring), run).value(0), 1);
        EXPECT_EQ(hilbert_series(Ideal(ring), run).pole_order(), static_cast<std::int64_t>(n));
        EXPECT_EQ(degree(Ideal(ring), run), 1);
        const HilbertSeries nothing = hilbert_series(Ideal::unit(ring), run);
        EXPECT_EQ(nothing.value(3), 0);
        EXPECT_EQ(nothing.pole_order(), -1);
        EXPECT_EQ(nothing.multiplicity(), 0);
        EXPECT_TRUE(nothing.hilbert_polynomial().is_zero());
        EXPECT_EQ(degree(Ideal::unit(ring), run), 0);
    }
    const Ring ring = projective(2);
    const auto [x, y] = variables<2>(ring);
    EXPECT_THROW(static_cast<void>(hilbert_series(Ideal(ring, {x * x - y}), run)), DomainError);
    // Homogeneous, though its generators are not.
    EXPECT_EQ(hilbert_series(Ideal(ring, {x * x - y, y}), run).value(1), 1);
}

TEST(Hilbert, CanBeStopped) {
    // Random monomials in many variables: exponentially many pivots.
    const Ring ring = projective(24);
    std::vector<Polynomial> generators;
    Random random(75);
    for (int i = 0; i < 300; ++i) {
        std::vector<std::uint64_t> exponents(24, 0);
        for (int k = 0; k < 8; ++k) exponents[random() % 24] += random() % 5;
        generators.push_back(Polynomial::term(Monomial(ring, exponents), 1));
    }
    base::Run run;
    const Ideal I = Ideal::from_groebner_basis(ring, ring.order(), reduced_basis(std::move(generators), run));
    base::Run limited({.time_limit_seconds = 0.05});
    EXPECT_THROW(static_cast<void>(hilbert_series(I, limited)), Stopped);
}

} // namespace
} // namespace eliminant::ideal
