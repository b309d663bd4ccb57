// Elimination of one auxiliary variable t, the device behind intersections, saturations and radical
// membership.
#pragma once

#include "eliminant/ideal/ideal.hpp"

#include <cstddef>
#include <vector>

namespace eliminant::ideal {

/// K[t, x] for the ring K[x], in the product order that eliminates t, with degrevlex on x.
class WithParameter {
  public:
    explicit WithParameter(const algebra::Ring& base);

    const algebra::Ring& ring() const { return ring_; }
    algebra::Polynomial t() const { return algebra::Polynomial::variable(ring_, std::size_t{0}); }
    algebra::Polynomial one() const { return algebra::Polynomial::constant(ring_, 1); }
    /// f ∈ K[x], in whatever order, as an element of ring().
    algebra::Polynomial embed(const algebra::Polynomial& f) const { return f.in_ring(ring_, into_); }
    /// The ideal of the generators, which are of ring(), intersected with K[x].
    Ideal eliminate_t(std::vector<algebra::Polynomial> generators, base::Run& run) const;

  private:
    algebra::Ring base_;
    algebra::Ring ring_;
    std::vector<std::size_t> into_;
};

} // namespace eliminant::ideal
