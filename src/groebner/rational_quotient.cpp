#include "groebner/rational_quotient.hpp"

#include <algorithm>

namespace eliminant::groebner {

using algebra::Integer;
using algebra::Polynomial;

namespace {

void bring_to_lowest_terms(RationalQuotient::Vector& v) {
    Integer common = v.denominator;
    for (const Integer& numerator : v.numerators) {
        if (common.is_one()) return;
        if (!numerator.is_zero()) common = gcd(common, numerator);
    }
    if (common.is_one()) return;
    v.denominator.divide_exactly(common);
    for (Integer& numerator : v.numerators) numerator.divide_exactly(common);
}

} // namespace

RationalQuotient::RationalQuotient(const Staircase& staircase, std::span<const Polynomial> basis,
                                   base::Run& run)
    : staircase_(staircase), basis_(basis), run_(run), border_(staircase.border_size()) {}

RationalQuotient::Vector RationalQuotient::unit(std::uint32_t b) const {
    Vector result;
    result.numerators.resize(size());
    result.numerators[b] = Integer(1);
    return result;
}

RationalQuotient::Vector RationalQuotient::product(std::size_t variable, std::uint32_t b) {
    const std::uint32_t product = staircase_.product(variable, b);
    return product < size() ? unit(product)
                            : border_normal_form(product - static_cast<std::uint32_t>(size()));
}

RationalQuotient::Vector RationalQuotient::times_variable(std::size_t variable, const Vector& element) {
    const auto D = static_cast<std::uint32_t>(size());
    Integer common(1); // denominator of all normal forms that occur
    for (std::uint32_t b = 0; b < D; ++b) {
        const std::uint32_t product = staircase_.product(variable, b);
        if (product >= D && !element.numerators[b].is_zero())
            common = lcm(common, border_normal_form(product - D).denominator);
    }
    Vector result;
    result.numerators.resize(D);
    for (std::uint32_t b = 0; b < D; ++b) {
        if (element.numerators[b].is_zero()) continue;
        run_.poll();
        const std::uint32_t product = staircase_.product(variable, b);
        if (product < D) {
            result.numerators[product].add_product(common, element.numerators[b]);
            continue;
        }
        const Vector& row = border_normal_form(product - D);
        Integer factor = common;
        factor.divide_exactly(row.denominator);
        factor *= element.numerators[b];
        for (std::size_t c = 0; c < D; ++c)
            if (!row.numerators[c].is_zero()) result.numerators[c].add_product(factor, row.numerators[c]);
    }
    result.denominator = common * element.denominator;
    bring_to_lowest_terms(result);
    return result;
}

const RationalQuotient::Vector& RationalQuotient::border_normal_form(std::uint32_t i) {
    if (border_[i].numerators.empty()) {
        const Staircase::Border& how = staircase_.border(i);
        border_[i] = how.element != Staircase::none
                         ? tail_normal_form(how.element)
                         : times_variable(how.variable, border_normal_form(how.below));
    }
    return border_[i];
}

RationalQuotient::Vector RationalQuotient::tail_normal_form(std::uint32_t element) const {
    const std::vector<Integer>& coefficients = basis_[element].integer_terms().coefficients;
    const std::span<const std::uint32_t> tail = staircase_.tail(element);
    Vector result;
    result.numerators.resize(size());
    for (std::size_t t = 0; t < tail.size(); ++t) result.numerators[tail[t]] = -coefficients[t + 1];
    result.denominator = coefficients.front(); // positive: elements of a reduced basis are normalised so
    bring_to_lowest_terms(result);
    return result;
}

} // namespace eliminant::groebner
