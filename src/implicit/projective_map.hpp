// A parametrization over one denominator, and the rank of its differential.
#pragma once

#include "eliminant/implicit/parametrization.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace eliminant::implicit {

/// An element n/d of the field of constants, n and d coprime in ℤ[constants].
struct Scale {
    algebra::Polynomial numerator;
    algebra::Polynomial denominator;
};

/// The map written with one denominator: coordinate i is scales[i − 1] · forms[i] / forms[0] for i ≥ 1.
///
/// The forms are primitive over ℤ[constants] and have no factor common to all of them. Taking the scales out
/// of the elimination costs nothing, because a diagonal change of coordinates maps monomials to multiples of
/// themselves and so Groebner bases to Groebner bases; it clears fractions, and often all constants: the
/// sphere of radius r becomes the unit sphere.
struct ProjectiveMap {
    std::vector<algebra::Polynomial> forms; ///< in the ring of the parametrization
    std::vector<Scale> scales;
};

/// f = unit · content · primitive, the content in ℤ[constants]; all parts of 0 are 1, 1 and 0.
struct Parts {
    mpq_class unit;
    algebra::Polynomial content;
    algebra::Polynomial primitive;
};

/// \param parameters, constants the variables
Parts split(const algebra::Polynomial& f, std::span<const std::size_t> parameters,
            std::span<const std::size_t> constants, base::Run& run);

/// The quotient of the factors of a and b that are in the field of constants.
Scale quotient_of(const Parts& a, const Parts& b, base::Run& run);

ProjectiveMap over_common_denominator(const Parametrization& parametrization, base::Run& run);

/// A lower bound of the dimension of the image, without relations: the largest rank that the differential was
/// seen to have at a few random points modulo a prime. A minor that is not zero there is not zero as a
/// function, and the rank of the differential is the transcendence degree of the coordinates over a field of
/// characteristic 0. It is the dimension unless every point was unlucky.
std::size_t dimension_at_least(const Parametrization& parametrization, const ProjectiveMap& map,
                               base::Run& run);

} // namespace eliminant::implicit
