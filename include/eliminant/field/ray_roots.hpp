/// \file
/// Where rays meet the zero set of a polynomial.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace eliminant::field {

/// The arithmetic that decided a question, cheapest first.
enum class Precision : std::uint8_t {
    doubles, ///< 53 bits, with a bound of the rounding
    wide,    ///< 106 bits, with a bound of the rounding
    exact,   ///< integers of any size
};

/// What a ray does on an interval.
struct RayRoot {
    enum class Kind : std::uint8_t {
        none,      ///< f is not 0 anywhere on the interval
        crossing,  ///< the sign of f changes at t
        tangency,  ///< f is 0 at t and has the same sign on both sides
        contained, ///< f is 0 on the whole line; t is the start of the interval
    };
    Kind kind = Kind::none;
    double t = 0.0; ///< to about 1e-9 of the interval's length, mostly much closer
    int side = 0;   ///< sign of f just before t, or throughout; 0 if contained or the interval is empty
    unsigned multiplicity = 0; ///< of the root; 0 without one
    Precision precision = Precision::doubles;
    int steps = 0; ///< subdivisions and refinements
};

struct RayRootsData;

/// A polynomial f over ℚ in x, y, z, asked for its roots on rays: immutable, for many threads at once.
///
/// Every answer is that of the exact polynomial on the exact ray, the doubles being taken as they are.
/// Doubles mostly suffice: the polynomial on the ray is formed with a bound of its error, and Descartes' rule
/// in the Bernstein basis isolates the first root (Lane and Riesenfeld, BIT 21 (1981) 112–117). Where signs
/// stay uncertain the same is done in 106 bits, and at last in integers, which also tell tangencies.
class RayRoots {
  public:
    /// The first three variables of the ring are x, y, z.
    /// \throws DomainError if f is not over ℚ or in more than three variables
    explicit RayRoots(const algebra::Polynomial& f);

    /// The first root of t ↦ f(origin + t·direction) in the closed interval [lower, upper]; `upper` may be
    /// +∞. O(n⁴/24) for degree n. \throws DomainError if a coordinate or `lower` is not finite, or `upper` is
    /// not a number
    RayRoot first(const glm::dvec3& origin, const glm::dvec3& direction, double lower, double upper,
                  base::Run& run) const;
    /// All roots, ascending; exact throughout.
    std::vector<RayRoot> all(const glm::dvec3& origin, const glm::dvec3& direction, double lower,
                             double upper, base::Run& run) const;

    /// For the other parts of the library.
    const RayRootsData& data() const { return *data_; }

  private:
    std::shared_ptr<const RayRootsData> data_;
};

} // namespace eliminant::field

namespace eliminant {
using field::Precision;
using field::RayRoot;
using field::RayRoots;
} // namespace eliminant
