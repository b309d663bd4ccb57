#include "implicit/rational_zeros.hpp"

#include "algebra/univariate_mod_p.hpp"
#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/algebra/gcd.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::implicit {

namespace dense = algebra::dense;
using algebra::Polynomial;
using algebra::PrimeField;

namespace {

/// Integer coefficients from the constant one up.
std::vector<mpz_class> coefficients_of(const Polynomial& f) {
    std::vector<mpz_class> result(static_cast<std::size_t>(f.degree(0)) + 1);
    for (std::size_t i = 0; i < f.size(); ++i) result[f.exponent(i, 0)] = f.coefficient(i).get_num();
    return result;
}

template <class Coefficient>
std::vector<Coefficient> derivative_of(const std::vector<Coefficient>& f) {
    std::vector<Coefficient> result;
    for (std::size_t i = 1; i < f.size(); ++i) result.push_back(f[i] * static_cast<unsigned long>(i));
    return result;
}

mpz_class value_modulo(const std::vector<mpz_class>& f, const mpz_class& x, const mpz_class& modulus) {
    mpz_class value = 0;
    for (std::size_t i = f.size(); i-- > 0;) value = (value * x + f[i]) % modulus;
    return value;
}

dense::Vector image_modulo(const std::vector<mpz_class>& f, const PrimeField& field) {
    dense::Vector result;
    for (const mpz_class& c : f)
        result.push_back(static_cast<dense::Element>(mpz_fdiv_ui(c.get_mpz_t(), field.characteristic())));
    return result;
}

/// A prime at which f keeps its degree and stays squarefree; small, as its residues are tried one by one.
PrimeField good_prime(const std::vector<mpz_class>& f, base::Run& run) {
    for (std::uint64_t p = f.size() + 16;; ++p) {
        run.poll();
        if (!algebra::is_prime(p)) continue;
        PrimeField field(p);
        dense::Vector image = image_modulo(f, field);
        dense::Vector derivative = image_modulo(derivative_of(f), field);
        if (image.back() == 0) continue;
        dense::trim(derivative);
        if (dense::gcd(field, std::move(image), std::move(derivative), run).size() == 1) return field;
    }
}

void divide_by_content(std::vector<mpz_class>& f) {
    mpz_class content = 0;
    for (const mpz_class& c : f) content = gcd(content, c);
    if (content > 1)
        for (mpz_class& c : f) c /= content;
}

/// A positive multiple of −(f mod g), without content.
std::vector<mpz_class> negated_remainder(std::vector<mpz_class> f, const std::vector<mpz_class>& g,
                                         base::Run& run) {
    const mpz_class magnitude = abs(g.back());
    while (f.size() >= g.size()) {
        run.poll();
        const mpz_class factor = g.back() > 0 ? f.back() : mpz_class(-f.back());
        for (mpz_class& c : f) c *= magnitude;
        for (std::size_t i = 0; i < g.size(); ++i) f[f.size() - g.size() + i] -= factor * g[i];
        while (!f.empty() && f.back() == 0) f.pop_back();
    }
    divide_by_content(f);
    for (mpz_class& c : f) c = -c;
    return f;
}

} // namespace

std::size_t count_real_zeros(const Polynomial& polynomial, base::Run& run) {
    if (polynomial.is_constant()) return 0;
    std::vector<mpz_class> f = coefficients_of(polynomial.primitive_part());
    std::vector<mpz_class> g = derivative_of(f);
    std::int64_t difference = 0; // of sign changes at −∞ and at +∞
    while (!g.empty()) {
        const bool changes_right = sgn(f.back()) != sgn(g.back());
        const bool same_parity = (f.size() - g.size()) % 2 == 0;
        difference += (changes_right == same_parity ? 1 : 0) - (changes_right ? 1 : 0);
        std::vector<mpz_class> next = negated_remainder(std::move(f), g, run);
        f = std::exchange(g, std::move(next));
    }
    return static_cast<std::size_t>(difference);
}

std::vector<mpq_class> rational_zeros(const Polynomial& polynomial, base::Run& run) {
    if (polynomial.is_constant()) return {};
    const Polynomial squarefree = squarefree_part(polynomial, run);
    const std::vector<mpz_class> f = coefficients_of(squarefree);
    const std::vector<mpz_class> derivative = derivative_of(f);
    mpz_class bound = 0;
    for (const mpz_class& c : f) bound = std::max<mpz_class>(bound, abs(c));
    bound = 2 * (bound + abs(f.back()));

    std::vector<mpq_class> zeros;
    const PrimeField field = good_prime(f, run);
    const dense::Vector image = image_modulo(f, field);
    for (std::uint32_t residue = 0; residue < field.characteristic(); ++residue) {
        run.poll();
        if (dense::evaluate<PrimeField>(field, image, residue) != 0) continue;
        mpz_class zero = residue;
        mpz_class modulus = field.characteristic();
        while (modulus <= bound) { // each step of Newton's doubles the number of digits
            run.poll();
            modulus *= modulus;
            mpz_class inverse = value_modulo(derivative, zero, modulus);
            mpz_invert(inverse.get_mpz_t(), inverse.get_mpz_t(), modulus.get_mpz_t());
            zero = (zero - value_modulo(f, zero, modulus) * inverse) % modulus;
        }
        mpz_class numerator = f.back() * zero;
        mpz_fdiv_r(numerator.get_mpz_t(), numerator.get_mpz_t(), modulus.get_mpz_t());
        if (2 * numerator > modulus) numerator -= modulus;
        mpq_class candidate(numerator, f.back());
        candidate.canonicalize();
        if (evaluate(squarefree, std::span(&candidate, 1), run) == 0) zeros.push_back(std::move(candidate));
    }
    std::ranges::sort(zeros);
    return zeros;
}

} // namespace eliminant::implicit
