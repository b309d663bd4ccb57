#include "eliminant/ideal/hilbert.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "groebner/monomial_ideal.hpp"
#include "ideal/ring_change.hpp"

#include <utility>

namespace eliminant::ideal {

using algebra::CoefficientField;
using algebra::MonomialOrder;
using algebra::Polynomial;
using algebra::PolynomialBuilder;
using algebra::Ring;

namespace {

/// C(n, k) = n(n − 1)…(n − k + 1)/k! for any integer n.
mpz_class binomial(const mpz_class& n, std::size_t k) {
    mpz_class result;
    mpz_bin_ui(result.get_mpz_t(), n.get_mpz_t(), k);
    return result;
}

mpz_class exponent_of(const Polynomial& f, std::size_t i) {
    return static_cast<unsigned long>(f.exponent(i, 0));
}

/// The series of the leading ideal of `basis`, a Groebner basis in an order that compares degrees first.
HilbertSeries leading_series(const std::vector<Polynomial>& basis, std::size_t denominator_exponent,
                             base::Run& run) {
    PolynomialBuilder builder(Ring(CoefficientField::rationals(), {"t"}));
    for (const auto& [exponent, coefficient] :
         groebner::hilbert_numerator(groebner::leading_exponents(basis), run)) {
        const std::vector<std::uint64_t> exponents{exponent};
        builder.add(coefficient, exponents);
    }
    return {builder.build(), denominator_exponent};
}

/// A basis in an order that compares total degrees first.
const std::vector<Polynomial>& degree_basis(const Ideal& I, base::Run& run) {
    const bool by_degree = I.ring().order().kind() == MonomialOrder::Kind::deglex;
    return I.groebner_basis(by_degree ? MonomialOrder::deglex() : MonomialOrder::degrevlex(), run);
}

} // namespace

HilbertSeries::HilbertSeries(Polynomial numerator, std::size_t denominator_exponent)
    : numerator_(std::move(numerator)), exponent_(denominator_exponent) {
    if (numerator_.ring().variable_count() != 1 || !numerator_.ring().field().is_rationals() ||
        !numerator_.denominator().is_one())
        throw DomainError("the numerator of a Hilbert series is an integer polynomial in one variable");
}

mpz_class HilbertSeries::taylor_coefficient(std::size_t k) const {
    mpz_class sum = 0;
    for (std::size_t i = 0; i < numerator_.size(); ++i)
        sum += numerator_.coefficient(i).get_num() * binomial(exponent_of(numerator_, i), k);
    return sum;
}

std::int64_t HilbertSeries::pole_order() const {
    if (numerator_.is_zero()) return -1;
    std::size_t zeros = 0;
    while (zeros < exponent_ && taylor_coefficient(zeros) == 0) ++zeros;
    return static_cast<std::int64_t>(exponent_ - zeros);
}

mpz_class HilbertSeries::multiplicity() const {
    if (numerator_.is_zero()) return 0;
    // N = c(t − 1)^k + … = (−1)^k c(1 − t)^k + …
    const std::size_t zeros = exponent_ - static_cast<std::size_t>(pole_order());
    const mpz_class c = taylor_coefficient(zeros);
    return zeros % 2 == 0 ? c : mpz_class(-c);
}

HilbertSeries HilbertSeries::reduced(base::Run& run) const {
    if (numerator_.is_zero()) return {numerator_, 0};
    const Ring& ring = numerator_.ring();
    const std::size_t order = static_cast<std::size_t>(pole_order());
    const Polynomial factor = Polynomial::constant(ring, 1) - Polynomial::variable(ring, std::size_t{0});
    Polynomial quotient = numerator_;
    for (std::size_t k = order; k < exponent_; ++k) quotient = divide_exactly(quotient, factor, run);
    return {std::move(quotient), order};
}

mpz_class HilbertSeries::value(std::uint64_t d) const {
    // 1/(1 − t)^e = Σ C(d + e − 1, e − 1) t^d, and 1 for e = 0.
    mpz_class sum = 0;
    for (std::size_t i = 0; i < numerator_.size(); ++i) {
        if (numerator_.exponent(i, 0) > d) continue;
        const mpz_class rest = mpz_class(static_cast<unsigned long>(d)) - exponent_of(numerator_, i);
        const mpz_class c = numerator_.coefficient(i).get_num();
        if (exponent_ > 0)
            sum += c * binomial(rest + static_cast<unsigned long>(exponent_ - 1), exponent_ - 1);
        else if (rest == 0)
            sum += c;
    }
    return sum;
}

Polynomial HilbertSeries::hilbert_polynomial() const {
    const Ring ring(CoefficientField::rationals(), {"d"});
    const Polynomial d = Polynomial::variable(ring, std::size_t{0});
    // N/(1 − t)^e = Σ_k (−1)^k c_k/(1 − t)^(e − k) for Taylor coefficients c_k at 1; each pole of order m = e
    // − k contributes C(d + m − 1, m − 1), the terms with k ≥ e only finitely many values.
    Polynomial result(ring);
    Polynomial binomial_in_d = Polynomial::constant(ring, 1); // C(d + m − 1, m − 1)
    for (std::size_t m = 1; m <= exponent_; ++m) {
        const std::size_t k = exponent_ - m;
        const mpz_class c = taylor_coefficient(k);
        result += binomial_in_d.scaled(k % 2 == 0 ? c : mpz_class(-c));
        const auto next = static_cast<unsigned long>(m);
        binomial_in_d = (binomial_in_d * (d + Polynomial::constant(ring, next))).scaled(mpq_class(1, next));
    }
    return result;
}

std::int64_t HilbertSeries::regularity_index() const {
    if (numerator_.is_zero()) return 0;
    // H − P is the polynomial part of N/(1 − t)^e as far as d ≥ 0, and vanishes beyond deg N − e; the same
    // argument at infinity shows that it does not vanish at deg N − e.
    const mpz_class index = exponent_of(numerator_, 0) - static_cast<unsigned long>(exponent_) + mpz_class(1);
    if (!index.fits_slong_p())
        throw OverflowError("the regularity index of a Hilbert series exceeds 2^63 - 1");
    return index.get_si();
}

HilbertSeries hilbert_series(const Ideal& I, base::Run& run) {
    if (!I.is_homogeneous(run))
        throw DomainError(
            "Hilbert series: the ideal is not homogeneous; its affine Hilbert series is defined");
    return leading_series(degree_basis(I, run), I.ring().variable_count(), run);
}

HilbertSeries affine_hilbert_series(const Ideal& I, base::Run& run) {
    return leading_series(degree_basis(I, run), I.ring().variable_count() + 1, run);
}

mpz_class degree(const Ideal& I, base::Run& run) { return affine_hilbert_series(I, run).multiplicity(); }

} // namespace eliminant::ideal
