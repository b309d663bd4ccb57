// The domain of a parametrization with relations.
#pragma once

#include "implicit/projective_map.hpp"

#include <optional>
#include <vector>

namespace eliminant::implicit {

/// The radical ideal of the closure of the domain, over the field of constants, homogenised in the parameters
/// by a variable h: homogeneous polynomials of the parametrization's ring with h added last. nullopt if the
/// domain is empty.
///
/// Components of the relations on which a denominator is zero are no part of the domain, nor are those on
/// which the constants would satisfy an equation; both are removed by saturation. What remains has neither a
/// denominator nor, homogenised, h as a zero divisor, which is what the kernel of the graded map needs. The
/// kernel is radical because this ideal is: taking the radical here, of few relations of low degree, is the
/// cheaper way.
std::optional<std::vector<algebra::Polynomial>> homogenized_domain(const Parametrization& parametrization,
                                                                   base::Run& run);

} // namespace eliminant::implicit
