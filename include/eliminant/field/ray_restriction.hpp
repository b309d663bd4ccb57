/// \file
/// Polynomials of space on rays.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <glm/vec3.hpp>
#include <gmpxx.h>

#include <vector>

namespace eliminant::field {

/// The polynomial t ↦ f(origin + t·direction) times a positive number, exactly, for the doubles as they are:
/// integer coefficients from t^0 to t^deg(f), leading zeros included; a single 0 for f = 0.
///
/// O(n⁴/24) operations on integers for degree n.
/// \throws DomainError over GF(p), for more than three variables, or for coordinates that are not finite
std::vector<mpz_class> restrict_to_ray(const algebra::Polynomial& f, const glm::dvec3& origin,
                                       const glm::dvec3& direction, base::Run& run);

} // namespace eliminant::field

namespace eliminant {
using field::restrict_to_ray;
} // namespace eliminant
