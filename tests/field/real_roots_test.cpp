#include "eliminant/field/real_roots.hpp"

#include "support/sturm.hpp"

#include "eliminant/base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace eliminant::field {
namespace {

using Integers = std::vector<mpz_class>;

Integers product(const Integers& a, const Integers& b) {
    Integers result(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
    return result;
}

/// ∏ (denominator·t − numerator)^multiplicity.
struct Root {
    long numerator;
    long denominator;
    unsigned multiplicity;
};
Integers with_roots(const std::vector<Root>& roots) {
    Integers p{1};
    for (const Root& root : roots)
        for (unsigned i = 0; i < root.multiplicity; ++i) p = product(p, {-root.numerator, root.denominator});
    return p;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(RealRoots, KnownRootsWithMultiplicities) {
    base::Run run;
    const Integers p = with_roots({{-1, 2, 1}, {1, 3, 2}, {1, 1, 3}, {7, 4, 1}, {100, 1, 1}});
    const auto roots = real_roots(p, -1.0, 2.0, run);
    ASSERT_EQ(roots.size(), 4U);
    EXPECT_DOUBLE_EQ(roots[0].value, -0.5);
    EXPECT_DOUBLE_EQ(roots[1].value, 1.0 / 3.0);
    EXPECT_DOUBLE_EQ(roots[2].value, 1.0);
    EXPECT_DOUBLE_EQ(roots[3].value, 1.75);
    EXPECT_EQ(roots[1].multiplicity, 2U);
    EXPECT_EQ(roots[2].multiplicity, 3U);
    // Degree 8, positive leading coefficient: positive before everything.
    EXPECT_EQ(roots[0].sign_before, 1);
    EXPECT_EQ(roots[1].sign_before, -1);
    EXPECT_EQ(roots[2].sign_before, -1);
    EXPECT_EQ(roots[3].sign_before, 1);
    const auto first = first_real_root(p, 0.0, 2.0, run);
    ASSERT_TRUE(first);
    EXPECT_DOUBLE_EQ(first->value, 1.0 / 3.0);
    EXPECT_EQ(first->multiplicity, 2U);
}

TEST(RealRoots, TheIntervalIsClosed) {
    base::Run run;
    const Integers p = with_roots({{0, 1, 1}, {1, 1, 2}});
    const auto roots = real_roots(p, 0.0, 1.0, run);
    ASSERT_EQ(roots.size(), 2U);
    EXPECT_EQ(roots[0].value, 0.0);
    EXPECT_EQ(roots[0].sign_before, -1);
    EXPECT_EQ(roots[1].value, 1.0);
    EXPECT_EQ(roots[1].multiplicity, 2U);
    EXPECT_TRUE(real_roots(p, std::nextafter(0.0, 1.0), std::nextafter(1.0, 0.0), run).empty());
    const auto point = real_roots(p, 1.0, 1.0, run);
    ASSERT_EQ(point.size(), 1U);
    EXPECT_EQ(point[0].multiplicity, 2U);
    EXPECT_EQ(point[0].sign_before, 1);
    EXPECT_TRUE(real_roots(p, 0.5, 0.5, run).empty());
    EXPECT_TRUE(real_roots(p, 1.0, 0.0, run).empty());
}

TEST(RealRoots, UnboundedIntervals) {
    base::Run run;
    const Integers p = with_roots({{-3, 1, 1}, {1000000007, 1, 1}});
    const auto roots = real_roots(p, -5.0, infinity, run);
    ASSERT_EQ(roots.size(), 2U);
    EXPECT_EQ(roots[0].value, -3.0);
    EXPECT_EQ(roots[1].value, 1000000007.0);
    EXPECT_TRUE(real_roots(Integers{1, 0, 1}, -1e300, infinity, run).empty());
    EXPECT_TRUE(real_roots(Integers{5}, 0.0, infinity, run).empty());
}

TEST(RealRoots, SmallAndLargeScales) {
    base::Run run;
    // t = 2^-1000 within [0, 1], and within [0, 1e300].
    Integers p{-1, mpz_class(1) << 1000};
    for (const double upper : {1.0, 1e300}) {
        const auto roots = real_roots(p, 0.0, upper, run);
        ASSERT_EQ(roots.size(), 1U);
        EXPECT_EQ(roots[0].value, 0x1p-1000);
    }
}

TEST(RealRoots, ClustersNearerThanDoublesCanTell) {
    base::Run run;
    // 3·10^40·t = 10^40 + i for i = 0, 1, 2: three roots that round to one double, and a near miss.
    mpz_class large;
    mpz_ui_pow_ui(large.get_mpz_t(), 10, 40);
    Integers p{1};
    for (int i = 0; i < 3; ++i) p = product(p, {-(large + i), 3 * large});
    EXPECT_EQ(real_roots(p, 0.0, 1.0, run).size(), 3U);
    const Integers square = product({-large, 3 * large}, {-large, 3 * large});
    EXPECT_EQ(real_roots(square, 0.0, 1.0, run).size(), 1U);
    Integers lifted = square;
    lifted[0] += 1;
    EXPECT_TRUE(real_roots(lifted, 0.0, 1.0, run).empty());
    lifted[0] -= 2;
    EXPECT_EQ(real_roots(lifted, 0.0, 1.0, run).size(), 2U);
}

TEST(RealRoots, AgreeWithSturmOnRandomPolynomials) {
    const unsigned seed = 20240611;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    base::Run run;
    for (int round = 0; round < 400; ++round) {
        Integers p{1};
        const int factors = 1 + static_cast<int>(random() % 4);
        for (int i = 0; i < factors; ++i) {
            Integers factor(2 + random() % 3);
            for (mpz_class& c : factor) c = static_cast<long>(random() % 21) - 10;
            if (factor.back() == 0) factor.back() = 1;
            p = product(p, factor);
            if (random() % 3 == 0) p = product(p, factor);
        }
        const double lower = static_cast<double>(random() % 64) / 16.0 - 3.0;
        const double upper = lower + static_cast<double>(random() % 64) / 16.0;
        const test::SturmSequence sturm(test::rational(p));
        const auto roots = real_roots(p, lower, upper, run);
        ASSERT_EQ(static_cast<int>(roots.size()), sturm.roots(mpq_class(lower), mpq_class(upper)))
            << "round " << round;
        const auto first = first_real_root(p, lower, upper, run);
        ASSERT_EQ(first.has_value(), !roots.empty());
        if (first) {
            EXPECT_DOUBLE_EQ(first->value, roots[0].value);
        }
        for (const RealRoot& root : roots) {
            const mpq_class near(1, 1000000000);
            const mpq_class value(root.value);
            EXPECT_GE(sturm.roots(value - near, value + near), 1) << "round " << round;
        }
    }
}

TEST(RealRoots, Errors) {
    base::Run run;
    EXPECT_THROW(real_roots(Integers{}, 0.0, 1.0, run), base::DomainError);
    EXPECT_THROW(real_roots(Integers{0, 0}, 0.0, 1.0, run), base::DomainError);
    EXPECT_THROW(real_roots(Integers{1, 1}, std::nan(""), 1.0, run), base::DomainError);
    EXPECT_THROW(real_roots(Integers{1, 1}, 0.0, std::nan(""), run), base::DomainError);
    EXPECT_THROW(real_roots(Integers{1, 1}, -infinity, 0.0, run), base::DomainError);
}

} // namespace
} // namespace eliminant::field
