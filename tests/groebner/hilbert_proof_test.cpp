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
            generators.push_back(eliminant::testing::random_small(ring, random, 4, 3));
        graded = buchberger(ring, generators, {}, run).elements;
        std::vector<Polynomial> homogeneous;
        for (const Polynomial& f : graded) homogeneous.push_back(homogenize(f.in_ring(extended), 3));
        candidate = buchberger(extended, homogeneous, {}, run).elements;
    }
    bool accepts() { return is_basis_of_homogenization(candidate, 3, graded, run); }

    base::Run run;
    Ring ring{CoefficientField::rationals(), {"x", "y", "z"}};
    Ring extended{CoefficientField::rationals(), {"x", "y", "z", "h"}, MonomialOrder::elimination({0})};
    std::vector<Polynomial> graded;
    std::vector<Polynomial> candidate;
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
        if (candidate.empty()) continue;
        candidate.erase(candidate.begin() + static_cast<std::ptrdiff_t>(random() % candidate.size()));
        EXPECT_FALSE(accepts()) << "round " << round;
    }
}

TEST_F(HilbertProof, RejectsAChangedCoefficient) {
    Random random(33);
    int changed = 0;
    for (int round = 0; round < 20; ++round) {
        choose(random);
        for (Polynomial& f : candidate) {
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
    ASSERT_FALSE(candidate.empty());
    candidate.front() += Polynomial::constant(extended, 1);
    EXPECT_FALSE(accepts());
}

} // namespace
