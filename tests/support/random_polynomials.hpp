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

/// Every kind of order on n ≥ 1 variables.
inline std::vector<MonomialOrder> every_order(std::size_t n, std::mt19937_64& random) {
    std::vector<std::uint64_t> weights(n);
    for (auto& w : weights) w = 1 + random() % 4;
    std::vector<std::vector<std::int64_t>> rows(n, std::vector<std::int64_t>(n, 0));
    for (std::size_t i = 0; i < n; ++i) {
        rows[0][i] = 1 + static_cast<std::int64_t>(random() % 3);
        if (i != 0) rows[i][n - i] = -1;
    }
    std::vector<MonomialOrder> orders = {
        MonomialOrder::lex(),
        MonomialOrder::deglex(),
        MonomialOrder::degrevlex(),
        MonomialOrder::weighted(weights, MonomialOrder::TieBreak::lex),
        MonomialOrder::weighted(weights, MonomialOrder::TieBreak::revlex),
        MonomialOrder::matrix(rows),
        MonomialOrder::elimination({n - 1}),
    };
    if (n > 2) orders.push_back(MonomialOrder::blocks({{1}, {0, 2}}));
    return orders;
}

inline std::vector<std::string> variable_names(std::size_t n) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < n; ++i) names.push_back(std::string("x").append(std::to_string(i + 1)));
    return names;
}

/// A random integer of exactly `bits` bits, or near a power of two, of either sign; 0 for no bits.
inline Integer random_integer(std::mt19937_64& random, unsigned bits) {
    if (bits == 0) return {};
    mpz_class value = 1;
    value <<= bits - 1;
    switch (random() % 4) {
    case 0:
        break; // 2^(bits−1)
    case 1:
        value = 2 * value - 1;
        break; // all ones
    case 2:
        value += bits > 2 ? 1 : 0;
        break; // 2^(bits−1) + 1
    default:
        for (unsigned i = 0; i + 1 < bits; ++i) {
            if (random() % 2 == 0) mpz_setbit(value.get_mpz_t(), i);
        }
    }
    if (random() % 2 == 0) value = -value;
    return Integer(value);
}

/// What random polynomials look like.
struct Shape {
    std::size_t terms = 10;
    std::uint64_t max_exponent = 5;
    std::uint64_t stride = 1; ///< exponents are multiples of it
    unsigned bits = 5;        ///< of the largest coefficient
    bool fractions = false;
};

inline Polynomial random_polynomial(const Ring& ring, std::mt19937_64& random, const Shape& shape) {
    PolynomialBuilder builder(ring);
    std::vector<std::uint64_t> exponents(ring.variable_count());
    for (std::size_t i = 0; i < shape.terms; ++i) {
        for (auto& e : exponents) e = random() % (shape.max_exponent / shape.stride + 1) * shape.stride;
        const auto bits = static_cast<unsigned>(random() % 3 == 0 ? random() % (shape.bits + 1) : shape.bits);
        const bool fraction = shape.fractions && ring.field().is_rationals() && random() % 3 == 0;
        builder.add(random_integer(random, bits), Integer(fraction ? 1 + static_cast<long>(random() % 9) : 1),
                    exponents);
    }
    return builder.build();
}

/// The same, but not 0.
inline Polynomial random_nonzero(const Ring& ring, std::mt19937_64& random, const Shape& shape) {
    for (;;) {
        Polynomial f = random_polynomial(ring, random, shape);
        if (!f.is_zero()) return f;
    }
}

} // namespace eliminant::testing
