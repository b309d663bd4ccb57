#include "groebner/hilbert_proof.hpp"

#include "eliminant/algebra/grading.hpp"
#include "eliminant/groebner/buchberger.hpp"
#include "eliminant/groebner/f4.hpp"
#include "groebner/f4_hilbert.hpp"
#include "support/random_ideals.hpp"

#include <gtest/gtest.h>

#include <string>

using namespace eliminant;
using eliminant::groebner::is_basis_of_homogenization;
using eliminant::testing::Random;

namespace {

class HilbertProof : public ::testing::Test {
  protected:
    /// The basis of an ideal in degrevlex, and that of its homogenisation in an elimination order.
    void choose(Random& random) {
        std::vector<Polynomial> generators;
        for (int i = 0; i < 2; ++i)
            generators.push_back(eliminant::testing::random_small(ring_, random, 4, 3));
        graded_ = buchberger(ring_, generators, {}, run_).elements;
        std::vector<Polynomial> homogeneous;
        for (const Polynomial& f : graded_) homogeneous.push_back(homogenize(f.in_ring(extended_), 3));
        candidate_ = buchberger(extended_, homogeneous, {}, run_).elements;
    }
    bool accepts() { return is_basis_of_homogenization(candidate_, 3, graded_, run_); }

    base::Run run_;
    Ring ring_{CoefficientField::rationals(), {"x", "y", "z"}};
    Ring extended_{CoefficientField::rationals(), {"x", "y", "z", "h"}, MonomialOrder::elimination({0})};
    std::vector<Polynomial> graded_;
    std::vector<Polynomial> candidate_;
};

TEST_F(HilbertProof, AcceptsBases) {
    Random random(31);
    for (int round = 0; round < 20; ++round) {
        choose(random);
        EXPECT_TRUE(accepts()) << "round " << round;
    }
}

TEST_F(HilbertProof, AKnownHilbertSeriesSavesReductionsAndChangesNothing) {
    Random random(35);
    std::uint64_t saved = 0;
    for (int round = 0; round < 12; ++round) {
        SCOPED_TRACE("round " + std::to_string(round));
        choose(random);
        std::vector<groebner::Exponents> leads = groebner::leading_exponents(graded_);
        for (groebner::Exponents& m : leads) m.push_back(0);
        const groebner::SparseSeries numerator = groebner::hilbert_numerator(leads, run_);
        groebner::BuchbergerOptions options;
        options.proof = groebner::Proof::none;
        for (const auto& field : {CoefficientField::rationals(), CoefficientField::prime(2147483647)}) {
            const Ring ring = extended_.with_field(field);
            std::vector<Polynomial> homogeneous;
            for (const Polynomial& f : graded_)
                homogeneous.push_back(homogenize(f.in_ring(extended_), 3).primitive_part().in_ring(ring));
            const GroebnerBasis plain = f4(ring, homogeneous, options, run_);
            const GroebnerBasis with_series =
                groebner::f4_with_hilbert_series(ring, homogeneous, options, &numerator, run_);
            EXPECT_EQ(with_series.elements, plain.elements);
            EXPECT_LE(with_series.statistics.pairs_treated, plain.statistics.pairs_treated);
            saved += plain.statistics.pairs_treated - with_series.statistics.pairs_treated;
        }
    }
    EXPECT_GT(saved, 0U);
}

TEST_F(HilbertProof, RejectsAMissingElement) {
    Random random(32);
    for (int round = 0; round < 20; ++round) {
        choose(random);
        if (candidate_.empty()) continue;
        candidate_.erase(candidate_.begin() + static_cast<std::ptrdiff_t>(random() % candidate_.size()));
        EXPECT_FALSE(accepts()) << "round " << round;
    }
}

TEST_F(HilbertProof, RejectsAChangedCoefficient) {
    Random random(33);
    int changed = 0;
    for (int round = 0; round < 20; ++round) {
        choose(random);
        for (Polynomial& f : candidate_) {
            if (f.size() < 2) continue;
            const Polynomial right = f;
            f += Polynomial::term(f.monomial(f.size() - 1), 1);
            EXPECT_FALSE(accepts()) << "round " << round;
            f = right;
            ++changed;
        }
    }
    EXPECT_GT(changed, 20);
}

TEST_F(HilbertProof, RejectsWhatIsNotHomogeneous) {
    Random random(34);
    choose(random);
    ASSERT_FALSE(candidate_.empty());
    candidate_.front() += Polynomial::constant(extended_, 1);
    EXPECT_FALSE(accepts());
}

} // namespace
