#include "ideal/generic_fibre.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/calculus.hpp"
#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/algebra/gcd.hpp"
#include "eliminant/groebner/buchberger.hpp"
#include "eliminant/ideal/zero_dimensional.hpp"
#include "ideal/ring_change.hpp"

#include <algorithm>
#include <random>
#include <utility>

namespace eliminant::ideal {

using algebra::CoefficientField;
using algebra::MonomialOrder;
using algebra::Polynomial;
using algebra::Ring;

Variables complement(const Variables& some, std::size_t variable_count) {
    Variables rest;
    for (std::size_t i = 0; i < variable_count; ++i) {
        if (!std::ranges::binary_search(some, i)) rest.push_back(i);
    }
    return rest;
}

namespace {

/// How many terms of f, from the first, have the leading monomial in the bound variables.
std::size_t leading_terms_over(const Polynomial& f, const Variables& bound) {
    const auto same_power = [&](std::size_t i) {
        return std::ranges::all_of(bound,
                                   [&](std::size_t x) { return f.exponent(i, x) == f.exponent(0, x); });
    };
    std::size_t count = 1;
    while (count < f.size() && same_power(count)) ++count;
    return count;
}

/// The elements of a basis that are minimal over K(U).
std::vector<Polynomial> minimal_over(const std::vector<Polynomial>& basis, const Variables& bound) {
    std::vector<Polynomial> minimal;
    for (const Polynomial& f : basis) { // ascending, so divisors come first
        const auto divides = [&](const Polynomial& g) {
            return std::ranges::all_of(bound,
                                       [&](std::size_t x) { return g.exponent(0, x) <= f.exponent(0, x); });
        };
        if (std::ranges::none_of(minimal, divides)) minimal.push_back(f);
    }
    return minimal;
}

/// The ideal of a fibre: `basis` with the free variables at `values` and coefficients in the field of
/// `target`, a ring in the bound variables; nullopt if a leading coefficient vanishes there.
std::optional<Ideal> fibre(const std::vector<Polynomial>& basis, const Variables& bound, const Ring& target,
                           const std::vector<mpq_class>& values, base::Run& run) {
    if (basis.empty()) return Ideal(target);
    const Ring reduced = basis.front().ring().with_field(target.field());
    const Variables free = complement(bound, reduced.variable_count());
    std::vector<Polynomial> images;
    for (const Polynomial& f : basis) {
        Polynomial image = evaluate(f.in_ring(reduced), free, values, run);
        const auto keeps_power = [&](std::size_t x) { return image.exponent(0, x) == f.exponent(0, x); };
        if (image.is_zero() || !std::ranges::all_of(bound, keeps_power)) return std::nullopt;
        images.push_back(image.in_ring(target, map_to_subring(reduced, bound)));
    }
    return Ideal::from_groebner_basis(target, target.order(),
                                      groebner::reduced_basis(std::move(images), run));
}

} // namespace

Polynomial leading_coefficient_over(const Polynomial& f, const Variables& bound) {
    Polynomial coefficient(f.ring());
    const std::size_t count = leading_terms_over(f, bound);
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<std::uint64_t> exponents = f.monomial(i).exponents();
        for (const std::size_t x : bound) exponents[x] = 0;
        coefficient += Polynomial::term(algebra::Monomial(f.ring(), exponents), f.coefficient(i));
    }
    return coefficient;
}

std::optional<Variables> suspects_of_multiplicity(const Ideal& J, const Variables& bound, base::Run& run) {
    constexpr int attempts = 3;
    const Ring& ring = J.ring();
    const std::vector<Polynomial> basis =
        minimal_over(J.groebner_basis(MonomialOrder::elimination(bound), run), bound);
    const CoefficientField field =
        ring.field().is_rationals() ? CoefficientField::prime(2147483629) : ring.field();
    const Ring target = subring(Ring(field, ring.names()), bound);
    std::mt19937_64 random(run.seed());
    for (int attempt = 0; attempt < attempts; ++attempt) {
        std::vector<mpq_class> values(ring.variable_count() - bound.size());
        for (mpq_class& value : values) value = static_cast<unsigned long>(random() % field.characteristic());
        const std::optional<Ideal> at_values = fibre(basis, bound, target, values, run);
        if (!at_values) continue;
        Variables suspects;
        for (std::size_t i = 0; i < bound.size(); ++i) {
            const Polynomial m = minimal_polynomial(*at_values, Polynomial::variable(target, i), run);
            if (!coprime(m, derivative(m, 0), run)) suspects.push_back(bound[i]);
        }
        return suspects;
    }
    return std::nullopt;
}

} // namespace eliminant::ideal
