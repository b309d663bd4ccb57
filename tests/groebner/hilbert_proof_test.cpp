#include "groebner/hilbert_proof.hpp"

#include "eliminant/algebra/grading.hpp"
#include "eliminant/groebner/buchberger.hpp"
#include "support/random_ideals.hpp"

#include <gtest/gtest.h>

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
