// A parametrization as a rational map with free parameters.
#pragma once

#include "eliminant/implicit/parametrization.hpp"
#include "implicit/verify_map.hpp"

namespace eliminant::implicit {

/// The map of a parametrization without relations, in a ring of parameters, then constants.
RationalMap map_of(const Parametrization& parametrization, base::Run& run);

} // namespace eliminant::implicit
