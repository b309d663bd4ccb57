#include "algebra/univariate_mod_p.hpp"
#include "groebner/fglm.hpp"

#include <algorithm>
#include <random>
#include <utility>

namespace eliminant::groebner {

using algebra::PrimeField;
using algebra::Ring;
namespace dense = algebra::dense;

namespace {

using Residue = PrimeField::Element;
using Vector = std::vector<Residue>;

/// The minimal polynomial, monic, of a linearly recurrent sequence of order at most half its length: Σ
/// μᵢ·s_{k+i} = 0 for all k (Massey, IEEE Trans. Inf. Theory 15 (1969)). Quadratic.
Vector minimal_polynomial(const PrimeField& field, const Vector& sequence, base::Run& run) {
    // Connection polynomials, constant coefficient 1: the current one, and that before the last change of
    // length.
    Vector current = {1};
    Vector previous = {1};
    std::size_t length = 0;
    std::size_t shift = 1;
    Residue previous_discrepancy = 1;
    for (std::size_t k = 0; k < sequence.size(); ++k, ++shift) {
        run.poll();
        Residue discrepancy = 0;
        for (std::size_t i = 0; i < current.size() && i <= k; ++i)
            discrepancy = field.add(discrepancy, field.multiply(current[i], sequence[k - i]));
        if (discrepancy == 0) continue;
        const Residue factor = field.multiply(discrepancy, field.inverse(previous_discrepancy));
        Vector changed = current;
        changed.resize(std::max(current.size(), previous.size() + shift), 0);
        dense::add_multiple<PrimeField>(field, std::span(changed).subspan(shift), previous,
                                        field.negate(factor));
        if (2 * length <= k) {
            length = k + 1 - length;
            previous = std::move(current);
            previous_discrepancy = discrepancy;
            shift = 0;
        }
        current = std::move(changed);
    }
    // μ is the reversal to degree `length`.
    current.resize(length + 1, 0);
    std::ranges::reverse(current);
    return current;
}

/// N with N/μ = Σ s_i·z^(−i−1): the polynomial part of μ·Σ s_i·z^(−i−1).
Vector numerator(const PrimeField& field, const Vector& mu, const Vector& sequence) {
    const std::size_t d = mu.size() - 1;
    Vector result(d);
    for (std::size_t k = 0; k < d; ++k)
        result[k] = dense::dot(field, std::span(mu).subspan(k + 1), std::span(sequence));
    dense::trim(result);
    return result;
}

/// The inverse of a modulo m, to which it is coprime; extended Euclid, quadratic.
Vector inverse_modulo(const PrimeField& field, Vector a, const Vector& m, base::Run& run) {
    Vector b = m;
    Vector s = {1}; // a ≡ s·(a at the beginning)
    Vector t;       // b ≡ t·(a at the beginning)
    while (a.size() > 1) {
        run.poll();
        Vector quotient = dense::divide(field, b, a);
        for (Residue& c : quotient) c = field.negate(c);
        Vector product = dense::multiply(field, quotient, s);
        if (product.size() < t.size()) product.resize(t.size(), 0);
        dense::add_multiple<PrimeField>(field, product, t, 1);
        dense::trim(product);
        t = std::exchange(s, std::move(product));
        std::swap(a, b);
    }
    const Residue scale = field.inverse(a.at(0));
    for (Residue& c : s) c = field.multiply(c, scale);
    return s;
}

/// The values of a random linear form on yⁱ, and on xⱼ·yⁱ for the other variables.
struct Sequences {
    Vector of_powers;
    std::vector<Vector> of_multiples;
};

Sequences sequences(QuotientAlgebra& algebra, std::span<const std::size_t> others, std::size_t y,
                    base::Run& run) {
    const std::size_t D = algebra.size();
    std::mt19937_64 random(run.seed() ^ 0x5eed);
    Vector form(D);
    for (Residue& c : form) c = algebra.field().reduce(random() >> 33);

    const Vector one = algebra.unit(0);
    std::vector<Vector> variables;
    for (const std::size_t j : others) variables.push_back(algebra.times_variable(j, one));
    Sequences result{{}, std::vector<Vector>(others.size())};
    for (std::size_t i = 0; i < 2 * D; ++i) {
        result.of_powers.push_back(form[0]);
        if (i < D)
            for (std::size_t j = 0; j < others.size(); ++j)
                result.of_multiples[j].push_back(algebra.apply(form, variables[j]));
        if (i + 1 < 2 * D) form = algebra.pull_back(y, form);
        run.report([&] { return base::Progress{"change of order", i, 2 * D}; });
    }
    return result;
}

} // namespace

std::optional<ConvertedBasis> fglm_in_shape_position(QuotientAlgebra& algebra, const Ring& target,
                                                     std::span<const std::size_t> variables, base::Run& run) {
    const std::size_t D = algebra.size();
    const PrimeField& field = algebra.field();
    const std::size_t last = variables.size() - 1;
    const Sequences values = sequences(algebra, variables.first(last), variables[last], run);
    // The minimal polynomial of the sequence divides that of y, whose degree is at most D.
    const Vector mu = minimal_polynomial(field, values.of_powers, run);
    if (mu.size() != D + 1) return std::nullopt;

    ConvertedBasis result;
    std::vector<std::uint64_t> exponents(variables.size(), 0);
    for (exponents[last] = 0; exponents[last] < D; ++exponents[last])
        result.standard.emplace_back(target, exponents);
    result.leads.emplace_back(target, exponents);
    Vector& power = result.tails.emplace_back(mu.begin(), mu.end() - 1);
    for (Residue& c : power) c = field.negate(c);

    // Coprime to μ, for else the sequence would satisfy a shorter recurrence.
    const Vector& N = result.numerators.emplace_back(numerator(field, mu, values.of_powers));
    const Vector inverse = inverse_modulo(field, N, mu, run);
    for (std::size_t j = last; j-- > 0;) {
        exponents.assign(variables.size(), 0);
        exponents[j] = 1;
        result.leads.emplace_back(target, exponents);
        result.numerators.push_back(numerator(field, mu, values.of_multiples[j]));
        Vector q = dense::multiply(field, result.numerators.back(), inverse);
        dense::divide(field, q, mu);
        q.resize(D, 0);
        result.tails.push_back(std::move(q));
    }
    for (Vector& n : result.numerators) n.resize(D, 0);
    return result;
}

} // namespace eliminant::groebner
