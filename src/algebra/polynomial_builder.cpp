#include "eliminant/algebra/polynomial.hpp"

#include "term_arithmetic.hpp"

#include <utility>

namespace eliminant::algebra {

PolynomialBuilder::PolynomialBuilder(Ring ring)
    : ring_(std::move(ring)), terms_(IntegerTerms(ring_.layout(8))) {
    if (!ring_.field().is_rationals()) terms_ = ResidueTerms(ring_.layout(8));
    scratch_.resize(ring_.layout(64).words());
}

std::size_t PolynomialBuilder::size() const {
    return std::visit([](const auto& terms) { return terms.size(); }, terms_);
}

void PolynomialBuilder::widen() {
    std::visit(
        [this](auto& terms) {
            // The 64-bit layout is the last resort; what does not fit there is an overflow.
            const std::uint64_t next =
                terms.layout->bits() == 64 ? ~std::uint64_t{0} : terms.layout->max_field() + 1;
            terms = *repacked(terms, ring_.layout_for(next));
        },
        terms_);
}

void PolynomialBuilder::add(const Integer& numerator, const Integer& denominator,
                            std::span<const std::uint64_t> exponents) {
    const auto encode = [&](const auto& terms) { return terms.layout->encode(exponents, scratch_.data()); };
    while (!std::visit(encode, terms_)) widen();
    if (auto* residues = std::get_if<ResidueTerms>(&terms_)) {
        const PrimeField& field = ring_.field().prime_field();
        residues->push_back(scratch_.data(), denominator.is_one()
                                                 ? field.from_integer(numerator)
                                                 : field.from_fraction(numerator, denominator));
        return;
    }
    auto& terms = std::get<IntegerTerms>(terms_);
    if (!denominator.is_one() || !denominators_.empty()) {
        denominators_.resize(terms.size(), Integer(1));
        denominators_.push_back(denominator);
    }
    terms.push_back(scratch_.data(), numerator);
}

Polynomial PolynomialBuilder::build() {
    if (auto* residues = std::get_if<ResidueTerms>(&terms_)) {
        const PrimeDomain domain{ring_.field().prime_field()};
        auto sorted = sorted_terms(domain, std::exchange(*residues, ResidueTerms(ring_.layout(8))));
        return Polynomial::from_terms(ring_, std::move(sorted));
    }
    auto& terms = std::get<IntegerTerms>(terms_);
    Integer common(1);
    for (const Integer& d : denominators_) common = lcm(common, d);
    if (!denominators_.empty()) { // not only where their lcm exceeds 1: one of them may be −1
        for (std::size_t i = 0; i < terms.size(); ++i) {
            Integer factor = common;
            factor.divide_exactly(denominators_[i]);
            terms.coefficients[i] *= factor;
        }
    }
    denominators_.clear();
    auto sorted = sorted_terms(IntegerDomain{}, std::exchange(terms, IntegerTerms(ring_.layout(8))));
    return Polynomial::from_terms(ring_, std::move(sorted), std::move(common));
}

} // namespace eliminant::algebra
