#include "eliminant/ideal/radical.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/calculus.hpp"
#include "eliminant/algebra/gcd.hpp"
#include "eliminant/ideal/dimension.hpp"
#include "eliminant/ideal/operations.hpp"
#include "eliminant/ideal/zero_dimensional.hpp"
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

using Variables = std::vector<std::size_t>; ///< ascending indices

Variables complement(const Variables& some, std::size_t variable_count) {
    Variables rest;
    for (std::size_t i = 0; i < variable_count; ++i) {
        if (!std::ranges::binary_search(some, i)) rest.push_back(i);
    }
    return rest;
}

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

/// The coefficients in K[U] of the leading monomials in the bound variables, for a basis in a product order
/// that puts the bound variables first. Constants are left out.
std::vector<Polynomial> leading_coefficients(std::span<const Polynomial> basis, const Variables& bound) {
    std::vector<Polynomial> result;
    for (const Polynomial& f : basis) {
        Polynomial coefficient(f.ring());
        const auto same_power = [&](std::size_t i) {
            return std::ranges::all_of(bound,
                                       [&](std::size_t x) { return f.exponent(i, x) == f.exponent(0, x); });
        };
        for (std::size_t i = 0; i < f.size() && same_power(i); ++i) {
            std::vector<std::uint64_t> exponents = f.monomial(i).exponents();
            for (const std::size_t x : bound) exponents[x] = 0;
            coefficient += Polynomial::term(algebra::Monomial(f.ring(), exponents), f.coefficient(i));
        }
        if (!coefficient.is_constant()) result.push_back(std::move(coefficient));
    }
    return result;
}

/// J·K(U)[bound] ∩ K[x]: J saturated by the leading coefficients of a Groebner basis of J over K(U), which a
/// basis in the product order is (Becker and Weispfenning, Proposition 8.94 and Lemma 8.91). A factor is
/// divided out once.
Ideal contraction(Ideal J, const Variables& bound, base::Run& run) {
    const MonomialOrder order = MonomialOrder::elimination(bound);
    Polynomial done = Polynomial::constant(J.ring(), 1);
    for (const Polynomial& c : leading_coefficients(J.groebner_basis(order, run), bound)) {
        const Polynomial factors = squarefree_part(c.in_ring(J.ring()), run);
        const Polynomial fresh = divide_exactly(factors, gcd(factors, done, run), run);
        J = saturate(J, fresh, run);
        done = multiply(done, fresh, run);
    }
    return J;
}

/// The intersection of those minimal primes of J modulo which a maximal set U of variables independent modulo
/// J is independent; nullopt where Seidenberg's lemma does not apply.
std::optional<Ideal> top_part_of_radical(const Ideal& J, base::Run& run) {
    const Ring& ring = J.ring();
    const Variables bound = complement(maximal_independent_set(J, run), ring.variable_count());
    std::vector<Polynomial> parts;
    for (const std::size_t x : bound) {
        auto part = separable_part(univariate_generator(J, bound, x, run), x, run);
        if (!part) return std::nullopt;
        parts.push_back(std::move(*part));
    }
    Ideal larger = sum(J, Ideal(ring, std::move(parts)));
    return bound.size() == ring.variable_count() ? larger : contraction(std::move(larger), bound, run);
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
        if (!radical_contains(I, g, run)) return &g;
    }
    return nullptr;
}

} // namespace

Ideal radical(const Ideal& I, base::Run& run) {
    // Another ideal with the same radical, and of smaller degree.
    std::vector<Polynomial> generators;
    for (const Polynomial& f : I.generators()) generators.push_back(squarefree_part(f, run));
    const Ideal start(I.ring(), std::move(generators));
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
