#pragma once

#include "eliminant/algebra/arithmetic.hpp"

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace eliminant::testing {

/// Rings in three variables x, y, z: small and large fields, every kind of order.
inline std::vector<Ring> sample_rings() {
    const std::vector<std::string> names = {"x", "y", "z"};
    std::vector<Ring> rings;
    for (const auto& field :
         {CoefficientField::rationals(), CoefficientField::prime(2), CoefficientField::prime(3),
          CoefficientField::prime(101), CoefficientField::prime(2147483647)}) {
        rings.emplace_back(field, names, MonomialOrder::lex());
        rings.emplace_back(field, names, MonomialOrder::deglex());
        rings.emplace_back(field, names, MonomialOrder::degrevlex());
        rings.emplace_back(field, names, MonomialOrder::weighted({1, 2, 3}, MonomialOrder::TieBreak::lex));
        rings.emplace_back(field, names, MonomialOrder::weighted({3, 1, 2}, MonomialOrder::TieBreak::revlex));
        rings.emplace_back(field, names, MonomialOrder::elimination({1}));
        rings.emplace_back(field, names, MonomialOrder::matrix({{1, 1, 1}, {0, -1, 2}, {0, 0, -5}}));
    }
    return rings;
}

/// The same fields, one order.
inline std::vector<Ring> sample_fields(const std::vector<std::string>& names = {"x", "y", "z"}) {
    std::vector<Ring> rings{{CoefficientField::rationals(), names}};
    for (const std::uint64_t p : {2U, 3U, 5U, 101U, 65537U, 2147483647U})
        rings.emplace_back(CoefficientField::prime(p), names);
    return rings;
}

/// A sum of random terms, coefficients at most `height` in size, over ℚ every fourth one a fraction; it may
/// be 0.
inline Polynomial random_polynomial(const Ring& ring, std::mt19937_64& random, std::size_t terms,
                                    std::uint64_t max_exponent, std::uint64_t height = 20) {
    PolynomialBuilder builder(ring);
    std::vector<std::uint64_t> exponents(ring.variable_count());
    for (std::size_t i = 0; i < terms; ++i) {
        for (auto& e : exponents) e = random() % (max_exponent + 1);
        const auto numerator =
            static_cast<std::int64_t>(random() % (2 * height + 1)) - static_cast<std::int64_t>(height);
        const bool fraction = ring.field().is_rationals() && random() % 4 == 0;
        builder.add(Integer(numerator), Integer(fraction ? 1 + static_cast<std::int64_t>(random() % 9) : 1),
                    exponents);
    }
    return builder.build();
}

/// The same, but not 0.
inline Polynomial random_nonzero(const Ring& ring, std::mt19937_64& random, std::size_t terms,
                                 std::uint64_t max_exponent, std::uint64_t height = 20) {
    while (true) {
        Polynomial f = random_polynomial(ring, random, terms, max_exponent, height);
        if (!f.is_zero()) return f;
    }
}

} // namespace eliminant::testing
