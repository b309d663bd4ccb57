// Images of codimension one: what the methods for them are asked, and what they answer.
#pragma once

#include "eliminant/implicit/implicitize.hpp"
#include "implicit/projective_map.hpp"
#include "implicit/verify_map.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace eliminant::implicit {

/// A map whose image closure is a hypersurface, unless the differential was unlucky at every point that was
/// tried. Its equation f is irreducible: image and domain are.
struct HypersurfaceProblem {
    /// Numerators and denominator are primitive over ℤ[constants]: scales are taken out of the coordinates.
    RationalMap map;
    /// One variable a component of the map: coordinates, then constants. The ring of the equation.
    algebra::Ring ring;
};

/// An answer, still to be proved: the proof is one for all methods (verify_hypersurface.hpp).
struct HypersurfaceEquation {
    algebra::Polynomial equation; ///< primitive, in the ring of the problem
    std::uint64_t primes_used;
    std::string how; ///< what the method did, for the curious: sizes and degrees
};

/// A method at work on a problem.
class HypersurfaceMethod {
  public:
    virtual ~HypersurfaceMethod() = default;
    virtual Method name() const = 0;
    /// nullopt if the method is not made for the problem or meets its limits, so that another one is tried.
    /// \throws Stopped
    virtual std::optional<HypersurfaceEquation> equation() = 0;
};

/// The problem of a map, and the scales x = (numerator/denominator)·x′ of its coordinates.
struct ScaledProblem {
    HypersurfaceProblem problem;
    std::vector<Scale> scales;
};
ScaledProblem hypersurface_problem(const RationalMap& map, const algebra::Ring& ring, base::Run& run);

/// The image of the equation modulo a prime, monic in `ring.with_field(p)`; nullopt if the prime turns out to
/// be of no use. Called for several primes at the same time.
using ImageModulo = std::function<std::optional<algebra::Polynomial>(const algebra::PrimeField& field)>;

/// Puts an equation together from its images modulo the primes below `prime_bound`, from the greatest down,
/// until all coefficients are so short beside the product of the primes that chance would hardly make them so
/// (algebra::RationalLifting). Memory for a word a term and prime, which is about twice the equation's.
/// nullopt if `max_useless` primes
/// are of no use.
std::optional<HypersurfaceEquation> equation_from_images(const algebra::Ring& ring, std::uint64_t prime_bound,
                                                         const ImageModulo& image, base::Run& run);

} // namespace eliminant::implicit
