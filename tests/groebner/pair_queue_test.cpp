#include "groebner/pair_queue.hpp"

#include "eliminant/algebra/parse.hpp"
#include "eliminant/algebra/ring.hpp"
#include "eliminant/base/error.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace eliminant;
using groebner::Basis;
using groebner::PairQueue;
using groebner::TermList;

namespace {

/// xᵃ·y⁽ⁿ⁻¹⁻ᵃ⁾ for a < n: every one has a pair with every other.
class PairQueueTest : public ::testing::Test {
  protected:
    static constexpr std::size_t n = 60;

    void append(std::size_t a) {
        const Ring two = ring_;
        const Polynomial f =
            algebra::parse_polynomial(two, "x^" + std::to_string(a) + "*y^" + std::to_string(n - 1 - a));
        TermList<std::uint32_t> terms = groebner::widened(f.residue_terms(), layout_);
        basis_.append(std::move(terms), n - 1, n - 1, 1);
    }

    Ring ring_{CoefficientField::prime(101), {"x", "y"}};
    const algebra::MonomialLayout& layout_ = ring_.layout(16);
    groebner::Grading grading_{{}};
    Basis<std::uint32_t> basis_{layout_};
    groebner::Statistics statistics_;
};

TEST_F(PairQueueTest, KeepsNeighboursOnly) {
    // lcm(xᵃyᵇ, xᶜyᵈ) is divided by that of any element between the two, so n − 1 pairs are left.
    base::Run run;
    PairQueue queue(groebner::Selection::normal, true, grading_, run);
    for (std::size_t a = 0; a < n; ++a) {
        append(a);
        queue.update(basis_, static_cast<std::uint32_t>(a), statistics_);
    }
    EXPECT_EQ(queue.size(), n - 1);
    EXPECT_EQ(queue.best_batch().size(), n - 1);
    EXPECT_EQ(statistics_.skipped_by_chain_m + statistics_.skipped_by_product, (n - 1) * (n - 2) / 2);
}

TEST_F(PairQueueTest, UpdateCanBeStopped) {
    base::Run run;
    PairQueue queue(groebner::Selection::normal, true, grading_, run);
    for (std::size_t a = 0; a < 3; ++a) append(a);
    queue.update(basis_, 1, statistics_);
    run.request_stop();
    EXPECT_THROW(queue.update(basis_, 2, statistics_), Stopped);
}

} // namespace
