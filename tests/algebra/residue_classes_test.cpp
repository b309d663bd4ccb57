// Powers modulo a polynomial agree with products and remainders.
#include "algebra/residue_classes.hpp"

#include <gtest/gtest.h>

#include <random>

namespace eliminant::algebra::dense {
namespace {

Vector slow_power(const PrimeField& field, const Vector& base, unsigned exponent, const Vector& f) {
    Vector result = {1};
    for (unsigned i = 0; i < exponent; ++i) {
        result = multiply(field, result, base);
        divide(field, result, f);
    }
    return result;
}

TEST(ResidueClasses, PowersAgreeWithRepeatedProducts) {
    std::mt19937_64 random(5);
    // Primes for which four, sixty-four and all products fit in a word.
    for (const std::uint64_t p : {2147483647U, 536870909U, 65537U, 3U, 2U}) {
        const PrimeField field(p);
        const auto element = [&] { return static_cast<Element>(random() % p); };
        for (std::size_t degree = 1; degree <= 40; degree += degree < 6 ? 1 : 17) {
            Vector f(degree + 1, 1);
            for (std::size_t i = 0; i < degree; ++i) f[i] = element();
            ResidueClasses classes(field, f);
            for (const unsigned exponent : {1U, 2U, 3U, 13U, 100U}) {
                Vector base(degree);
                for (Element& c : base) c = element();
                trim(base);
                EXPECT_EQ(classes.power(base, exponent), slow_power(field, base, exponent, f))
                    << p << ", degree " << degree;
                const Element a = element();
                EXPECT_EQ(classes.power_of_linear(a, exponent), slow_power(field, {a, 1}, exponent, f))
                    << p << ", degree " << degree;
            }
        }
    }
}

} // namespace
} // namespace eliminant::algebra::dense
