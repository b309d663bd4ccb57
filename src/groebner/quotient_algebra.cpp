#include "groebner/quotient_algebra.hpp"

#include <algorithm>

namespace eliminant::groebner {

using algebra::Integer;
using algebra::Polynomial;
using algebra::PrimeField;

QuotientAlgebra::QuotientAlgebra(const Staircase& staircase, std::span<const Polynomial> basis,
                                 const PrimeField& field, base::Run& run)
    : staircase_(staircase), basis_(basis), field_(field), run_(run), kernels_(residue_kernels()),
      border_(staircase.border_size()) {}

bool QuotientAlgebra::has_good_reduction(std::span<const Polynomial> basis, const PrimeField& field) {
    return std::ranges::all_of(basis, [&](const Polynomial& f) {
        return field.from_integer(f.integer_terms().coefficients.front()) != 0;
    });
}

QuotientAlgebra::Vector QuotientAlgebra::unit(std::uint32_t b) const {
    Vector result(size(), 0);
    result[b] = 1;
    return result;
}

QuotientAlgebra::Vector QuotientAlgebra::times_variable(std::size_t variable, const Vector& element) {
    const std::uint64_t p = field_.characteristic();
    std::vector<std::uint64_t> sums(size(), 0); // in [0, p²)
    for (std::size_t b = 0; b < size(); ++b) {
        if (element[b] == 0) continue;
        const std::uint32_t product = staircase_.product(variable, b);
        if (product < size()) {
            sums[product] += element[b];
            if (sums[product] >= p * p) sums[product] -= p * p;
        } else {
            run_.poll();
            const Vector& row = border_normal_form(product - static_cast<std::uint32_t>(size()));
            kernels_.subtract_multiple(sums.data(), row.data(), size(), field_.negate(element[b]), p * p);
        }
    }
    Vector result(size());
    std::ranges::transform(sums, result.begin(), [&](std::uint64_t s) { return field_.reduce(s); });
    return result;
}

QuotientAlgebra::Vector QuotientAlgebra::pull_back(std::size_t variable, const Vector& form) {
    Vector result(size());
    for (std::size_t b = 0; b < size(); ++b) {
        const std::uint32_t product = staircase_.product(variable, b);
        if (product < size())
            result[b] = form[product];
        else
            result[b] = apply(form, border_normal_form(product - static_cast<std::uint32_t>(size())));
    }
    run_.poll();
    return result;
}

QuotientAlgebra::Residue QuotientAlgebra::apply(const Vector& form, const Vector& element) const {
    const auto [high, low] = kernels_.dot(form.data(), element.data(), size());
    const Residue two_to_32 = field_.reduce(std::uint64_t{1} << 32);
    return field_.add(field_.multiply(field_.reduce(high), two_to_32), field_.reduce(low));
}

const QuotientAlgebra::Vector& QuotientAlgebra::border_normal_form(std::uint32_t i) {
    if (border_[i].empty()) {
        // The border monomial below, and those that its normal form is multiplied into, are smaller, so the
        // recursion ends; its depth is at most the number of border monomials below each other.
        const Staircase::Border& how = staircase_.border(i);
        border_[i] = how.element != Staircase::none
                         ? tail_normal_form(how.element)
                         : times_variable(how.variable, border_normal_form(how.below));
    }
    return border_[i];
}

QuotientAlgebra::Vector QuotientAlgebra::tail_normal_form(std::uint32_t element) const {
    const Polynomial& f = basis_[element];
    const std::span<const std::uint32_t> tail = staircase_.tail(element);
    Vector result(size(), 0);
    if (f.ring().field().is_rationals()) {
        const std::vector<Integer>& coefficients = f.integer_terms().coefficients;
        const Residue factor = field_.negate(field_.inverse(field_.from_integer(coefficients.front())));
        for (std::size_t t = 0; t < tail.size(); ++t)
            result[tail[t]] = field_.multiply(factor, field_.from_integer(coefficients[t + 1]));
    } else {
        const std::vector<Residue>& coefficients = f.residue_terms().coefficients;
        for (std::size_t t = 0; t < tail.size(); ++t) result[tail[t]] = field_.negate(coefficients[t + 1]);
    }
    return result;
}

} // namespace eliminant::groebner
