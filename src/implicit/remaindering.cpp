#include "implicit/remaindering.hpp"

#include <utility>

namespace eliminant::implicit {

using algebra::Integer;
using algebra::Polynomial;
using algebra::PolynomialBuilder;

namespace {

bool same_leading_monomial(const Polynomial& f, const Polynomial& g) {
    for (std::size_t i = 0; i < f.ring().variable_count(); ++i)
        if (f.exponent(0, i) != g.exponent(0, i)) return false;
    return true;
}

std::vector<std::uint64_t> exponents_of(const Polynomial& f, std::size_t term) {
    std::vector<std::uint64_t> exponents(f.ring().variable_count());
    for (std::size_t i = 0; i < exponents.size(); ++i) exponents[i] = f.exponent(term, i);
    return exponents;
}

/// f over GF(p) with residues read in (−p/2, p/2].
Polynomial lifted(const Polynomial& f, const algebra::Ring& rational_ring) {
    const std::int64_t p = f.ring().field().characteristic();
    PolynomialBuilder builder(rational_ring);
    for (std::size_t i = 0; i < f.size(); ++i) {
        const std::int64_t residue = f.residue_terms().coefficients[i];
        builder.add(Integer(residue > p / 2 ? residue - p : residue), exponents_of(f, i));
    }
    return builder.build();
}

/// The residue of a modulo M in (−M/2, M/2].
mpz_class symmetric_residue(const mpz_class& a, const mpz_class& M) {
    mpz_class r;
    mpz_fdiv_r(r.get_mpz_t(), a.get_mpz_t(), M.get_mpz_t());
    if (2 * r > M) r -= M;
    return r;
}

/// The least d > 0 with |a·d mod M| ≤ bound, among the convergents, or 0 if it exceeds the bound: the
/// extended Euclidean algorithm, stopped half-way.
mpz_class denominator_of(const mpz_class& a, const mpz_class& M, const mpz_class& bound) {
    mpz_class r0 = M;
    mpz_class r1;
    mpz_fdiv_r(r1.get_mpz_t(), a.get_mpz_t(), M.get_mpz_t());
    mpz_class d0 = 0;
    mpz_class d1 = 1;
    while (r1 > bound) {
        const mpz_class q = r0 / r1;
        r0 -= q * r1;
        std::swap(r0, r1);
        d0 -= q * d1;
        std::swap(d0, d1);
    }
    d1 = abs(d1);
    return d1 <= bound ? d1 : mpz_class(0);
}

/// The integer polynomial of which f is a multiple modulo M. Each coefficient mostly has the denominator of
/// the ones before, so few need Euclid.
std::optional<Polynomial> reconstructed(const Polynomial& f, const mpz_class& M, const mpz_class& bound) {
    mpz_class denominator = 1;
    for (const Integer& coefficient : f.integer_terms().coefficients) {
        const mpz_class scaled = symmetric_residue(coefficient.to_mpz() * denominator, M);
        if (abs(scaled) <= bound) continue;
        denominator *= denominator_of(scaled, M, bound);
        if (denominator == 0 || denominator > bound) return std::nullopt;
    }
    PolynomialBuilder builder(f.ring());
    for (std::size_t i = 0; i < f.size(); ++i) {
        const mpz_class n = symmetric_residue(f.integer_terms().coefficients[i].to_mpz() * denominator, M);
        if (abs(n) > bound) return std::nullopt;
        builder.add(Integer(n), exponents_of(f, i));
    }
    return builder.build().primitive_part();
}

} // namespace

bool Remaindering::accepts(const std::vector<Polynomial>& images) const {
    if (primes_ == 0) return true;
    if (images.size() != residues_.size()) return false;
    for (std::size_t i = 0; i < images.size(); ++i)
        if (!same_leading_monomial(images[i], residues_[i])) return false;
    return true;
}

void Remaindering::add(const std::vector<Polynomial>& images, base::Run& run) {
    if (primes_ == 0) residues_.assign(images.size(), Polynomial(ring_));
    mpz_class p = 1;
    for (std::size_t i = 0; i < images.size(); ++i) {
        run.poll();
        const algebra::Ring& ring = images[i].ring();
        p = ring.field().characteristic();
        mpz_class inverse;
        mpz_invert(inverse.get_mpz_t(), modulus_.get_mpz_t(), p.get_mpz_t());
        const Polynomial difference = (images[i] - residues_[i].in_ring(ring)).scaled(inverse);
        residues_[i] += lifted(difference, ring_).scaled(mpq_class(modulus_));
    }
    modulus_ *= p;
    ++primes_;
}

std::optional<std::vector<Polynomial>> Remaindering::reconstruct(base::Run& run) const {
    mpz_class bound = (modulus_ - 1) / 2;
    bound = sqrt(bound);
    std::vector<Polynomial> result;
    for (const Polynomial& residue : residues_) {
        run.poll();
        auto f = reconstructed(residue, modulus_, bound);
        if (!f) return std::nullopt;
        result.push_back(std::move(*f));
    }
    return result;
}

} // namespace eliminant::implicit
