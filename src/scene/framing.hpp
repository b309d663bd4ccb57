#pragma once

#include "eliminant/scene/surface.hpp"

#include "eliminant/algebra/polynomial.hpp"

#include <glm/vec3.hpp>

namespace eliminant::scene {

/// Where the part of the highest degree outweighs all others together, in mean squares over the sphere:
/// farther out a surface is close to its cone of asymptotes, and looks the same at every scale. 1 if that
/// cannot be told.
double asymptotic_radius(const algebra::Polynomial& f);

/// The point about which the part of f of second highest degree is smallest, in Bombieri's norm: where the
/// surface is in the middle of its asymptotes, as the centre of a quadric. It moves and turns with the
/// surface. Coordinates on which that part does not depend are told by lower parts, or are 0; the origin if
/// the difference is rounding.
glm::dvec3 center_of(const algebra::Polynomial& f);

/// A ball that shows the surface of f, about its center_of(). If it seems bounded, because it does not pass
/// through a far sphere and a bundle of rays meets it in some ball but not in the next ones of twice the
/// size, all hits of a finer bundle are in it. Else it reaches as far as the asymptotes need and clearly
/// farther than the surface is from the centre.
///
/// Some thousand rays and values: heuristic, but bounded work.
Ball frame(const Surface& surface, const algebra::Polynomial& f, base::Run& run);

} // namespace eliminant::scene
