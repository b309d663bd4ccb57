/// \file
/// From a point to the surface.
#pragma once

#include "eliminant/field/distance.hpp"

#include <glm/vec3.hpp>

#include <optional>

namespace eliminant::field {

/// A point next to the surface, with a proof that it is, and what follows for the distance of the point that
/// was projected.
struct Projection {
    glm::dvec3 foot{0};
    /// The surface has a point within this distance of `foot`: f changes its sign, exactly computed, on a
    /// segment through it of half this length, or is 0 there. About the spacing of doubles around `foot`
    /// where ∇f ≠ 0.
    double radius = 0;
    /// lower ≤ distance of the point ≤ upper: the guaranteed bound, and ‖point − foot‖ + radius, rounded
    /// outward.
    double lower = 0;
    double upper = 0;
};

/// The foot of the perpendicular from a point to the surface, to which Newton's iteration leads from it:
/// first down the gradient to the surface, then along it to where point − foot is normal to it (∇‖point − q‖²
/// and ∇f parallel). It need not be the nearest point; `lower` tells how much nearer another one can be.
///
/// Nothing if the iteration ends nowhere near the surface or f does not change its sign there, as for f = g²
/// or an isolated point; and for a point that is not finite.
std::optional<Projection> project(const DistanceField& field, const glm::dvec3& point);

} // namespace eliminant::field

namespace eliminant {
using field::project;
using field::Projection;
} // namespace eliminant
