#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/algebra/gcd.hpp"
#include "eliminant/algebra/grading.hpp"
#include "eliminant/groebner/buchberger.hpp"
#include "eliminant/ideal/operations.hpp"
#include "ideal/parameter_trick.hpp"
#include "ideal/ring_change.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace eliminant::ideal {

using algebra::MonomialOrder;
using algebra::Polynomial;
using algebra::Ring;

namespace {

using Weights = std::vector<std::uint64_t>;

/// Positive weights for which I and f are homogeneous: all 1, or those of the ring's order.
std::optional<Weights> grading_of(const Ideal& I, const Polynomial& f) {
    for (const Weights& weights : {Weights(I.ring().variable_count(), 1), I.ring().order().weights()}) {
        const auto is_positive = [](std::uint64_t w) { return w > 0; };
        const auto is_homogeneous = [&](const Polynomial& g) { return algebra::is_homogeneous(g, weights); };
        if (!weights.empty() && std::ranges::all_of(weights, is_positive) && is_homogeneous(f) &&
            std::ranges::all_of(I.generators(), is_homogeneous))
            return weights;
    }
    return std::nullopt;
}

MonomialOrder revlex_order(const Weights& weights) {
    if (std::ranges::all_of(weights, [](std::uint64_t w) { return w == 1; }))
        return MonomialOrder::degrevlex();
    return MonomialOrder::weighted(weights, MonomialOrder::TieBreak::revlex);
}

/// f divided by the highest power of a variable that divides it.
Polynomial without_factor(const Polynomial& f, std::size_t variable) {
    std::uint64_t least = f.exponent(0, variable);
    for (std::size_t i = 1; i < f.size(); ++i) least = std::min(least, f.exponent(i, variable));
    if (least == 0) return f;
    std::vector<std::uint64_t> exponents(f.ring().variable_count(), 0);
    exponents[variable] = least;
    return divide_exactly(f, Polynomial::term(algebra::Monomial(f.ring(), exponents), 1));
}

/// I : x^∞ for homogeneous I. In weighted degrevlex with x last, x divides a homogeneous polynomial if it
/// divides its leading monomial; so dividing a Groebner basis by powers of x leaves one, that of the
/// saturation.
Ideal divide_out_variable(const Ideal& I, std::size_t variable, const Weights& weights, base::Run& run) {
    const std::size_t n = I.ring().variable_count();
    std::vector<std::size_t> sequence(n);
    std::iota(sequence.begin(), sequence.end(), std::size_t{0});
    sequence.erase(sequence.begin() + static_cast<std::ptrdiff_t>(variable));
    sequence.push_back(variable);
    Weights permuted;
    for (const std::size_t i : sequence) permuted.push_back(weights[i]);
    const Ring ring =
        subring(I.ring().with_order(MonomialOrder::degrevlex()), sequence).with_order(revlex_order(permuted));
    const bool is_last = variable + 1 == n;
    const std::vector<Polynomial> basis =
        is_last ? I.groebner_basis(ring.order(), run)
                : Ideal(ring, in_ring(I.generators(), ring)).groebner_basis(run);
    std::vector<Polynomial> divided;
    for (const Polynomial& f : basis) divided.push_back(without_factor(f, n - 1));
    if (divided == basis) return I;
    divided = groebner::reduced_basis(std::move(divided), run);
    if (is_last) return Ideal::from_groebner_basis(I.ring(), ring.order(), std::move(divided));
    return {I.ring(), in_ring(divided, I.ring())};
}

/// I : f^∞ for homogeneous I and f: f gets the name y, which is divided out of I + (y − f).
Ideal divide_out_polynomial(const Ideal& I, const Polynomial& f, Weights weights, base::Run& run) {
    weights.push_back(static_cast<std::uint64_t>(weighted_degree(f, weights)));
    std::vector<std::string> names = I.ring().names();
    names.push_back(fresh_name(I.ring(), "y"));
    const Ring ring(I.ring().field(), std::move(names), revlex_order(weights));
    const std::size_t y = I.ring().variable_count();
    std::vector<Polynomial> generators = in_ring(I.generators(), ring);
    generators.push_back(Polynomial::variable(ring, y) - f.in_ring(ring));
    const Ideal saturated = divide_out_variable(Ideal(ring, std::move(generators)), y, weights, run);
    std::vector<Polynomial> images = variables_of(I.ring());
    images.push_back(f);
    std::vector<Polynomial> result;
    for (const Polynomial& g : saturated.groebner_basis(run))
        result.push_back(compose(g, I.ring(), images, run));
    return {I.ring(), std::move(result)};
}

/// (g) : f^∞ for squarefree f: g without the factors that it shares with f.
Ideal divide_out_common_factors(Polynomial g, const Polynomial& f, base::Run& run) {
    for (Polynomial common = gcd(g, f, run); !common.is_constant(); common = gcd(g, common, run))
        g = divide_exactly(g, common, run);
    const Ring ring = g.ring();
    return {ring, {std::move(g)}};
}

/// (I + (1 − t·f)) ∩ K[x].
Ideal rabinowitsch(const Ideal& I, const Polynomial& f, base::Run& run) {
    const WithParameter extended(I.ring());
    std::vector<Polynomial> generators;
    // Homogenised generators may have components at infinity; those of a basis in a graded order have none.
    for (const Polynomial& g : I.some_groebner_basis(run)) generators.push_back(extended.homogenized(g));
    const auto degree = static_cast<std::uint64_t>(f.total_degree());
    generators.push_back(pow(extended.h(), degree + 1, run) -
                         multiply(extended.t(), extended.homogenized(f), run));
    return extended.eliminate_t(std::move(generators), run);
}

} // namespace

Ideal saturate(const Ideal& I, const Polynomial& f, base::Run& run) {
    require_same_ring(I.ring(), f.ring(), "saturation of an ideal by a polynomial");
    if (f.is_zero()) return Ideal::unit(I.ring());
    if (I.is_zero() || f.is_constant()) return I;
    Polynomial rest = squarefree_part(f, run);
    if (I.generators().size() == 1) return divide_out_common_factors(I.generators().front(), rest, run);
    Ideal result = I;
    for (std::size_t i = 0; i < I.ring().variable_count(); ++i) {
        Polynomial cofactor = without_factor(rest, i);
        if (cofactor == rest) continue;
        rest = std::move(cofactor);
        const Polynomial variable = Polynomial::variable(I.ring(), i);
        const auto grading = grading_of(result, variable);
        result =
            grading ? divide_out_variable(result, i, *grading, run) : rabinowitsch(result, variable, run);
    }
    if (rest.is_constant()) return result;
    const auto grading = grading_of(result, rest);
    return grading ? divide_out_polynomial(result, rest, *grading, run) : rabinowitsch(result, rest, run);
}

Ideal saturate(const Ideal& I, const Ideal& J, base::Run& run) {
    require_same_ring(I.ring(), J.ring(), "saturation of an ideal by an ideal");
    Ideal result = Ideal::unit(I.ring());
    for (const Polynomial& f : J.generators()) {
        const Ideal part = saturate(I, f, run);
        if (I.contains(part, run)) return I; // no saturation is smaller than I
        result = intersect(result, part, run);
    }
    return result;
}

} // namespace eliminant::ideal
