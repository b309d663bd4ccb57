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
///
/// T coefficients at once take T³/3 products and T² words of memory a prime and thread; from sections of T
/// terms it is as many for each of the d + 1 or more sections, and the words of the answer's coefficients
/// modulo each prime: 15 MB where the answer has 0.6 (a patch of degree 4×4).
///
/// Lifting p-adically from one elimination (Dixon, Numer. Math. 40 (1982)) does not pay: the residual of a
/// digit, exact values of T monomials at T integer points, takes longer than an elimination modulo one more
/// prime, 89 ms against 79 for a bicubic patch with coefficients of 60 bits and T = 1330, 214 against 24 for
/// a curve of degree 40 and T = 861.
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
