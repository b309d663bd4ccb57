#include "implicit/verify_vanishing.hpp"

#include "base/parallel.hpp"
#include "implicit/verify_grid.hpp"

#include <algorithm>

namespace eliminant::implicit {

using algebra::Integer;
using algebra::Polynomial;
using algebra::PrimeField;

namespace {

mpz_class norm(const Polynomial& f) {
    mpz_class sum = 0;
    for (const Integer& c : f.integer_terms().coefficients) sum += abs(c.to_mpz());
    return sum;
}

std::uint64_t degree_over_denominator(const RationalMap& map, const Polynomial& f, std::size_t term) {
    std::uint64_t degree = 0;
    for (std::size_t i = 0; i < map.components.size(); ++i)
        if (map.components[i].over_denominator) degree += f.exponent(term, i);
    return degree;
}

/// max over the terms of f of Σ exponentᵢ·degreeᵢ, with f₀ in the place of what is missing to degree δ.
std::uint64_t greatest_degree(const RationalMap& map, const Polynomial& f, std::uint64_t delta,
                              const std::vector<std::uint64_t>& degrees, std::uint64_t of_denominator) {
    std::uint64_t greatest = 0;
    for (std::size_t term = 0; term < f.size(); ++term) {
        std::uint64_t degree = (delta - degree_over_denominator(map, f, term)) * of_denominator;
        for (std::size_t i = 0; i < degrees.size(); ++i) degree += f.exponent(term, i) * degrees[i];
        greatest = std::max(greatest, degree);
    }
    return greatest;
}

std::uint64_t degree_or_zero(std::int64_t degree) {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(degree, 0));
}

mpz_class power(const mpz_class& base, std::uint64_t exponent) {
    mpz_class result;
    mpz_pow_ui(result.get_mpz_t(), base.get_mpz_t(), exponent);
    return result;
}

mpz_class height_bound(const RationalMap& map, const Polynomial& f, std::uint64_t delta) {
    const mpz_class bottom = norm(map.denominator);
    std::vector<std::vector<mpz_class>> factors(map.components.size()); // [i][e] = ‖Nᵢ‖^e qᵢ^(δᵢ − e)
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const std::uint64_t degree = degree_or_zero(f.degree(i));
        const Polynomial& numerator = map.components[i].numerator;
        const mpz_class top = norm(numerator);
        const mpz_class q = numerator.denominator().to_mpz();
        for (std::uint64_t e = 0; e <= degree; ++e)
            factors[i].push_back(power(top, e) * power(q, degree - e));
    }
    mpz_class sum = 0;
    for (std::size_t term = 0; term < f.size(); ++term) {
        mpz_class product = abs(f.integer_terms().coefficients[term].to_mpz());
        for (std::size_t i = 0; i < factors.size(); ++i) product *= factors[i][f.exponent(term, i)];
        if (bottom != 1) product *= power(bottom, delta - degree_over_denominator(map, f, term));
        sum += product;
    }
    return sum;
}

std::vector<std::uint64_t> primes_above(const RationalMap& map, const mpz_class& height) {
    std::vector<std::uint64_t> primes;
    std::uint64_t p = ValuesModulo::prime_bound;
    for (mpz_class product = 1; product <= height;) {
        p = algebra::previous_prime(p);
        const bool divides_denominator = std::ranges::any_of(
            map.components, [p](const auto& c) { return c.numerator.denominator().residue(p) == 0; });
        if (divides_denominator) continue;
        primes.push_back(p);
        product *= p;
    }
    return primes;
}

} // namespace

VanishingClaim vanishing_claim(const RationalMap& map, const Polynomial& f) {
    std::uint64_t delta = 0;
    for (std::size_t term = 0; term < f.size(); ++term)
        delta = std::max(delta, degree_over_denominator(map, f, term));
    const auto bound = [&](auto&& degree_of) {
        std::vector<std::uint64_t> degrees;
        for (const RationalMap::Component& c : map.components)
            degrees.push_back(degree_or_zero(degree_of(c.numerator)));
        return greatest_degree(map, f, delta, degrees, degree_or_zero(degree_of(map.denominator)));
    };
    VanishingClaim claim;
    for (std::size_t i = 0; i < map.ring.variable_count(); ++i)
        claim.degrees.push_back(bound([i](const Polynomial& g) { return g.degree(i); }));
    claim.total_degree = bound([](const Polynomial& g) { return g.total_degree(); });
    claim.height = height_bound(map, f, delta);
    claim.primes = primes_above(map, claim.height);
    return claim;
}

bool vanishes(const RationalMap& map, const Polynomial& f, const VanishingClaim& claim, base::Run& run) {
    const GridLines lines(map, f, claim.degrees);
    std::vector<char> zero(claim.primes.size(), 0);
    base::parallel_for(run, zero.size(), [&](std::size_t i, std::size_t) {
        Grid grid(lines, map, f, claim, PrimeField(claim.primes[i]), run);
        zero[i] = grid.is_zero() ? 1 : 0;
    });
    return std::ranges::find(zero, 0) == zero.end();
}

} // namespace eliminant::implicit
