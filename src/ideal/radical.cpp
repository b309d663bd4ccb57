#include "eliminant/ideal/radical.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/calculus.hpp"
#include "eliminant/algebra/gcd.hpp"
#include "eliminant/ideal/dimension.hpp"
#include "eliminant/ideal/operations.hpp"
#include "eliminant/ideal/zero_dimensional.hpp"
#include "ideal/generic_fibre.hpp"
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

/// A polynomial in K[U, x] that generates the ideal of J in K(U)[x], for U independent modulo J, x a bound
/// variable and `bound` all bound variables, finitely many of whose monomials are standard over K(U).
Polynomial univariate_generator(const Ideal& J, const Variables& bound, std::size_t x, base::Run& run) {
    const Ring& ring = J.ring();
    if (bound.size() == ring.variable_count()) {
        const Polynomial minimal = minimal_polynomial(J, Polynomial::variable(ring, x), run);
        return minimal.in_ring(ring, Variables{x});
    }
    Variables others = bound;
    std::erase(others, x);
    const Ideal E = eliminate(J, others, run);
    // K(U)[x] is a principal ideal domain, and by Gauss's lemma the gcd there is the one in K[U, x] but for a
    // factor in K[U].
    return gcd(E.generators(), run).in_ring(ring);
}

/// The squarefree part of f over K(U), up to a factor in K(U); nullopt if it has multiple roots in x in the
/// algebraic closure all the same.
std::optional<Polynomial> separable_part(const Polynomial& f, std::size_t x, base::Run& run) {
    Polynomial part = squarefree_part(f, run);
    if (f.ring().field().is_rationals()) return part;
    const Polynomial common = gcd(part, derivative(part, x), run);
    if (common.degree(x) > 0) return std::nullopt;
    return part;
}

/// J·K(U)[bound] ∩ K[x]: J saturated by the leading coefficients of a Groebner basis of J over K(U), which a
/// basis in the product order is (Becker and Weispfenning, Proposition 8.94 and Lemma 8.91). A factor is
/// divided out once.
Ideal contraction(Ideal J, const Variables& bound, base::Run& run) {
    const MonomialOrder order = MonomialOrder::elimination(bound);
    Polynomial done = Polynomial::constant(J.ring(), 1);
    const std::vector<Polynomial> basis = J.groebner_basis(order, run);
    for (const Polynomial& f : basis) {
        const Polynomial c = leading_coefficient_over(f, bound);
        if (c.is_constant()) continue;
        const Polynomial factors = squarefree_part(c.in_ring(J.ring()), run);
        const Polynomial fresh = divide_exactly(factors, gcd(factors, done, run), run);
        J = saturate(J, fresh, run);
        done = multiply(done, fresh, run);
    }
    return J;
}

/// The intersection of those minimal primes of J modulo which a maximal set U of variables independent modulo
/// J is independent; nullopt where Seidenberg's lemma does not apply.
std::optional<Ideal> top_part_of_radical(Ideal J, base::Run& run) {
    const Ring ring = J.ring();
    const Variables bound = complement(maximal_independent_set(J, run), ring.variable_count());
    Variables unproved = bound; // variables without a separable polynomial in J·K(U)[bound] so far
    while (!unproved.empty()) {
        const auto suspects = suspects_of_multiplicity(J, bound, run);
        if (suspects && suspects->empty()) break;
        // A suspect that was dealt with has its multiple factor on this fibre only.
        const Variables first = suspects.value_or(Variables());
        const auto is_unproved = [&](std::size_t i) { return std::ranges::binary_search(unproved, i); };
        const auto suspect = std::ranges::find_if(first, is_unproved);
        const std::size_t x = suspect == first.end() ? unproved.front() : *suspect;
        auto part = separable_part(univariate_generator(J, bound, x, run), x, run);
        if (!part) return std::nullopt;
        J = sum(J, Ideal(ring, {std::move(*part)}));
        std::erase(unproved, x);
    }
    return bound.size() == ring.variable_count() ? J : contraction(std::move(J), bound, run);
}

/// {f : f^p ∈ I} over GF(p): the inverse image of I under x_i ↦ x_i^p, by elimination from its graph.
Ideal frobenius_preimage(const Ideal& I, base::Run& run) {
    const Ring& ring = I.ring();
    const std::size_t n = ring.variable_count();
    // The sources come last and keep their names; each target y_i = x_i gets a fresh one.
    std::vector<std::string> names = ring.names();
    for (std::size_t i = 0; i < n; ++i)
        names.insert(names.begin() + static_cast<std::ptrdiff_t>(i),
                     fresh_name(Ring(ring.field(), names), "y"));
    const Ring graph(ring.field(), std::move(names));
    Variables targets(n);
    std::iota(targets.begin(), targets.end(), std::size_t{0});
    std::vector<Polynomial> generators;
    for (const Polynomial& f : I.some_groebner_basis(run)) generators.push_back(f.in_ring(graph, targets));
    for (std::size_t i = 0; i < n; ++i) {
        const Polynomial y = Polynomial::variable(graph, i);
        generators.push_back(pow(y, ring.field().characteristic(), run) - Polynomial::variable(graph, n + i));
    }
    const Ideal preimage = eliminate(Ideal(graph, std::move(generators)), targets, run);
    return {ring, in_ring(preimage.generators(), ring)};
}

Ideal radical_by_frobenius(Ideal I, base::Run& run) {
    for (;;) {
        Ideal larger = frobenius_preimage(I, run);
        if (I.contains(larger, run)) return I;
        I = std::move(larger);
    }
}

/// An element of P that is not in the radical of I, if there is one.
const Polynomial* element_outside_radical(const Ideal& P, const Ideal& I, base::Run& run) {
    for (const Polynomial& g : P.generators()) {
        if (!I.contains(g, run) && !radical_contains(I, g, run)) return &g;
    }
    return nullptr;
}

} // namespace

Ideal radical(const Ideal& I, base::Run& run) {
    // Another ideal with the same radical, and of smaller degree.
    std::vector<Polynomial> generators;
    for (const Polynomial& f : I.generators()) generators.push_back(squarefree_part(f, run));
    Ideal start(I.ring(), std::move(generators));
    if (start.generators().size() <= 1) return start;
    Ideal P = Ideal::unit(I.ring());
    while (const Polynomial* g = element_outside_radical(P, start, run)) {
        const std::optional<Ideal> part = top_part_of_radical(saturate(start, *g, run), run);
        if (!part) return radical_by_frobenius(start, run);
        P = intersect(P, *part, run);
    }
    return P;
}

} // namespace eliminant::ideal
