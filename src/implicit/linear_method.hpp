// Implicit equations by linear algebra on values of monomials.
#pragma once

#include "implicit/hypersurface.hpp"

namespace eliminant::implicit {

/// The polynomial of least degree that vanishes at general points of the image, modulo primes.
std::optional<HypersurfaceEquation> equation_by_linear_algebra(const HypersurfaceProblem& problem,
                                                               base::Run& run);

} // namespace eliminant::implicit
