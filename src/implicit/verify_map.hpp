// A parametrization as polynomials in free parameters: what proofs and the methods modulo primes work with.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/algebra/rational_function.hpp"
#include "eliminant/base/run.hpp"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace eliminant::implicit {

/// The variables of two parameters that are the cosine and the sine of one angle.
using CosineSine = std::pair<std::size_t, std::size_t>;

/// A rational map without relations between its parameters. Coordinate i is
///
///     numerator                  of a component that is a polynomial,
///     numerator / denominator    of one that is over the common denominator.
///
/// Constants are parameters and, behind the others, coordinates too, c = c: an equation over the field of
/// constants, cleared to ℤ[constants], is one between all of these coordinates.
struct RationalMap {
    struct Component {
        algebra::Polynomial numerator;
        bool over_denominator;
    };

    algebra::Ring ring;              ///< over ℚ: of the parametrization
    algebra::Polynomial denominator; ///< primitive over ℤ; 1 if there is none
    std::vector<Component> components;
    std::vector<std::size_t> parameters; ///< variables that are neither constants nor replaced sines
    std::vector<std::size_t> constants;  ///< variables; the last components, in this sequence
};

/// f(c, s, …) at c = (1 − w²)/(1 + w²), s = 2w/(1 + w²) for each rotation, in lowest terms; the variable of
/// the cosine becomes w, that of the sine does not occur. It is a birational map of the line to the circle,
/// so neither the closure of an image nor the degree of a map is changed by it.
algebra::RationalFunction by_half_angles(const algebra::RationalFunction& f,
                                         std::span<const CosineSine> rotations, base::Run& run);

/// \param functions the coordinates, in `ring`
RationalMap rational_map(const algebra::Ring& ring, std::span<const std::size_t> constants,
                         std::span<const CosineSine> rotations,
                         std::span<const algebra::RationalFunction> functions, base::Run& run);

} // namespace eliminant::implicit
