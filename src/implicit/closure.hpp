// From a homogeneous kernel back to equations of the image.
#pragma once

#include "eliminant/implicit/implicitize.hpp"
#include "implicit/graded_map.hpp"

#include <span>
#include <vector>

namespace eliminant::implicit {

/// ℚ[coordinates, constants] in the product of `order` on the coordinates and degrevlex on the constants.
algebra::Ring closure_ring(const Parametrization& parametrization, const algebra::MonomialOrder& order);

/// An equation, in a closure_ring(), between coordinates of which each is to be multiplied by its scale: the
/// equation between the products, cleared to integers, without factors in ℤ[constants].
algebra::Polynomial with_scales(const algebra::Polynomial& f, std::span<const Scale> scales, base::Run& run);

/// Elements of the kernel with 1 for the homogenising variables, and in the coordinates as they were before
/// the scales were taken out; of `ring`, cleared to integers, without factors in ℤ[constants].
std::vector<algebra::Polynomial> dehomogenized(const ProjectiveMap& map, const GradedMap& graded,
                                               std::span<const algebra::Polynomial> kernel,
                                               const algebra::Ring& ring, base::Run& run);

/// The reduced Groebner basis over ℚ(constants) of the ideal that polynomials of a closure_ring() generate,
/// ascending by leading monomial, each element cleared to a primitive one over ℤ[constants].
std::vector<algebra::Polynomial> reduced_closure_basis(const Parametrization& parametrization,
                                                       const algebra::Ring& ring,
                                                       std::span<const algebra::Polynomial> generators,
                                                       base::Run& run);

/// Number of coordinates minus the dimension over ℚ(constants) of an ideal with this Groebner basis.
std::size_t closure_codimension(const Parametrization& parametrization,
                                std::span<const algebra::Polynomial> basis, base::Run& run);

} // namespace eliminant::implicit
