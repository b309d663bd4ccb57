#pragma once

#include "eliminant/scene/surface.hpp"

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/field/compiled_polynomial.hpp"
#include "eliminant/field/ray_roots.hpp"

#include <memory>

namespace eliminant::scene {

/// Traces a pencil of rays or parallel rays as one beam (field::ExactBeam); any other grid, degrees beyond
/// its kernels and polynomials with few terms for their degree (field::SparseRay) ray by ray.
///
/// \param f squarefree, not constant
/// \param roots of f
/// \param surface answers for single rays
std::unique_ptr<GridTracer> make_grid_tracer(const algebra::Polynomial& f,
                                             const field::CompiledPolynomial& compiled,
                                             const field::RayRoots& roots, const Surface& surface,
                                             const RayGrid& rays, const ClipRegion& clip, base::Run& run);

/// Traces any grid ray by ray. \throws DomainError as Surface::tracer
std::unique_ptr<GridTracer> make_ray_by_ray_tracer(const Surface& surface, const RayGrid& rays,
                                                   const ClipRegion& clip);

} // namespace eliminant::scene
