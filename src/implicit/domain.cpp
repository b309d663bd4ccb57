#include "implicit/domain.hpp"

#include "eliminant/algebra/coefficients.hpp"
#include "eliminant/algebra/gcd.hpp"
#include "eliminant/algebra/grading.hpp"
#include "eliminant/ideal/operations.hpp"
#include "eliminant/ideal/radical.hpp"

#include <string>
#include <utility>

namespace eliminant::implicit {

using algebra::MonomialOrder;
using algebra::Polynomial;
using algebra::Ring;
using ideal::Ideal;

namespace {

/// Compares degrees in the variables of weight 1 first, then by degrevlex. The elements of a Groebner basis
/// in such an order, homogenised, generate the homogenised ideal (Cox, Little, O'Shea, §8.4, Theorem 4).
MonomialOrder degree_order(std::span<const std::uint64_t> weights) {
    const std::size_t n = weights.size();
    std::vector<std::vector<std::int64_t>> rows;
    rows.emplace_back(weights.begin(), weights.end());
    rows.emplace_back(n, 1);
    for (std::size_t i = n; i-- > 1;) {
        rows.emplace_back(n, 1);
        rows.back()[i] = 0;
    }
    return MonomialOrder::matrix(std::move(rows));
}

std::vector<std::uint64_t> indicator(std::size_t n, std::span<const std::size_t> indices) {
    std::vector<std::uint64_t> weights(n, 0);
    for (const std::size_t i : indices) weights[i] = 1;
    return weights;
}

/// The elements of ℚ[T, C] that the ideal generates over ℚ(C): I : f^∞ with f the product of the leading
/// coefficients in ℚ[C] of a Groebner basis in a product order of T before C (Becker and Weispfenning,
/// Groebner Bases, Proposition 8.94).
Ideal without_conditions_on_constants(const Parametrization& parametrization, Ideal I, base::Run& run) {
    if (parametrization.constants().empty()) return I;
    const std::vector<std::size_t>& parameters = parametrization.parameters();
    const std::vector<Polynomial> basis = I.groebner_basis(MonomialOrder::elimination(parameters), run);
    for (const Polynomial& g : basis) {
        for (const auto& term : coefficients(g, parameters)) {
            bool leading = true;
            for (std::size_t i = 0; i < parameters.size(); ++i)
                leading &= term.exponents[i] == g.exponent(0, parameters[i]);
            if (leading && !term.coefficient.is_constant())
                I = saturate(I, term.coefficient.in_ring(I.ring()), run);
        }
    }
    return I;
}

Ring with_h(const Ring& ring) {
    std::vector<std::string> names = ring.names();
    std::string h = "h";
    while (ring.index_of(h)) h += '_';
    names.push_back(std::move(h));
    return {ring.field(), std::move(names)};
}

} // namespace

std::optional<std::vector<Polynomial>> homogenized_domain(const Parametrization& parametrization,
                                                          base::Run& run) {
    const Ring ring = parametrization.ring().with_order(MonomialOrder::degrevlex());
    std::vector<Polynomial> generators;
    for (const Polynomial& f : parametrization.relations()) generators.push_back(f.in_ring(ring));
    for (const Polynomial& f : parametrization.rotation_relations()) generators.push_back(f.in_ring(ring));
    Ideal domain(ring, std::move(generators));
    for (const Coordinate& coordinate : parametrization.coordinates()) {
        // The denominator as it was given: its zeros are not in the domain even if it could be cancelled.
        const Polynomial denominator = coordinate.value.denominator.in_ring(ring);
        if (!denominator.is_constant()) domain = saturate(domain, denominator, run);
    }
    domain = without_conditions_on_constants(parametrization, std::move(domain), run);
    if (domain.is_unit(run)) return std::nullopt;
    domain = radical(domain, run);

    const std::size_t n = ring.variable_count();
    const Ring extended = with_h(ring);
    const std::vector<std::uint64_t> by_parameters = indicator(n, parametrization.parameters());
    std::vector<std::uint64_t> by_parameters_and_h = by_parameters;
    by_parameters_and_h.push_back(1);
    std::vector<Polynomial> homogenized;
    for (const Polynomial& f : domain.groebner_basis(degree_order(by_parameters), run))
        homogenized.push_back(homogenize(f.in_ring(extended), n, by_parameters_and_h));
    if (parametrization.constants().empty()) return homogenized;

    // The graded map homogenises in the constants too.
    const MonomialOrder order = degree_order(indicator(n + 1, parametrization.constants()));
    const Ideal cone(extended, std::move(homogenized));
    return cone.groebner_basis(order, run);
}

} // namespace eliminant::implicit
