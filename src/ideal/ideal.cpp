#include "eliminant/ideal/ideal.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/groebner/groebner_basis.hpp"
#include "groebner/graded_order.hpp"
#include "ideal/ring_change.hpp"

#include <algorithm>
#include <list>
#include <mutex>
#include <utility>

namespace eliminant::ideal {

using algebra::MonomialOrder;
using algebra::Polynomial;
using algebra::Ring;

/// What the copies of an ideal share. Bases are only ever added, to a list, so that references to them stay
/// valid; the lock is held to look and to add, never while a basis is computed.
class Ideal::State {
  public:
    State(Ring r, std::vector<Polynomial> g) : ring(std::move(r)), generators(std::move(g)) {}

    const std::vector<Polynomial>* find(const MonomialOrder& order) const {
        const std::lock_guard lock(mutex_);
        return find_locked(order);
    }
    const std::vector<Polynomial>* find_any() const {
        const std::lock_guard lock(mutex_);
        return bases_.empty() ? nullptr : &bases_.front().elements;
    }
    /// Keeps the basis unless another thread was faster; the kept one either way.
    const std::vector<Polynomial>& keep(const MonomialOrder& order, std::vector<Polynomial> elements) const {
        const std::lock_guard lock(mutex_);
        if (const auto* known = find_locked(order)) return *known;
        return bases_.emplace_back(order, std::move(elements)).elements;
    }

    const Ring ring;
    const std::vector<Polynomial> generators;

  private:
    struct Basis {
        Basis(MonomialOrder o, std::vector<Polynomial> e) : order(std::move(o)), elements(std::move(e)) {}
        MonomialOrder order;
        std::vector<Polynomial> elements;
    };

    const std::vector<Polynomial>* find_locked(const MonomialOrder& order) const {
        const auto found = std::ranges::find(bases_, order, &Basis::order);
        return found == bases_.end() ? nullptr : &found->elements;
    }

    mutable std::mutex mutex_;
    mutable std::list<Basis> bases_;
};

Ideal::Ideal(std::shared_ptr<const State> state) : state_(std::move(state)) {}

Ideal::Ideal(Ring ring) : Ideal(std::move(ring), {}) {}

Ideal::Ideal(Ring ring, std::vector<Polynomial> generators) {
    for (const Polynomial& f : generators) require_same_ring(ring, f.ring(), "generators of an ideal");
    std::erase_if(generators, [](const Polynomial& f) { return f.is_zero(); });
    state_ = std::make_shared<const State>(std::move(ring), std::move(generators));
}

Ideal Ideal::unit(const Ring& ring) { return {ring, {Polynomial::constant(ring, 1)}}; }

Ideal Ideal::from_groebner_basis(const Ring& ring, const MonomialOrder& order,
                                 std::vector<Polynomial> basis) {
    for (const Polynomial& f : basis)
        require_same_ring(ring.with_order(order), f.ring(), "ideal of a Groebner basis");
    auto state = std::make_shared<const State>(ring, in_ring(basis, ring));
    state->keep(order, std::move(basis));
    return Ideal(std::move(state));
}

const Ring& Ideal::ring() const { return state_->ring; }
const std::vector<Polynomial>& Ideal::generators() const& { return state_->generators; }
std::vector<Polynomial> Ideal::generators() && { return state_->generators; }

const std::vector<Polynomial>& Ideal::groebner_basis(const MonomialOrder& order, base::Run& run) const& {
    if (const auto* known = state_->find(order)) return *known;
    const Ring target = ring().with_order(order);
    const std::vector<Polynomial> own = in_ring(generators(), target);
    if (groebner::is_cheaper_by_graded_basis(target, own)) {
        const std::vector<Polynomial>& graded = groebner_basis(MonomialOrder::degrevlex(), run);
        return state_->keep(order, groebner::convert_basis(target, graded, {}, run).elements);
    }
    const std::vector<Polynomial> known =
        groebner::weights_compared_first(target) ? in_ring(known_generators(), target) : own;
    return state_->keep(order, groebner::groebner_basis(target, known, {}, run).elements);
}
std::vector<Polynomial> Ideal::groebner_basis(const MonomialOrder& order, base::Run& run) && {
    return std::as_const(*this).groebner_basis(order, run);
}
const std::vector<Polynomial>& Ideal::groebner_basis(base::Run& run) const& {
    return groebner_basis(ring().order(), run);
}
std::vector<Polynomial> Ideal::groebner_basis(base::Run& run) && {
    return std::as_const(*this).groebner_basis(run);
}

const std::vector<Polynomial>& Ideal::known_generators() const& {
    // From a basis in a cheap order one in another order is found sooner than from the generators: its
    // elements of low degree would have to be found again. A basis in an expensive order may be much larger
    // than either.
    if (const auto* known = state_->find(groebner::cheap_order(ring()))) return *known;
    if (const auto* known = state_->find(MonomialOrder::degrevlex())) return *known;
    return generators();
}

const std::vector<Polynomial>& Ideal::some_groebner_basis(base::Run& run) const& {
    if (const auto* known = state_->find(groebner::cheap_order(ring()))) return *known;
    if (const auto* known = state_->find_any()) return *known;
    return groebner_basis(groebner::cheap_order(ring()), run);
}

Polynomial Ideal::normal_form(const Polynomial& f, base::Run& run) const {
    require_same_ring(ring(), f.ring(), "normal form modulo an ideal");
    return algebra::normal_form(f, groebner_basis(run), run);
}

bool Ideal::contains(const Polynomial& f, base::Run& run) const {
    require_same_ring(ring(), f.ring(), "membership in an ideal");
    if (f.is_zero()) return true;
    if (is_zero()) return false;
    const std::vector<Polynomial>& basis = some_groebner_basis(run);
    return algebra::normal_form(f.in_ring(basis.front().ring()), basis, run).is_zero();
}

bool Ideal::contains(const Ideal& other, base::Run& run) const {
    require_same_ring(ring(), other.ring(), "inclusion of ideals");
    if (state_ == other.state_) return true;
    return std::ranges::all_of(other.generators(), [&](const Polynomial& f) { return contains(f, run); });
}

bool Ideal::equals(const Ideal& other, base::Run& run) const {
    require_same_ring(ring(), other.ring(), "equality of ideals");
    if (state_ == other.state_) return true;
    if (is_zero() || other.is_zero()) return is_zero() == other.is_zero();
    // Reduced bases are unique for each order; whichever order *this has at hand will do.
    const MonomialOrder& order = some_groebner_basis(run).front().ring().order();
    return groebner_basis(order, run) == other.groebner_basis(order, run);
}

bool Ideal::is_unit(base::Run& run) const {
    if (is_zero()) return false;
    if (std::ranges::any_of(generators(), &Polynomial::is_constant)) return true;
    return some_groebner_basis(run).front().is_constant();
}

bool Ideal::is_homogeneous(base::Run& run) const {
    // The reduced basis of a homogeneous ideal is homogeneous: reduction and normalisation stay in a degree.
    return std::ranges::all_of(generators(), &Polynomial::is_homogeneous) ||
           std::ranges::all_of(some_groebner_basis(run), &Polynomial::is_homogeneous);
}

} // namespace eliminant::ideal
