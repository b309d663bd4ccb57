#include "ideal/parameter_trick.hpp"

#include "ideal/ring_change.hpp"

#include <numeric>
#include <utility>

namespace eliminant::ideal {

using algebra::MonomialOrder;
using algebra::Polynomial;
using algebra::Ring;

namespace {

std::vector<std::string> with_t_in_front(const Ring& ring) {
    std::vector<std::string> names{fresh_name(ring, "t")};
    names.insert(names.end(), ring.names().begin(), ring.names().end());
    return names;
}

} // namespace

WithParameter::WithParameter(const Ring& base)
    : base_(base), ring_(base.field(), with_t_in_front(base), MonomialOrder::elimination({0})),
      into_(base.variable_count()) {
    std::iota(into_.begin(), into_.end(), std::size_t{1});
}

Ideal WithParameter::eliminate_t(std::vector<Polynomial> generators, base::Run& run) const {
    const MonomialOrder order = MonomialOrder::degrevlex();
    const Ring target = base_.with_order(order);
    std::vector<std::size_t> back(ring_.variable_count(), Polynomial::dropped);
    std::iota(back.begin() + 1, back.end(), std::size_t{0});
    std::vector<Polynomial> basis;
    for (const Polynomial& f : Ideal(ring_, std::move(generators)).groebner_basis(run)) {
        // In this order a leading monomial free of t has no smaller monomial with t. What remains of a
        // reduced basis is the reduced basis of the elimination ideal, in the order induced: degrevlex.
        if (f.exponent(0, 0) == 0) basis.push_back(f.in_ring(target, back));
    }
    return Ideal::from_groebner_basis(base_, order, std::move(basis));
}

} // namespace eliminant::ideal
