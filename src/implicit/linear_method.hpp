// Implicit equations by linear algebra on values of monomials.
#pragma once

#include "implicit/hypersurface.hpp"

#include <cstddef>
#include <memory>
#include <optional>

namespace eliminant::implicit {

/// What decides how long the method takes.
struct LinearSizes {
    std::size_t degree; ///< of the equation, or of that of weights that is known
    std::size_t terms;  ///< unknowns of a system
    std::size_t planes; ///< systems a prime: one, or a section each
    std::size_t
        root_degree; ///< of the equation that is solved for each point of a section; 0 without sections
};

/// The polynomial of least degree that vanishes at general points of the image, modulo primes: all its
/// coefficients at once where they are few, from sections (section_solver.hpp) otherwise.
class LinearMethod : public HypersurfaceMethod {
  public:
    /// The sizes for an equation of a degree; nullopt if that is too large for the method.
    virtual std::optional<LinearSizes> sizes(std::size_t degree) const = 0;
    /// Whether there is an equation among the first `max_terms` monomials, modulo a prime; then all is known.
    virtual std::optional<LinearSizes> small_sizes(std::size_t max_terms) = 0;
};

/// Made for all degrees of which powers can be listed; null for others.
std::unique_ptr<LinearMethod> linear_method(const HypersurfaceProblem& problem, base::Run& run);

} // namespace eliminant::implicit
