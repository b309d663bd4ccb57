/// \file
/// How a surface bends.
#pragma once

#include "eliminant/field/compiled_polynomial.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <optional>

namespace eliminant::field {

/// Curvatures of the level surface of f through a point. A curvature is positive where the surface bends away
/// from its normal ∇f/‖∇f‖, as a sphere x²+y²+z² = r² does: there all are 1/r, and 1/r² is the Gaussian one.
struct Curvatures {
    double mean = 0;                   ///< (κ₁ + κ₂)/2
    double gaussian = 0;               ///< κ₁ κ₂
    std::array<double, 2> principal{}; ///< κ₁ ≥ κ₂
    std::array<glm::dvec3, 2> directions{}; ///< of κ₁ and κ₂; with the normal orthonormal. Any at an umbilic.
    glm::dvec3 normal{0};                   ///< ∇f/‖∇f‖
};

/// From gradient and Hessian: the eigenvalues of P·Hess f·P/‖∇f‖ on the tangent plane, P being the projection
/// to it (Goldman 2005). Nothing where ∇f is 0 or a number is not finite.
std::optional<Curvatures> curvatures(const Jet& jet);

} // namespace eliminant::field

namespace eliminant {
using field::Curvatures;
using field::curvatures;
} // namespace eliminant
