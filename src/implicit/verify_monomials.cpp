#include "implicit/verify_monomials.hpp"

#include "eliminant/base/error.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace eliminant::implicit {

using algebra::Polynomial;

namespace {

mpz_class exponent(const Polynomial& term, std::size_t variable) {
    return mpz_class(static_cast<unsigned long>(term.exponent(0, variable)));
}

/// Numbers that grow with the exponent, as ±1 does not.
bool grows(const mpz_class& c) { return mpz_cmpabs_ui(c.get_mpz_t(), 1) > 0; }

mpz_class power(const mpz_class& c, const mpz_class& exponent) {
    if (!grows(c)) return mpz_even_p(exponent.get_mpz_t()) != 0 ? mpz_class(1) : c;
    mpz_class result;
    mpz_pow_ui(result.get_mpz_t(), c.get_mpz_t(), exponent.get_ui());
    return result;
}

/// An upper bound for the bits of c^exponent.
mpz_class bits_of_power(const mpz_class& c, const mpz_class& exponent) {
    if (!grows(c)) return 1;
    return exponent * mpz_class(static_cast<unsigned long>(mpz_sizeinbase(c.get_mpz_t(), 2)));
}

} // namespace

std::optional<TermMap> term_map(const RationalMap& map) {
    if (map.denominator.size() != 1) return std::nullopt;
    TermMap result;
    for (const auto& [numerator, over_denominator] : map.components) {
        if (numerator.size() != 1) return std::nullopt;
        result.coefficients.push_back(numerator.leading_coefficient());
        if (over_denominator) result.coefficients.back() /= map.denominator.leading_coefficient();
        auto& row = result.exponents.emplace_back();
        for (std::size_t v = 0; v < map.ring.variable_count(); ++v) {
            row.push_back(exponent(numerator, v));
            if (over_denominator) row.back() -= exponent(map.denominator, v);
        }
    }
    return result;
}

mpq_class product_of_powers(const std::vector<mpq_class>& c, const std::vector<mpz_class>& u) {
    mpz_class bits = 0;
    for (std::size_t i = 0; i < c.size(); ++i)
        bits += bits_of_power(c[i].get_num(), abs(u[i])) + bits_of_power(c[i].get_den(), abs(u[i]));
    if (bits > mpz_class(static_cast<unsigned long>(max_binomial_bits)))
        throw base::OverflowError("the equation, a binomial, has a coefficient of up to " + bits.get_str() +
                                  " bits; the limit is " + std::to_string(max_binomial_bits));
    mpq_class product = 1;
    for (std::size_t i = 0; i < c.size(); ++i) {
        const mpz_class exponent = abs(u[i]);
        mpq_class factor(power(c[i].get_num(), exponent), power(c[i].get_den(), exponent));
        factor.canonicalize(); // the sign
        if (u[i] < 0) factor = 1 / factor;
        product *= factor;
    }
    return product;
}

bool is_irreducible_binomial_on(const TermMap& map, const Polynomial& f) {
    const std::size_t n = map.coefficients.size();
    if (f.size() != 2 || f.ring().variable_count() != n) return false;
    std::vector<mpz_class> u;
    mpz_class common = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const std::uint64_t p = f.exponent(0, i);
        const std::uint64_t q = f.exponent(1, i);
        if (p != 0 && q != 0) return false;
        u.emplace_back(mpz_class(static_cast<unsigned long>(p)) - mpz_class(static_cast<unsigned long>(q)));
        common = gcd(common, u.back());
    }
    if (common != 1) return false;
    for (std::size_t v = 0; v < map.exponents.front().size(); ++v) {
        mpz_class sum = 0;
        for (std::size_t i = 0; i < n; ++i) sum += u[i] * map.exponents[i][v];
        if (sum != 0) return false;
    }
    return f.coefficient(0) * product_of_powers(map.coefficients, u) == -f.coefficient(1);
}

} // namespace eliminant::implicit
