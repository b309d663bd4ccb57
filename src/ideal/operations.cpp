#include "eliminant/ideal/operations.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/gcd.hpp"
#include "eliminant/groebner/buchberger.hpp"
#include "groebner/change_of_order.hpp"
#include "ideal/parameter_trick.hpp"
#include "ideal/ring_change.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace eliminant::ideal {

using algebra::MonomialOrder;
using algebra::Polynomial;
using algebra::Ring;

Ideal sum(const Ideal& I, const Ideal& J) {
    require_same_ring(I.ring(), J.ring(), "sum of ideals");
    std::vector<Polynomial> generators = I.generators();
    generators.insert(generators.end(), J.generators().begin(), J.generators().end());
    return {I.ring(), std::move(generators)};
}

Ideal product(const Ideal& I, const Ideal& J, base::Run& run) {
    require_same_ring(I.ring(), J.ring(), "product of ideals");
    std::vector<Polynomial> generators;
    for (const Polynomial& f : I.generators()) {
        for (const Polynomial& g : J.generators()) generators.push_back(multiply(f, g, run));
    }
    return {I.ring(), std::move(generators)};
}

Ideal power(const Ideal& I, std::uint64_t exponent, base::Run& run) {
    if (exponent == 0) return Ideal::unit(I.ring());
    if (I.is_zero()) return I;
    // Products f_i·f_j·… with i ≤ j ≤ …: those that end with f_k are continued by f_k and what follows it.
    const std::vector<Polynomial>& generators = I.generators();
    std::vector<std::vector<Polynomial>> ending_with;
    for (const Polynomial& f : generators) ending_with.push_back({f});
    for (std::uint64_t k = 1; k < exponent; ++k) {
        std::vector<std::vector<Polynomial>> longer(generators.size());
        for (std::size_t last = 0; last < generators.size(); ++last) {
            for (std::size_t before = 0; before <= last; ++before) {
                for (const Polynomial& f : ending_with[before])
                    longer[last].push_back(multiply(f, generators[last], run));
            }
        }
        ending_with = std::move(longer);
    }
    std::vector<Polynomial> products;
    for (auto& some : ending_with) std::ranges::move(some, std::back_inserter(products));
    return {I.ring(), std::move(products)};
}

Ideal intersect(const Ideal& I, const Ideal& J, base::Run& run) {
    require_same_ring(I.ring(), J.ring(), "intersection of ideals");
    if (I.generators().size() == 1 && J.generators().size() == 1)
        return {I.ring(), {lcm(I.generators().front(), J.generators().front(), run)}};
    if (I.contains(J, run)) return J;
    if (J.contains(I, run)) return I;
    const WithParameter extended(I.ring());
    const Polynomial t = extended.t();
    const Polynomial complement = extended.h() - t;
    std::vector<Polynomial> generators;
    for (const Polynomial& f : I.some_groebner_basis(run))
        generators.push_back(multiply(t, extended.homogenized(f), run));
    for (const Polynomial& f : J.some_groebner_basis(run))
        generators.push_back(multiply(complement, extended.homogenized(f), run));
    return extended.eliminate_t(std::move(generators), run);
}

Ideal intersect(std::span<const Ideal> ideals, base::Run& run) {
    if (ideals.empty()) throw DomainError("intersection of ideals: there are none, so no ring either");
    Ideal result = ideals.front();
    for (const Ideal& J : ideals.subspan(1)) result = intersect(result, J, run);
    return result;
}

Ideal quotient(const Ideal& I, const Polynomial& f, base::Run& run) {
    require_same_ring(I.ring(), f.ring(), "quotient of an ideal by a polynomial");
    if (f.is_constant()) return f.is_zero() ? Ideal::unit(I.ring()) : I;
    if (I.is_zero()) return I; // the ring is a domain
    if (I.generators().size() == 1) {
        const Polynomial& g = I.generators().front();
        return {I.ring(), {divide_exactly(g, gcd(g, f, run), run)}};
    }
    if (I.contains(f, run)) return Ideal::unit(I.ring());
    const Ideal multiples = intersect(I, Ideal(I.ring(), {f}), run);
    const MonomialOrder order = MonomialOrder::degrevlex();
    const Polynomial divisor = f.in_ring(I.ring().with_order(order));
    std::vector<Polynomial> quotients;
    for (const Polynomial& g : multiples.groebner_basis(order, run))
        quotients.push_back(divide_exactly(g, divisor, run));
    // Leading monomials are multiplicative, so this is a Groebner basis; only its tails need reduction.
    return Ideal::from_groebner_basis(I.ring(), order, groebner::reduced_basis(std::move(quotients), run));
}

Ideal quotient(const Ideal& I, const Ideal& J, base::Run& run) {
    require_same_ring(I.ring(), J.ring(), "quotient of ideals");
    Ideal result = Ideal::unit(I.ring());
    for (const Polynomial& f : J.generators()) {
        const Ideal part = quotient(I, f, run);
        if (I.contains(part, run)) return I; // no quotient is smaller than I
        result = intersect(result, part, run);
    }
    return result;
}

Ideal eliminate(const Ideal& I, std::span<const std::size_t> variables, base::Run& run) {
    const std::size_t n = I.ring().variable_count();
    const std::set<std::size_t> eliminated(variables.begin(), variables.end());
    if (eliminated.empty()) return I;
    if (*eliminated.rbegin() >= n)
        throw DomainError("elimination: there is no variable of index " +
                          std::to_string(*eliminated.rbegin()) + " in " + I.ring().to_string());
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < n; ++i) {
        if (!eliminated.contains(i)) kept.push_back(i);
    }
    const auto order = MonomialOrder::elimination({eliminated.begin(), eliminated.end()});
    const Ring target = subring(I.ring(), kept);
    const Ring graded = target.with_order(MonomialOrder::degrevlex());
    if (auto changed = groebner::change_order(I.some_groebner_basis(run), graded, groebner::Proof::full, run))
        return Ideal::from_groebner_basis(target, graded.order(), std::move(changed->elements));
    const std::vector<std::size_t> map = map_to_subring(I.ring(), kept);
    std::vector<Polynomial> basis;
    for (const Polynomial& f : I.groebner_basis(order, run)) {
        const auto occurs = [&](std::size_t i) { return f.exponent(0, i) != 0; };
        if (std::ranges::none_of(eliminated, occurs)) basis.push_back(f.in_ring(graded, map));
    }
    return Ideal::from_groebner_basis(target, graded.order(), std::move(basis));
}

bool radical_contains(const Ideal& I, const Polynomial& f, base::Run& run) {
    require_same_ring(I.ring(), f.ring(), "membership in the radical of an ideal");
    if (f.is_zero()) return true;
    if (I.is_zero()) return false;
    std::vector<std::string> names = I.ring().names();
    names.push_back(fresh_name(I.ring(), "t"));
    const Ring ring(I.ring().field(), std::move(names));
    std::vector<Polynomial> generators = in_ring(I.known_generators(), ring);
    const Polynomial t = Polynomial::variable(ring, I.ring().variable_count());
    generators.push_back(Polynomial::constant(ring, 1) - multiply(t, f.in_ring(ring), run));
    return Ideal(ring, std::move(generators)).is_unit(run);
}

} // namespace eliminant::ideal
