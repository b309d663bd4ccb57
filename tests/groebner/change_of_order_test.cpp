#include "groebner/change_of_order.hpp"

#include "eliminant/algebra/parse.hpp"
#include "groebner/classical_systems.hpp"
#include "groebner/order_lifting.hpp"
#include "support/random_ideals.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

using namespace eliminant;
using eliminant::groebner::change_order;
using eliminant::groebner::Proof;
using eliminant::testing::classical_system;
using eliminant::testing::Random;

namespace {

constexpr std::uint64_t first_prime = 2147483629; // the first that is used over ℚ

std::vector<Polynomial> in_ring(const std::vector<Polynomial>& polynomials, const Ring& ring) {
    std::vector<Polynomial> result;
    for (const Polynomial& f : polynomials) result.push_back(f.in_ring(ring));
    return result;
}

std::vector<Polynomial> basis_of(const Ring& ring, const std::vector<Polynomial>& generators,
                                 base::Run& run) {
    return buchberger(ring, in_ring(generators, ring), {}, run).elements;
}

std::vector<Polynomial> parsed(const Ring& ring, const std::vector<std::string>& texts) {
    base::Run run;
    std::vector<Polynomial> result;
    for (const std::string& text : texts) result.push_back(parse_polynomial(ring, text, run));
    return result;
}

/// Powers of the variables and terms of lower degree: of dimension zero whatever these are.
std::vector<Polynomial> random_system(const Ring& ring, Random& random, std::uint64_t max_degree) {
    std::vector<Polynomial> system;
    for (std::size_t i = 0; i < ring.variable_count(); ++i) {
        const std::uint64_t d = 1 + random() % max_degree;
        std::vector<std::uint64_t> power(ring.variable_count(), 0);
        power[i] = d;
        system.push_back(Polynomial::term(Monomial(ring, power), 1) +
                         eliminant::testing::random_small(ring, random, random() % 6, d - 1));
    }
    // A further equation now and then: multiple points disappear, standard monomials become irregular.
    if (random() % 3 == 0) system.push_back(eliminant::testing::random_small(ring, random, 4, max_degree));
    return system;
}

TEST(ChangeOfOrder, AgreesWithBuchbergerInEveryOrder) {
    Random random(17);
    base::Run run;
    std::size_t in_shape = 0;
    for (const std::uint64_t p : {0U, 2U, 3U, 101U, 2147483647U}) {
        const auto field = p == 0 ? CoefficientField::rationals() : CoefficientField::prime(p);
        const Ring source(field, {"x", "y", "z"});
        for (int round = 0; round < 12; ++round) {
            const std::vector<Polynomial> system = random_system(source, random, 3);
            const std::vector<Polynomial> basis = basis_of(source, system, run);
            for (const MonomialOrder& order :
                 {MonomialOrder::lex(), MonomialOrder::deglex(), MonomialOrder::elimination({0}),
                  MonomialOrder::weighted({1, 3, 2}, MonomialOrder::TieBreak::lex)}) {
                const Ring target = source.with_order(order);
                const auto changed = change_order(basis, target, Proof::full, run);
                ASSERT_TRUE(changed);
                EXPECT_EQ(changed->elements, basis_of(target, system, run))
                    << "p = " << p << ", round " << round << ", " << target.to_string();
                in_shape += changed->elements.size() == 3 && order.kind() == MonomialOrder::Kind::lex ? 1 : 0;
            }
        }
    }
    EXPECT_GT(in_shape, 10U) << "the case that most systems are in was hardly tested";
}

TEST(ChangeOfOrder, EliminationIdeals) {
    Random random(18);
    base::Run run;
    for (const std::uint64_t p : {0U, 3U, 32003U}) {
        const auto field = p == 0 ? CoefficientField::rationals() : CoefficientField::prime(p);
        const Ring source(field, {"x", "y", "z"});
        for (int round = 0; round < 10; ++round) {
            const std::vector<Polynomial> system = random_system(source, random, 3);
            const std::vector<Polynomial> basis = basis_of(source, system, run);
            const std::vector<Polynomial> eliminated =
                basis_of(source.with_order(MonomialOrder::elimination({0})), system, run);
            const Ring two(field, {"y", "z"});
            std::vector<Polynomial> expected;
            for (const Polynomial& f : eliminated)
                if (f.exponent(0, 0) == 0)
                    expected.push_back(f.in_ring(two, std::vector<std::size_t>{~std::size_t{0}, 0, 1}));
            EXPECT_EQ(change_order(basis, two, Proof::full, run)->elements, expected) << p << ' ' << round;
            const Ring one(field, {"y"});
            const auto univariate = change_order(basis, one, Proof::full, run)->elements;
            ASSERT_EQ(univariate.size(), 1U);
            EXPECT_TRUE(normal_form(univariate.front().in_ring(source), basis, run).is_zero());
        }
    }
}

TEST(ChangeOfOrder, ClassicalSystemsOverTheRationals) {
    base::Run run;
    for (const auto& [name, expected_size] : {std::pair{"cyclic5", 11}, {"cyclic6", 17}, {"eco8", 8}}) {
        const auto system = classical_system(name, CoefficientField::rationals(), run).polynomials;
        const Ring source = system.front().ring();
        const auto basis = basis_of(source, system, run);
        const Ring target = source.with_order(MonomialOrder::lex());
        const auto proved = change_order(basis, target, Proof::full, run);
        const auto probable = change_order(basis, target, Proof::none, run);
        EXPECT_EQ(static_cast<int>(proved->elements.size()), expected_size) << name;
        EXPECT_EQ(proved->elements, probable->elements) << name;
        EXPECT_LE(probable->primes, proved->primes) << name;
        EXPECT_TRUE(is_reduced_groebner(proved->elements, run)) << name;
        for (const Polynomial& f : system)
            EXPECT_TRUE(normal_form(f.in_ring(target), proved->elements, run).is_zero()) << name;
    }
}

TEST(ChangeOfOrder, IdealsThatAreNotOfDimensionZeroAreLeftAlone) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    const Ring lex = ring.with_order(MonomialOrder::lex());
    EXPECT_FALSE(change_order(parsed(ring, {"x^2-y"}), lex, Proof::full, run));
    EXPECT_FALSE(change_order({}, lex, Proof::full, run));
    const auto unit = change_order(parsed(ring, {"1"}), lex, Proof::full, run);
    ASSERT_TRUE(unit);
    EXPECT_EQ(unit->elements, parsed(lex, {"1"}));
}

