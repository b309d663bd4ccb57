#include "eliminant/field/first_roots.hpp"

#include "eliminant/base/error.hpp"
#include "eliminant/field/real_roots.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace eliminant::field {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double first(const std::vector<double>& p, double lower = -1.0, double upper = 1.0) {
    base::Run run;
    double root = 0.0;
    first_roots({p.size() - 1, 1, p, {&lower, 1}, {&upper, 1}}, {&root, 1}, run);
    return root;
}

TEST(FirstRoots, SpecialPolynomials) {
    EXPECT_EQ(first({0.0}), -1.0);
    EXPECT_EQ(first({0.0, 0.0, 0.0}, 0.25), 0.25);
    EXPECT_EQ(first({3.0}), infinity);
    EXPECT_EQ(first({3.0, 0.0, 0.0}), infinity);
    EXPECT_EQ(first({0.25, -1.0, 1.0}), 0.5);                // (t − 1/2)²
    EXPECT_EQ(first({0.25 + 0x1p-54, -1.0, 1.0}), infinity); // without a root by the least there is
    EXPECT_EQ(first({1.0, 1.0}), -1.0);                      // at an end
    EXPECT_EQ(first({0.5, -1.0}, 0.5, 0.5), 0.5);
    EXPECT_EQ(first({0.5, -1.0}, 0.75, 1.0), infinity);
    EXPECT_EQ(first({0.5, -1.0}, 0.75, 0.25), infinity);
    EXPECT_NEAR(first({-1e-300, 3e-300}), 1.0 / 3.0, 1e-15);
    EXPECT_NEAR(first({-1e300, 3e300}), 1.0 / 3.0, 1e-15);
    std::vector<double> high(61);
    high[0] = -0x1p-30;
    high[60] = 1.0;
    EXPECT_NEAR(first(high, 0.0), std::exp2(-0.5), 1e-12); // beyond the degree of the kernels
}

TEST(FirstRoots, ManyPolynomialsOfVeryDifferentSizes) {
    const unsigned seed = 5;
    std::mt19937_64 random(seed);
    const auto uniform = [&random] { return std::uniform_real_distribution<>(-1.0, 1.0)(random); };
    base::Run run;
    for (std::size_t degree = 1; degree <= 7; ++degree) {
        const std::size_t count = 150; // not a multiple of any block
        std::vector<double> coefficients((degree + 1) * count);
        for (std::size_t i = 0; i < count; ++i) {
            const double size = std::ldexp(1.0, static_cast<int>(random() % 200) - 100);
            for (std::size_t k = 0; k <= degree; ++k) coefficients[k * count + i] = size * uniform();
        }
        std::vector<double> lower(count);
        std::vector<double> upper(count);
        for (std::size_t i = 0; i < count; ++i) {
            lower[i] = uniform();
            upper[i] = uniform();
        }
        std::vector<double> roots(count);
        first_roots({degree, count, coefficients, lower, upper}, roots, run);
        for (std::size_t i = 0; i < count; ++i) {
            std::vector<mpz_class> exact;
            for (std::size_t k = 0; k <= degree; ++k) {
                mpq_class c(coefficients[k * count + i]);
                mpz_mul_2exp(c.get_num_mpz_t(), c.get_num_mpz_t(), 400);
                c.canonicalize();
                exact.push_back(c.get_num());
            }
            const auto root = first_real_root(exact, lower[i], upper[i], run);
            ASSERT_EQ(root.has_value(), std::isfinite(roots[i])) << "seed " << seed << ", degree " << degree;
            if (root) {
                EXPECT_NEAR(roots[i], root->value, 2e-9) << "seed " << seed << ", degree " << degree;
            }
        }
    }
}

TEST(FirstRoots, Errors) {
    base::Run run;
    const std::vector<double> p{1.0, 2.0};
    const std::vector<double> bound{0.0};
    std::vector<double> root(1);
    EXPECT_THROW(first_roots({2, 1, p, bound, bound}, root, run), base::DomainError);
    EXPECT_THROW(first_roots({1, 1, p, {}, bound}, root, run), base::DomainError);
    EXPECT_THROW(first({1.0, std::nan("")}), base::DomainError);
    EXPECT_THROW(first({1.0, infinity}), base::DomainError);
    EXPECT_THROW(first({1.0, 1.0}, -1.5, 1.0), base::DomainError);
    EXPECT_THROW(first({1.0, 1.0}, std::nan(""), 1.0), base::DomainError);
}

} // namespace
} // namespace eliminant::field
