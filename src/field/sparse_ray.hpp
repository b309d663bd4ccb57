#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/field/ray_roots.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace eliminant::field {

/// A polynomial with few terms for its degree, whose restriction to a ray has far more: the restriction is
/// never formed. Its values and derivatives are enclosed by interval arithmetic, term by term, so that time
/// depends on the number of terms and hardly on the degree.
///
/// The first root is found by the interval Newton method (Hansen and Walster, Global Optimization Using
/// Interval Analysis, 2004, ch. 9): what provably has no root is left behind, what is not provably monotone
/// is halved.
class SparseRay {
  public:
    /// Whether to ask this class first: a term here costs about as much as fifty dense coefficients, and up
    /// to degree 12 beams of rays in plain doubles are faster still (x^n + y^n + z^n − 1 in 256 × 256 pixels:
    /// 0.03 against 0.1 s for n = 10, 0.24 against 0.12 s for n = 14, 56 against 0.6 s for n = 40).
    static bool is_for(const algebra::Polynomial& f);

    /// At most three variables.
    explicit SparseRay(const algebra::Polynomial& f);

    /// The first root in [lower, upper], certain; or nothing: where roots are too close to each other or to
    /// an end, or powers leave the range of doubles. \throws Stopped
    std::optional<RayRoot> first(const glm::dvec3& origin, const glm::dvec3& direction, double lower,
                                 double upper, const base::Run& run) const;

  private:
    class Restriction;

    struct Term {
        double coefficient;               ///< to half an ulp, all divided by one power of two
        std::array<std::size_t, 3> power; ///< of each variable, in `exponents_`
    };
    std::vector<Term> terms_;
    /// The exponents of a variable that occur, each preceded by the one below it, which the derivative needs.
    std::array<std::vector<std::size_t>, 3> exponents_;
    std::size_t degree_ = 0;
    double coefficient_sum_ = 0.0;
};

} // namespace eliminant::field
