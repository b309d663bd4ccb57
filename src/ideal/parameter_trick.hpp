// Elimination of one auxiliary variable t, the device behind intersections and saturations.
#pragma once

#include "eliminant/ideal/ideal.hpp"

#include <cstddef>
#include <vector>

namespace eliminant::ideal {

/// K[t, x, h] for the ring K[x], in the product order that eliminates t, with degrevlex on x and h.
///
/// All is homogenised by h, for the reason given at groebner::convert_basis(): the intersection of two ideals
/// of dimension 3 and degree 8 over GF(32003) takes 0.03 s instead of 0.09.
class WithParameter {
  public:
    explicit WithParameter(const algebra::Ring& base);

    const algebra::Ring& ring() const { return ring_; }
    algebra::Polynomial t() const { return algebra::Polynomial::variable(ring_, std::size_t{0}); }
    algebra::Polynomial h() const { return algebra::Polynomial::variable(ring_, last()); }
    /// f ∈ K[x], in whatever order, homogenised by h.
    algebra::Polynomial homogenized(const algebra::Polynomial& f) const;
    /// The ideal of the generators, which are homogeneous, with h = 1, intersected with K[x].
    Ideal eliminate_t(std::vector<algebra::Polynomial> generators, base::Run& run) const;

  private:
    std::size_t last() const { return base_.variable_count() + 1; }

    algebra::Ring base_;
    algebra::Ring ring_;
};

} // namespace eliminant::ideal
