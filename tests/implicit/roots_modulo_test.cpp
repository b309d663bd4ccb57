// Roots modulo primes: those of products of known factors, and all of them.
#include "implicit/roots_modulo.hpp"

#include "algebra/univariate_mod_p.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace eliminant::implicit {
namespace {

namespace dense = algebra::dense;

TEST(Roots, OfEveryPolynomialOfSmallDegreeModuloSmallPrimes) {
    base::Run run;
    algebra::Random random(1);
    std::mt19937_64 numbers(4);
    for (const std::uint32_t p : {3U, 5U, 7U, 17U, 97U, 193U}) { // p − 1 divisible by 2, 4, 16, 32, 64
        const algebra::PrimeField field(p);
        for (int round = 0; round < 200; ++round) {
            dense::Vector f(2 + static_cast<std::size_t>(round) % 5);
            for (auto& c : f) c = static_cast<std::uint32_t>(numbers() % p);
            dense::trim(f);
            if (f.empty()) continue;
            std::vector<std::uint32_t> expected;
            for (std::uint32_t x = 0; x < p; ++x)
                if (dense::evaluate<algebra::PrimeField>(field, f, x) == 0) expected.push_back(x);
            std::vector<std::uint32_t> found = roots(field, f, random, run);
            std::ranges::sort(found);
            EXPECT_EQ(found, expected) << p << ", round " << round;
        }
    }
}

TEST(Roots, OfProductsOfLinearFactorsModuloLargePrimes) {
    base::Run run;
    algebra::Random random(1);
    for (const std::uint32_t p : {536870909U, 998244353U, 2147483647U}) {
        const algebra::PrimeField field(p);
        for (std::uint32_t count = 1; count <= 6; ++count) {
            dense::Vector f = {7};
            std::vector<std::uint32_t> expected;
            for (std::uint32_t i = 0; i < count; ++i) {
                expected.push_back(p - 1 - 1000003 * i);
                dense::multiply_by_root(field, f, expected.back());
            }
            std::vector<std::uint32_t> found = roots(field, f, random, run);
            std::ranges::sort(found);
            std::ranges::sort(expected);
            EXPECT_EQ(found, expected) << p;
        }
    }
}

} // namespace
} // namespace eliminant::implicit
