#include "eliminant/groebner/buchberger.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/parse.hpp"
#include "support/random_ideals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

using namespace eliminant;

namespace {

std::vector<Polynomial> parse_all(const Ring& ring, const std::vector<std::string>& texts) {
    base::Run run;
    std::vector<Polynomial> result;
    for (const std::string& text : texts)
        result.push_back(algebra::parse_polynomial(ring, {text, "test"}, run));
    return result;
}

/// Buchberger's algorithm as first published: every pair, no criteria, no strategy, public operations only.
std::vector<Polynomial> plain_buchberger(const std::vector<Polynomial>& generators, base::Run& run) {
    std::vector<Polynomial> basis;
    std::ranges::copy_if(generators, std::back_inserter(basis),
                         [](const Polynomial& f) { return !f.is_zero(); });
    for (std::size_t j = 0; j < basis.size(); ++j) {
        for (std::size_t i = 0; i < j; ++i) {
            Polynomial r = normal_form(s_polynomial(basis[i], basis[j]), basis, run);
            if (!r.is_zero()) basis.push_back(r.primitive_part());
        }
    }
    return reduced_basis(std::move(basis), run);
}

std::string describe(const Ring& ring, const std::vector<Polynomial>& generators) {
    std::string text = ring.to_string() + ":";
    for (const Polynomial& f : generators) {
        for (std::size_t i = 0; i < f.size(); ++i)
            text += " + " + f.coefficient(i).get_str() + "*" + f.monomial(i).to_string();
        text += ";";
    }
    return text;
}

TEST(Buchberger, AgreesWithThePlainAlgorithmOnRandomIdeals) {
    eliminant::testing::Random random(11);
    base::Run run;
    for (const Ring& ring : eliminant::testing::sample_rings()) {
        for (int round = 0; round < 6; ++round) {
            std::vector<Polynomial> generators;
            for (std::uint64_t i = 0; i < 1 + random() % 3; ++i)
                generators.push_back(
                    eliminant::testing::random_small(ring, random, 1 + random() % 4, 1 + random() % 3));
            const std::vector<Polynomial> expected = plain_buchberger(generators, run);
            for (const auto selection : {groebner::Selection::sugar, groebner::Selection::normal}) {
                BuchbergerOptions options;
                options.selection = selection;
                const GroebnerBasis basis = buchberger(ring, generators, options, run);
                EXPECT_TRUE(basis.complete);
                EXPECT_EQ(basis.proof, groebner::Proof::full);
                EXPECT_EQ(basis.elements, expected) << describe(ring, generators);
                EXPECT_TRUE(is_reduced_groebner(basis.elements, run)) << describe(ring, generators);
            }
        }
    }
}

TEST(Buchberger, AgreesWithThePlainAlgorithmWhereNumbersAreLong) {
    // Coefficients of 40 digits make every basis element long, so the pass modulo a prime and its proof are
    // used.
    eliminant::testing::Random random(12);
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"});
    std::uint64_t passed_over = 0;
    for (int round = 0; round < 5; ++round) {
        std::vector<Polynomial> generators;
        for (int i = 0; i < 3; ++i) {
            PolynomialBuilder builder(ring);
            for (int t = 0; t < 4; ++t) {
                mpz_class c = 1;
                for (int k = 0; k < 4; ++k) c = c * 4294967296 + static_cast<unsigned long>(random() >> 32);
                builder.add(Integer(c), std::vector<std::uint64_t>{random() % 3, random() % 2, random() % 2});
            }
            generators.push_back(builder.build());
        }
        const GroebnerBasis basis = buchberger(ring, generators, {}, run);
        EXPECT_EQ(basis.elements, plain_buchberger(generators, run)) << describe(ring, generators);
        passed_over += basis.statistics.zero_modulo_prime;
    }
    EXPECT_GT(passed_over, 0U);
}

TEST(Buchberger, IsNotMisledByThePrimeOfItsFirstPass) {
    // p = 2^31 − 1 is the prime tried first. Modulo p these long-numbered systems lose terms, leading terms
    // and S-polynomials.
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"}, MonomialOrder::lex());
    base::Run run;
    const std::string big = "340282366920938463463374607431768211507"; // 2^128 + 51
    const std::vector<std::vector<std::string>> systems = {
        {"y*" + big, "y+x+2147483647*x^2"},
        {"2147483647*x*y*" + big + "+z", big + "*y^2*x-2147483647*z+1"},
        {big + "*x^2-y", "x*y-2147483647*z^2", "2147483647*x*z-" + big + "*y^2"},
        {big + "*x*y-1", big + "*x*z-1+2147483647*y", "y^2-z"},
    };
    for (const auto& texts : systems) {
        const std::vector<Polynomial> generators = parse_all(ring, texts);
        EXPECT_EQ(buchberger(ring, generators, {}, run).elements, plain_buchberger(generators, run))
            << texts.front();
    }
}

TEST(Buchberger, KnowsTheTrivialIdeals) {
    base::Run run;
    for (const Ring& ring : eliminant::testing::sample_rings()) {
        const Polynomial zero(ring);
        const Polynomial one = Polynomial::constant(ring, 1);
        const Polynomial x = Polynomial::variable(ring, std::size_t{0});
        EXPECT_TRUE(buchberger(ring, {}, {}, run).elements.empty());
        EXPECT_TRUE(buchberger(ring, std::vector{zero, zero}, {}, run).elements.empty());
        EXPECT_EQ(buchberger(ring, std::vector{x, x - one}, {}, run).elements, std::vector{one});
        EXPECT_EQ(buchberger(ring, std::vector{x, zero, x, x}, {}, run).elements, std::vector{x});
    }
    const Ring no_variables(CoefficientField::rationals(), {});
    const Polynomial five = Polynomial::constant(no_variables, 5);
    EXPECT_EQ(buchberger(no_variables, std::vector{five}, {}, run).elements,
              std::vector{Polynomial::constant(no_variables, 1)});
}

TEST(Buchberger, FindsTextbookBases) {
    base::Run run;
    // Cox, Little, O'Shea, Ideals, Varieties, and Algorithms, §2.7 example 1 and §2.8 (Lagrange multipliers
    // aside).
    const Ring grlex(CoefficientField::rationals(), {"x", "y"}, MonomialOrder::deglex());
    EXPECT_EQ(buchberger(grlex, parse_all(grlex, {"x^3-2*x*y", "x^2*y-2*y^2+x"}), {}, run).elements,
              parse_all(grlex, {"2*y^2-x", "x*y", "x^2"}));
    const Ring lex(CoefficientField::rationals(), {"x", "y", "z"}, MonomialOrder::lex());
    EXPECT_EQ(buchberger(lex, parse_all(lex, {"x^2+y+z-1", "x+y^2+z-1", "x+y+z^2-1"}), {}, run).elements,
              parse_all(lex, {"z^6-4*z^4+4*z^3-z^2", "2*y*z^2+z^4-z^2", "y^2-y-z^2+z", "x+y+z^2-1"}));
}

TEST(Buchberger, WidensItsMonomialsWhenTheyOutgrowThem) {
    // Exponents up to 127 fit in eight bits; the S-polynomials of these do not, nor those of the second in
    // sixteen.
    base::Run run;
    const Ring ring(CoefficientField::prime(32003), {"x", "y"}, MonomialOrder::lex());
    EXPECT_EQ(buchberger(ring, parse_all(ring, {"x^100-y^101", "x^60*y-1"}), {}, run).elements,
              plain_buchberger(parse_all(ring, {"x^100-y^101", "x^60*y-1"}), run));
    const std::vector<Polynomial> large = parse_all(ring, {"x^30000-y^30001", "x^20000*y^20000-1"});
    EXPECT_EQ(buchberger(ring, large, {}, run).elements, plain_buchberger(large, run));
    const Ring graded = ring.with_order(MonomialOrder::degrevlex());
    const auto too_large = parse_all(graded, {"x^6000000000000000000*y-1", "x*y^6000000000000000000-x"});
    EXPECT_THROW(buchberger(graded, too_large, {}, run), OverflowError);
}

TEST(Buchberger, StopsAtTheElementAskedFor) {
    base::Run run;
    // The graph of the twisted cubic, homogenised: degree by degree, the first element without s, t has
    // degree 2.
    const Ring ring(CoefficientField::rationals(), {"s", "t", "x", "y", "z", "w"},
                    MonomialOrder::elimination({0, 1}));
    BuchbergerOptions options;
    options.grading = {1, 1, 3, 3, 3, 3};
    options.selection = groebner::Selection::normal;
    options.stop_at = [](const Polynomial& f) { return f.degree(0) <= 0 && f.degree(1) <= 0; };
    const GroebnerBasis basis =
        buchberger(ring, parse_all(ring, {"x-s^3", "y-s^2*t", "z-s*t^2", "w-t^3"}), options, run);
    EXPECT_FALSE(basis.complete);
    EXPECT_EQ(basis.elements.back().total_degree(), 2);
}

TEST(Buchberger, GivesTheBasisUpToADegreeForHomogeneousInput) {
    base::Run run;
    const Ring ring(CoefficientField::prime(32003), {"x", "y", "z", "h"});
    const std::vector<Polynomial> generators =
        parse_all(ring, {"x^2*y-z*h^2", "y^2*z-x*h^2", "z^2*x-y*h^2+h^3"});
    const std::vector<Polynomial> whole = buchberger(ring, generators, {}, run).elements;
    for (std::uint64_t bound = 3; bound < 8; ++bound) {
        BuchbergerOptions options;
        options.grading = {1, 1, 1, 1};
        options.degree_bound = bound;
        std::vector<Polynomial> part = buchberger(ring, generators, options, run).elements;
        part = reduced_basis(std::move(part), run);
        std::vector<Polynomial> expected = whole;
        std::erase_if(expected, [&](const Polynomial& f) {
            return f.total_degree() > static_cast<std::int64_t>(bound);
        });
        EXPECT_EQ(part, expected) << "degree bound " << bound;
    }
}

TEST(Buchberger, CountsWhatTheCriteriaSave) {
    base::Run run;
    const Ring ring(CoefficientField::prime(32003), {"a", "b", "c", "d", "e"});
    const auto generators =
        parse_all(ring, {"a+b+c+d+e", "a*b+b*c+c*d+d*e+e*a", "a*b*c+b*c*d+c*d*e+d*e*a+e*a*b",
                         "a*b*c*d+b*c*d*e+c*d*e*a+d*e*a*b+e*a*b*c", "a*b*c*d*e-1"});
    const GroebnerBasis basis = buchberger(ring, generators, {}, run);
    EXPECT_EQ(basis.elements.size(), 20U); // cyclic-5
    const groebner::Statistics& s = basis.statistics;
    EXPECT_GT(s.skipped_by_product, 0U);
    EXPECT_GT(s.skipped_by_chain_m, 0U);
    EXPECT_GT(s.skipped_by_chain_f, 0U);
    EXPECT_GT(s.skipped_by_chain_b, 0U);
    const std::uint64_t all_pairs = s.basis_elements_made * (s.basis_elements_made - 1) / 2;
    EXPECT_LT(s.pairs_treated, all_pairs / 4);
    EXPECT_LT(s.zero_reductions, s.pairs_treated);
}

TEST(Buchberger, CanBeStoppedFromAnotherThread) {
    // Far beyond what any test can finish; it has to end by the request.
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x0", "x1", "x2", "x3", "x4", "x5", "x6", "x7", "x8"},
                    MonomialOrder::lex());
    std::vector<Polynomial> generators;
    eliminant::testing::Random random(5);
    for (int i = 0; i < 9; ++i) generators.push_back(eliminant::testing::random_small(ring, random, 30, 3));
    std::thread stopper([&run] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        run.request_stop();
    });
    EXPECT_THROW(buchberger(ring, generators, {}, run), Stopped);
    stopper.join();
}

