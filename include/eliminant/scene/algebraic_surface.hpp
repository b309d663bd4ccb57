/// \file
/// Algebraic surfaces for renderers.
#pragma once

#include "eliminant/scene/surface.hpp"

#include "eliminant/algebra/polynomial.hpp"

#include <memory>

namespace eliminant::scene {

/// The surface f = 0. The ring's variables are the coordinates x, y, z in their sequence; a ring of two
/// variables gives a cylinder along z. Repeated factors of f do not change where the surface is; hits are
/// found with its squarefree part, so `side` and `crossing` are about the sign of that part, which agrees
/// with the sign of f up to the squares taken out.
///
/// Queries are certified: a ray has a hit if and only if the polynomial has a real root on the closed
/// interval. f = 0 makes every ray `contained`, any other constant makes every ray a miss.
///
/// \throws DomainError if f is not over ℚ or its ring has not one to three variables
std::unique_ptr<Surface> algebraic_surface(const algebra::Polynomial& f, base::Run& run);

} // namespace eliminant::scene

namespace eliminant {
using scene::algebraic_surface;
} // namespace eliminant
