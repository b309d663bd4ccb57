#include "ideal/parameter_trick.hpp"

#include "eliminant/algebra/grading.hpp"
#include "eliminant/groebner/buchberger.hpp"
#include "ideal/ring_change.hpp"

#include <numeric>
#include <utility>

namespace eliminant::ideal {

using algebra::MonomialOrder;
using algebra::Polynomial;
using algebra::Ring;

namespace {

std::vector<std::string> with_t_and_h(const Ring& ring) {
    std::vector<std::string> names{fresh_name(ring, "t")};
    names.insert(names.end(), ring.names().begin(), ring.names().end());
    names.push_back(fresh_name(ring, "h"));
    return names;
}

} // namespace

WithParameter::WithParameter(const Ring& base)
    : base_(base), ring_(base.field(), with_t_and_h(base), MonomialOrder::elimination({0})) {}

Polynomial WithParameter::homogenized(const Polynomial& f) const {
    return homogenize(f.in_ring(ring_), last());
}

Ideal WithParameter::eliminate_t(std::vector<Polynomial> generators, base::Run& run) const {
    const MonomialOrder order = MonomialOrder::degrevlex();
    const Ring target = base_.with_order(order);
    std::vector<std::size_t> back(ring_.variable_count(), Polynomial::dropped);
    std::iota(back.begin() + 1, back.end() - 1, std::size_t{0});
    std::vector<Polynomial> basis;
    for (const Polynomial& f : Ideal(ring_, std::move(generators)).groebner_basis(run)) {
        // In this order a leading monomial free of t has no smaller monomial with t. What remains is a basis
        // of the elimination ideal in degrevlex, still one for h = 1.
        if (f.exponent(0, 0) == 0) basis.push_back(dehomogenize(f, last()).in_ring(target, back));
    }
    return Ideal::from_groebner_basis(base_, order, groebner::reduced_basis(std::move(basis), run));
}

} // namespace eliminant::ideal
