#include "eliminant/algebra/calculus.hpp"

#include "term_maps.hpp"

namespace eliminant::algebra {

namespace {

Integer multiple(const IntegerDomain& /*domain*/, const Integer& c, std::uint64_t factor) {
    return c * Integer(factor);
}

PrimeField::Element multiple(const PrimeDomain& domain, PrimeField::Element c, std::uint64_t factor) {
    return domain.multiply(c, domain.field.reduce(factor));
}

} // namespace

Polynomial derivative(const Polynomial& f, std::size_t variable) {
    require_variable(f.ring(), variable);
    const MonomialLayout& layout = f.layout();
    std::vector<std::uint64_t> exponents(layout.variable_count(), 0);
    exponents[variable] = 1;
    std::vector<MonomialLayout::Word> x(layout.words());
    std::vector<MonomialLayout::Word> lowered(layout.words());
    // A weight of the variable may exceed the field of this layout; then it does not occur in f.
    if (!layout.encode(exponents, x.data())) return Polynomial(f.ring());
    return visit_terms(f, [&](const auto& terms, const auto& domain) {
        auto result = std::decay_t<decltype(terms)>(layout);
        for (std::size_t i = 0; i < terms.size(); ++i) {
            const std::uint64_t exponent = layout.exponent(terms.monomial(i), variable);
            if (exponent == 0) continue;
            auto coefficient = multiple(domain, terms.coefficients[i], exponent);
            if (domain.is_zero(coefficient)) continue;
            layout.divide(terms.monomial(i), x.data(), lowered.data());
            // Division by one monomial keeps the terms in order.
            result.push_back(lowered.data(), std::move(coefficient));
        }
        return over_denominator_of(f, std::move(result));
    });
}

std::vector<Polynomial> gradient(const Polynomial& f) {
    std::vector<Polynomial> result;
    for (std::size_t v = 0; v < f.ring().variable_count(); ++v) result.push_back(derivative(f, v));
    return result;
}

} // namespace eliminant::algebra
