// Hypersurfaces that are cylinders because a parameter only moves points along a line.
#pragma once

#include "implicit/verify_map.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace eliminant::implicit {

/// Where a parameter w occurs only as w·a with a constant vector a, the image is a cylinder along a: with a_j
/// ≠ 0 its equation is one between yᵢ = xᵢ − (aᵢ/a_j)·x_j, i ≠ j, which w does not occur in. A coordinate and
/// a parameter less make any method faster: `ES_8` of Abbott, Bigatti and Robbiano takes 15 s as it stands,
/// and 1 s as a cylinder.
struct Cylinder {
    RationalMap base;             ///< the map to the yᵢ
    std::size_t removed;          ///< j
    std::vector<mpq_class> slope; ///< aᵢ/a_j, one a coordinate xᵢ; 0 for constants
};

/// nullopt if there is no such parameter, or the base would be one of points on a line.
std::optional<Cylinder> as_cylinder(const RationalMap& map);

/// The ring of the base's coordinates.
algebra::Ring base_ring(const Cylinder& cylinder, const algebra::Ring& ring);

/// The equation of the cylinder, primitive, from that of its base.
algebra::Polynomial lifted(const Cylinder& cylinder, const algebra::Polynomial& equation,
                           const algebra::Ring& ring, base::Run& run);

} // namespace eliminant::implicit