// Primes that lead astray, made of those that are tried first.
TEST(ChangeOfOrder, BadPrimes) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    const Ring lex = ring.with_order(MonomialOrder::lex());
    const std::uint64_t second_prime = algebra::previous_prime(first_prime);
    const std::string both = "(" + std::to_string(first_prime) + "*" + std::to_string(second_prime) + ")";
    // The prime divides a leading coefficient of the basis.
    const auto leading = basis_of(ring, parsed(ring, {both + "*x^2-y-1", "y^2-x"}), run);
    EXPECT_EQ(change_order(leading, lex, Proof::full, run)->elements, basis_of(lex, leading, run));
    // Over ℚ x is a multiple of y²; modulo the primes y² vanishes, and other monomials are standard.
    const auto standard = basis_of(ring, parsed(ring, {"y^2-" + both + "*x", "x^2-1"}), run);
    const auto changed = change_order(standard, lex, Proof::full, run);
    EXPECT_EQ(changed->elements, basis_of(lex, standard, run));
    EXPECT_EQ(changed->elements.size(), 2U);
    // A coefficient vanishes modulo the prime.
    const auto tail = basis_of(ring, parsed(ring, {"y^2-x+" + both, "x^2-3*x+1"}), run);
    EXPECT_EQ(change_order(tail, lex, Proof::none, run)->elements, basis_of(lex, tail, run));
}

TEST(ChangeOfOrder, DoesNotDependOnTheNumberOfThreads) {
    base::Run run;
    const auto system = classical_system("eco8", CoefficientField::rationals(), run).polynomials;
    const Ring source = system.front().ring();
    const auto basis = basis_of(source, system, run);
    const Ring target = source.with_order(MonomialOrder::lex());
    const auto expected = change_order(basis, target, Proof::full, run)->elements;
    RunOptions options;
    options.threads = 3;
    base::Run threaded(std::move(options));
    EXPECT_EQ(change_order(basis, target, Proof::full, threaded)->elements, expected);
}

