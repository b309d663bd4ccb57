// The floating-point search against exact roots: whatever it decides must be so.
#include "field/beam_rows.hpp"
#include "field/first_root.hpp"

#include "eliminant/field/real_roots.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace eliminant::field {
namespace {

/// Doubles times 2^1100, which makes integers of all that occur here.
std::vector<mpz_class> exact(std::span<const double> p) {
    std::vector<mpz_class> result;
    for (const double c : p) {
        mpq_class scaled(c);
        mpz_mul_2exp(scaled.get_num_mpz_t(), scaled.get_num_mpz_t(), 1100);
        scaled.canonicalize();
        result.emplace_back(scaled.get_num());
        EXPECT_EQ(scaled.get_den(), 1);
    }
    return result;
}

/// Random polynomials on [−1, 1], many with roots there that are close, double or nearly so.
class Polynomials {
  public:
    explicit Polynomials(unsigned seed) : random_(seed) {}

    std::vector<double> next(std::size_t degree) {
        std::vector<double> p{uniform()};
        while (p.size() <= degree) {
            const double root = uniform() * 1.2;
            const auto kind = random_() % 4;
            if (kind == 0 && p.size() + 2 <= degree + 1) {
                // (t − a)² ± tiny²
                const double tiny = std::ldexp(uniform(), -static_cast<int>(random_() % 50));
                multiply(p,
                         {root * root + (random_() % 2 == 0 ? tiny * tiny : -tiny * tiny), -2.0 * root, 1.0});
            } else if (kind == 1 && p.size() + 2 <= degree + 1) {
                multiply(p, {1.0 + uniform(), uniform(), 1.0});
            } else {
                multiply(p, {-root, 1.0});
            }
        }
        return p;
    }
    double uniform() { return std::uniform_real_distribution<>(-1.0, 1.0)(random_); }

  private:
    static void multiply(std::vector<double>& p, const std::vector<double>& q) {
        std::vector<double> result(p.size() + q.size() - 1);
        for (std::size_t i = 0; i < p.size(); ++i)
            for (std::size_t j = 0; j < q.size(); ++j) result[i + j] += p[i] * q[j];
        p = result;
    }
    std::mt19937_64 random_;
};

void expect_right(const FirstRootAnswer& answer, const std::optional<RealRoot>& truth,
                  const std::string& what) {
    if (answer.state == RayState::undecided) return;
    ASSERT_EQ(answer.state == RayState::root, truth.has_value()) << what;
    if (!truth) return;
    EXPECT_EQ(truth->multiplicity, 1U) << what;
    EXPECT_NEAR(answer.root, truth->value, 2.0 * root_precision) << what;
    if (answer.side != 0) {
        EXPECT_EQ(answer.side, truth->sign_before) << what;
    }
}

TEST(FirstRoot, NeverContradictsExactArithmetic) {
    const unsigned seed = 7;
    Polynomials polynomials(seed);
    base::Run run;
    int decided = 0;
    int decided_wide = 0;
    constexpr int rounds = 1500;
    for (int round = 0; round < rounds; ++round) {
        const std::size_t degree = 1 + static_cast<std::size_t>(round) % 18;
        const auto p = polynomials.next(degree);
        double lower = polynomials.uniform();
        double upper = polynomials.uniform();
        if (lower > upper) std::swap(lower, upper);
        const auto truth = first_real_root(exact(p), lower, upper, run);
        const std::string what = "seed " + std::to_string(seed) + ", round " + std::to_string(round);
        // A root beyond an end by less than the margin of the pieces may be taken for one within.
        const auto beyond = first_real_root(exact(p), lower - 0x1p-48, upper + 0x1p-48, run);
        if (truth.has_value() != beyond.has_value()) continue;
        const FirstRootAnswer answer = first_root(p, 0.0, lower, upper);
        decided += answer.state != RayState::undecided ? 1 : 0;
        expect_right(answer, truth, what);
        const std::vector<DoubleDouble> wide(p.begin(), p.end());
        const FirstRootAnswer wide_answer = first_root(wide, 0.0, lower, upper);
        decided_wide += wide_answer.state != RayState::undecided ? 1 : 0;
        expect_right(wide_answer, truth, what + " (wide)");
    }
    EXPECT_GT(decided, rounds * 3 / 5);
    EXPECT_GT(decided_wide, decided);
}

TEST(FirstRoot, WhatIsSmallerThanTheErrorIsNotDecided) {
    const std::vector<double> p{0x1p-30, 0.0, 1.0}; // no root, but one if the constant is off by 2^-29
    EXPECT_EQ(first_root(p, 0.0, -1.0, 1.0).state, RayState::no_root);
    EXPECT_EQ(first_root(p, 0x1p-29, -1.0, 1.0).state, RayState::undecided);
    const std::vector<double> touching{0.25, -1.0, 1.0};
    EXPECT_EQ(first_root(touching, 0.0, -1.0, 1.0).state, RayState::undecided);
}

TEST(FirstRoot, AnEmptyIntervalHasNoRoot) {
    const std::vector<double> p{0.0, 1.0};
    EXPECT_EQ(first_root(p, 0.0, 0.5, -0.5).state, RayState::no_root);
}

TEST(FirstRootBatch, EveryVectorUnitAgreesWithExactArithmetic) {
    base::Run run;
    for (const base::VectorUnit unit : base::available_vector_units())
        for (std::size_t degree = 1; degree <= 12; ++degree) {
            const unsigned seed = static_cast<unsigned>(degree);
            Polynomials polynomials(seed);
            constexpr std::size_t count = 64;
            std::vector<std::vector<double>> all;
            std::vector<double> coefficients((degree + 1) * count);
            double largest = 0.0;
            for (std::size_t i = 0; i < count; ++i) {
                all.push_back(polynomials.next(degree));
                double sum = 0.0;
                for (std::size_t k = 0; k <= degree; ++k) {
                    coefficients[k * count + i] = all[i][k];
                    sum += std::abs(all[i][k]);
                }
                largest = std::max(largest, sum);
            }
            std::vector<double> lower(count, -1.0);
            std::vector<double> upper(count, 1.0);
            lower[3] = 2.0; // one lane has nothing to do
            std::vector<double> root(count);
            std::vector<RayState> state(count);
            first_root_solver(unit)({.degree = degree,
                                     .count = count,
                                     .coefficients = coefficients.data(),
                                     .bernstein = bernstein_matrix(degree),
                                     .error = first_root_rounding(degree) * 0x1p-53 * largest,
                                     .lower = lower.data(),
                                     .upper = upper.data(),
                                     .root = root.data(),
                                     .state = state.data()});
            EXPECT_EQ(state[3], RayState::no_root);
            for (std::size_t i = 0; i < count; ++i) {
                if (i == 3) continue;
                const std::string what = std::string(name(unit)) + ", degree " + std::to_string(degree) +
                                         ", polynomial " + std::to_string(i);
                expect_right({state[i], root[i], 0, 0}, first_real_root(exact(all[i]), -1.0, 1.0, run), what);
            }
        }
}

} // namespace
} // namespace eliminant::field
