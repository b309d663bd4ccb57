/// \file
/// Distances where doubles do not suffice.
#pragma once

#include "eliminant/field/distance.hpp"

namespace eliminant::field {

/// The value alone, f not being 0 at the point, which is finite: by two doubles, 256 bits and at last
/// rationals.
double precise_distance(const DistanceField& field, const glm::dvec3& point, DistanceLevel level);

} // namespace eliminant::field