TEST(Buchberger, RejectsForeignPolynomialsAndGradings) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    const Ring other(CoefficientField::rationals(), {"x", "z"});
    EXPECT_THROW(buchberger(ring, std::vector{Polynomial::variable(other, "z")}, {}, run), RingMismatchError);
    BuchbergerOptions options;
    options.grading = {1};
    EXPECT_THROW(buchberger(ring, {}, options, run), DomainError);
}

TEST(IsGroebner, TestsTheDefinition) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y"}, MonomialOrder::deglex());
    EXPECT_FALSE(is_groebner(parse_all(ring, {"x^3-2*x*y", "x^2*y-2*y^2+x"}), run));
    EXPECT_TRUE(is_groebner(parse_all(ring, {"2*y^2-x", "x*y", "x^2"}), run));
    EXPECT_TRUE(is_reduced_groebner(parse_all(ring, {"2*y^2-x", "x*y", "x^2"}), run));
    EXPECT_FALSE(is_reduced_groebner(parse_all(ring, {"x*y", "2*y^2-x", "x^2"}), run)) << "not ascending";
    EXPECT_FALSE(is_reduced_groebner(parse_all(ring, {"2*y^2-x", "x*y", "2*x^2"}), run)) << "not primitive";
    EXPECT_FALSE(is_reduced_groebner(parse_all(ring, {"2*y^2-x", "x*y", "x^2+x*y"}), run))
        << "tail not reduced";
    EXPECT_TRUE(is_groebner({}, run));
}

} // namespace
