// Implicit equations of plane curves and surfaces by resultants.
#pragma once

#include "implicit/hypersurface.hpp"

#include <cstddef>
#include <memory>
#include <optional>

namespace eliminant::implicit {

/// What decides how long the method takes.
struct ResultantSizes {
    std::size_t
        eliminated;    ///< degree in the eliminated parameter, the order of Bézout's matrix; 0 for curves
    std::size_t nodes; ///< values of the other parameter at which a resultant is computed
    std::size_t fibre_size; ///< points that are taken to a line
    std::size_t degree;     ///< of the equation
    std::size_t lines;
};

/// Restricts the image, modulo primes, to lines of a random direction: there the equation is the
/// characteristic polynomial of the height on the fibre of the line (line_fibres.hpp), to the power of the
/// parametrization's degree, and so without extraneous factors. It is interpolated from the restrictions
/// (line_interpolation.hpp).
///
/// A bicubic patch of degree 18 takes 190 lines with fibres of 18 points, about 2 ms modulo a prime, where
/// the 1330 unknown coefficients would be a dense system of as many equations.
///
/// For degree d and fibres of n points, surfaces take O(d²n²(m + √d)) products a prime, m being the lower of
/// both degrees in a parameter, and curves O(d·n²√d); memory is that of the d³/6 or d²/2 coefficients as
/// words modulo each prime, about twice the answer: 18 MB where the answer has 1.8 (a curve of degree 120).
class ResultantMethod : public HypersurfaceMethod {
  public:
    /// Upper bounds that degrees tell; nullopt if that is too large.
    virtual std::optional<ResultantSizes> size_bounds() const = 0;
    /// What a line tells, modulo a prime, for the cost of a few of them; nullopt if the method gives up.
    virtual std::optional<ResultantSizes> sizes() = 0;
};

/// Made for n = 2 and n = 3 coordinates of n − 1 parameters without symbolic constants; null for others.
std::unique_ptr<ResultantMethod> resultant_method(const HypersurfaceProblem& problem, base::Run& run);

} // namespace eliminant::implicit
