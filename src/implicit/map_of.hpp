// A parametrization as a rational map with free parameters.
#pragma once

#include "eliminant/implicit/parametrization.hpp"
#include "implicit/verify_domain.hpp"
#include "implicit/verify_map.hpp"

namespace eliminant::implicit {

/// The map of a parametrization without relations, in a ring of parameters, then constants.
RationalMap map_of(const Parametrization& parametrization, base::Run& run);

/// The same with a parameter, a variable of the parametrization's ring, as one more coordinate behind the
/// others (and before the constants). A parameter that is a cosine or a sine is one in half the angle.
RationalMap graph_of(const Parametrization& parametrization, std::size_t parameter, base::Run& run);

/// The same for a parametrization with relations.
DomainMap domain_of(const Parametrization& parametrization, base::Run& run);

} // namespace eliminant::implicit