TEST(ChangeOfOrder, StopsSoonWhenAsked) {
    base::Run preparation;
    const auto system = classical_system("katsura7", CoefficientField::rationals(), preparation).polynomials;
    const Ring source = system.front().ring();
    groebner::BuchbergerOptions options;
    options.proof = Proof::none;
    const auto basis = buchberger(source, system, options, preparation).elements;
    for (const int milliseconds : {5, 300}) {
        base::Run run;
        std::chrono::steady_clock::time_point asked;
        std::jthread stopper([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
            asked = std::chrono::steady_clock::now();
            run.request_stop();
        });
        EXPECT_THROW(change_order(basis, source.with_order(MonomialOrder::lex()), Proof::full, run), Stopped);
        stopper.join();
        EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(2));
    }
}

// The proofs must notice what they are there for.
class ProofsOfLiftedBases : public ::testing::Test {
  protected:
    ProofsOfLiftedBases()
        : ring_(CoefficientField::rationals(), {"x", "y"}),
          basis_(basis_of(ring_, parsed(ring_, {"3*x^2+x*y-y+5", "y^2-2*x+7*y-1"}), run_)),
          staircase_(*groebner::Staircase::of(basis_, 100, run_)), quotient_(staircase_, basis_, run_) {
        const Ring lex = ring_.with_order(MonomialOrder::lex());
        const algebra::PrimeField field(first_prime);
        groebner::QuotientAlgebra algebra(staircase_, basis_, field, run_);
        image_ = groebner::convert(algebra, lex, variables_, true, run_);
        std::vector<std::size_t> sizes(image_.tails.size() + image_.numerators.size(),
                                       image_.standard.size());
        algebra::RationalLifting lifting(sizes);
        for (std::uint64_t p = first_prime; !(lifting.prime_count() > 3 && lifting.lift(run_));
             p = algebra::previous_prime(p)) {
            const algebra::PrimeField next(p);
            groebner::QuotientAlgebra other(staircase_, basis_, next, run_);
            const auto converted = groebner::convert(other, lex, variables_, true, run_);
            std::vector<std::uint32_t> residues;
            for (const auto* part : {&converted.tails, &converted.numerators})
                for (const auto& v : *part) residues.insert(residues.end(), v.begin(), v.end());
            lifting.add(static_cast<std::uint32_t>(p), residues);
        }
        vectors_ = lifting.take_vectors();
    }

    groebner::LiftedBasis candidate() const {
        const std::span all(vectors_);
        return {image_.standard, image_.leads, all.first(2), all.subspan(2)};
    }

    base::Run run_;
    Ring ring_;
    std::vector<Polynomial> basis_;
    groebner::Staircase staircase_;
    groebner::RationalQuotient quotient_;
    std::vector<std::size_t> variables_ = {0, 1};
    groebner::ConvertedBasis image_;
    std::vector<algebra::RationalLifting::Vector> vectors_;
};

TEST_F(ProofsOfLiftedBases, AcceptWhatIsRight) {
    ASSERT_EQ(image_.numerators.size(), 2U) << "not in shape position";
    EXPECT_TRUE(groebner::is_in_ideal(candidate(), quotient_, variables_, run_));
    EXPECT_TRUE(groebner::ShapeProof::follows(candidate(), run_));
    const std::vector<std::size_t> others = {0};
    EXPECT_TRUE(groebner::ShapeProof(quotient_, 1, others, run_).modulus_bits_needed(candidate()));
}

TEST_F(ProofsOfLiftedBases, RejectEveryChangedCoefficient) {
    for (std::size_t v = 0; v < 2; ++v) {
        for (algebra::Integer& n : vectors_[v].numerators) {
            const algebra::Integer right = n;
            n += algebra::Integer(1);
            EXPECT_FALSE(groebner::is_in_ideal(candidate(), quotient_, variables_, run_));
            EXPECT_FALSE(groebner::ShapeProof::follows(candidate(), run_));
            n = right;
        }
    }
    // A denominator that cannot be.
    vectors_[0].denominator *= algebra::Integer(1000003);
    const std::vector<std::size_t> others = {0};
    EXPECT_FALSE(groebner::ShapeProof(quotient_, 1, others, run_).modulus_bits_needed(candidate()));
}

