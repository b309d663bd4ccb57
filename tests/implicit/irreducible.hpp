// Irreducibility over ℚ, proved by a section modulo a prime.
#pragma once

#include "eliminant/algebra/evaluation.hpp"

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace eliminant::implicit {

/// Univariate polynomials over GF(p), coefficients from the constant up, without leading zeros.
using Dense = std::vector<std::uint32_t>;

inline void trim(Dense& f) {
    while (!f.empty() && f.back() == 0) f.pop_back();
}

inline Dense remainder(Dense f, const Dense& g, const PrimeField& field) {
    const auto inverse = field.inverse(g.back());
    while (f.size() >= g.size()) {
        const auto factor = field.multiply(f.back(), inverse);
        for (std::size_t i = 0; i < g.size(); ++i) {
            auto& target = f[f.size() - g.size() + i];
            target = field.subtract(target, field.multiply(factor, g[i]));
        }
        trim(f);
    }
    return f;
}

inline Dense product_modulo(const Dense& a, const Dense& b, const Dense& modulus, const PrimeField& field) {
    Dense result(a.size() + b.size(), 0);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            result[i + j] = field.add(result[i + j], field.multiply(a[i], b[j]));
    trim(result);
    return remainder(std::move(result), modulus, field);
}

inline std::size_t gcd_degree(Dense f, Dense g, const PrimeField& field) {
    while (!g.empty()) {
        f = remainder(std::move(f), g, field);
        std::swap(f, g);
    }
    return f.size() - 1;
}

/// Rabin's test: f of degree d is irreducible iff it divides t^(p^d) − t and is coprime to t^(p^k) − t for
/// all 0 < k ≤ d/2.
inline bool is_irreducible(const Dense& f, const PrimeField& field) {
    const std::size_t d = f.size() - 1;
    if (d == 1) return true;
    const Dense t = {0, 1};
    Dense frobenius = t;
    for (std::size_t k = 1; k <= d / 2; ++k) {
        Dense power = {1}; // frobenius^p
        for (int bit = 31; bit-- > 0;) {
            power = product_modulo(power, power, f, field);
            if ((field.characteristic() >> bit & 1U) != 0) power = product_modulo(power, frobenius, f, field);
        }
        frobenius = std::move(power);
        Dense difference = frobenius;
        difference.resize(std::max<std::size_t>(difference.size(), 2), 0);
        difference[1] = field.subtract(difference[1], 1);
        trim(difference);
        if (gcd_degree(f, difference, field) != 0) return false;
    }
    return true;
}

/// The restriction of f to the line a + t·b, from its values at t = 0 … d (Newton's divided differences).
inline Dense section(const Polynomial& f, const PrimeField& field, const Dense& a, const Dense& b, Run& run) {
    const auto degree = static_cast<std::uint32_t>(f.total_degree());
    Dense values;
    for (std::uint32_t t = 0; t <= degree; ++t) {
        Dense point;
        for (std::size_t i = 0; i < a.size(); ++i) point.push_back(field.add(a[i], field.multiply(t, b[i])));
        values.push_back(evaluate(f, field, point, run));
    }
    for (std::uint32_t k = 1; k <= degree; ++k)
        for (std::uint32_t t = degree; t >= k; --t)
            values[t] = field.multiply(field.subtract(values[t], values[t - 1]), field.inverse(k));
    Dense result;
    for (std::uint32_t k = degree + 1; k-- > 0;) { // result = result·(t − k) + values[k]
        result.insert(result.begin(), 0);
        for (std::size_t i = 0; i + 1 < result.size(); ++i)
            result[i] = field.subtract(result[i], field.multiply(k, result[i + 1]));
        result[0] = field.add(result[0], values[k]);
    }
    trim(result);
    return result;
}

/// Whether a line was found on which f keeps its degree and is irreducible modulo p, which proves that f is
/// irreducible over ℚ. About one line in deg f has it, if f is absolutely irreducible.
inline bool is_proved_irreducible(const Polynomial& f, std::mt19937_64& random) {
    Run run;
    const PrimeField field(1000003);
    const auto degree = static_cast<std::size_t>(f.total_degree());
    for (std::size_t attempt = 0; attempt < 30 * degree; ++attempt) {
        Dense a;
        Dense b;
        for (std::size_t i = 0; i < f.ring().variable_count(); ++i) {
            a.push_back(static_cast<std::uint32_t>(random() % field.characteristic()));
            b.push_back(static_cast<std::uint32_t>(random() % field.characteristic()));
        }
        const Dense line = section(f, field, a, b, run);
        if (line.size() == degree + 1 && is_irreducible(line, field)) return true;
    }
    return false;
}

} // namespace eliminant::implicit