// The bound that the proof rests on holds for what it bounds, and is not much larger than need be.
TEST_F(ProofsOfLiftedBases, TheBoundCoversTheCharacteristicPolynomial) {
    const std::vector<std::size_t> others = {0};
    const auto needed = groebner::ShapeProof(quotient_, 1, others, run_).modulus_bits_needed(candidate());
    std::size_t largest = 0;
    for (const auto& n : vectors_[0].numerators) largest = std::max(largest, n.bit_length());
    EXPECT_GT(*needed, static_cast<double>(largest));
    EXPECT_LT(*needed, 400);
}

TEST(QuotientAlgebra, MultiplicationAgreesWithNormalForms) {
    Random random(5);
    base::Run run;
    const Ring ring(CoefficientField::prime(32003), {"x", "y", "z"});
    for (int round = 0; round < 10; ++round) {
        const auto basis = basis_of(ring, random_system(ring, random, 4), run);
        const auto staircase = groebner::Staircase::of(basis, 100, run);
        ASSERT_TRUE(staircase);
        groebner::QuotientAlgebra algebra(*staircase, basis, ring.field().prime_field(), run);
        const Polynomial f = eliminant::testing::random_small(ring, random, 20, 8);
        // f's vector, from its monomials by multiplication alone.
        groebner::QuotientAlgebra::Vector sum(algebra.size(), 0);
        for (std::size_t t = 0; t < f.size() && algebra.size() > 0; ++t) {
            auto v = algebra.unit(0);
            for (std::size_t i = 0; i < 3; ++i)
                for (std::uint64_t e = 0; e < f.exponent(t, i); ++e) v = algebra.times_variable(i, v);
            const auto c = f.residue_terms().coefficients[t];
            for (std::size_t b = 0; b < sum.size(); ++b)
                sum[b] = algebra.field().add(sum[b], algebra.field().multiply(c, v[b]));
        }
        const Polynomial reduced = normal_form(f, basis, run);
        std::size_t nonzero = 0;
        for (const auto s : sum) nonzero += s != 0 ? 1 : 0;
        EXPECT_EQ(nonzero, reduced.size());
        for (std::size_t t = 0; t < reduced.size(); ++t) {
            const auto index = staircase->index_of(reduced.monomial(t).exponents());
            ASSERT_NE(index, groebner::Staircase::none);
            EXPECT_EQ(sum[index], reduced.residue_terms().coefficients[t]);
        }
        // A form pulled back and applied is the form applied to the product.
        if (algebra.size() == 0) continue;
        groebner::QuotientAlgebra::Vector form(algebra.size());
        for (auto& c : form) c = static_cast<std::uint32_t>(random() % 32003);
        EXPECT_EQ(algebra.apply(algebra.pull_back(1, form), sum),
                  algebra.apply(form, algebra.times_variable(1, sum)));
    }
}

TEST(ResidueKernels, AgreeWithThePortableOnes) {
    Random random(6);
    for (const std::uint64_t p : {3U, 32003U, 2147483647U}) {
        for (const std::size_t n : {0U, 1U, 7U, 8U, 33U, 1000U}) {
            std::vector<std::uint32_t> a(n);
            std::vector<std::uint32_t> b(n);
            std::vector<std::uint64_t> start(n);
            for (std::size_t i = 0; i < n; ++i) {
                a[i] = static_cast<std::uint32_t>(random() % 2 == 0 ? p - 1 : random() % p);
                b[i] = static_cast<std::uint32_t>(random() % 2 == 0 ? p - 1 : random() % p);
                start[i] = random() % (p * p);
            }
            const auto factor = static_cast<std::uint32_t>(random() % p);
            base::UInt128 dot = 0;
            for (std::size_t i = 0; i < n; ++i) dot += base::UInt128{a[i]} * b[i];
            for (const base::VectorUnit unit : base::available_vector_units()) {
                const groebner::ResidueKernels& kernels = groebner::residue_kernels(unit);
                const auto sum = kernels.dot(a.data(), b.data(), n);
                EXPECT_TRUE((base::UInt128{sum.high} << 32) + sum.low == dot) << base::name(unit);
                std::vector<std::uint64_t> v = start;
                kernels.subtract_multiple(v.data(), a.data(), n, factor, p * p);
                for (std::size_t i = 0; i < n; ++i) {
                    EXPECT_LT(v[i], p * p);
                    EXPECT_EQ(v[i] % p, (start[i] % p + p - factor * std::uint64_t{a[i]} % p) % p)
                        << base::name(unit);
                }
            }
        }
    }
}

} // namespace
