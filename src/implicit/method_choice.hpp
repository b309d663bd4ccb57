// Which method an image of codimension one is given to, and why.
#pragma once

#include "implicit/graded_map.hpp"
#include "implicit/hypersurface.hpp"
#include "implicit/kernel.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace eliminant::implicit {

/// The methods to try before elimination, in this sequence, and what they are expected to take.
struct MethodChoice {
    std::vector<std::unique_ptr<HypersurfaceMethod>> methods;
    std::vector<MethodCost> costs;                ///< ascending, lower bounds last
    std::string reason;                           ///< in words
    std::optional<EliminationEffort> elimination; ///< if it got so far
};

/// Predicts what each method takes, from the problem's degrees, the lengths of its coefficients and a few
/// experiments modulo a prime, of which each costs a fraction of what it helps to predict:
///
/// 1. Is there an equation of few terms? Its linear system is small whatever the degree of the map: a sphere
///    in a parametrization of degree 12 has fibres of 72 points, and 10 coefficients.
/// 2. One line of the resultant method. It tells the degree of the equation, from which the sizes of all
///    computations modulo a prime follow.
/// 3. The beginning of an elimination, where the others are expected to take long: graphs and monomial maps
///    are eliminated in a few steps, whatever their degree.
///
/// The number of primes follows from the degree d and the map's coefficients: the equation, to the power of
/// the map's degree, is a factor of a resultant, in which the coefficients of each coordinate have degree d
/// times that of the map at most.
///
/// \param graded_map makes the map of the elimination, if it is needed
MethodChoice choose_method(const HypersurfaceProblem& problem, const std::function<GradedMap()>& graded_map,
                           base::Run& run);

/// What was asked for: at most one method; none for elimination.
MethodChoice method_asked_for(Method method, const HypersurfaceProblem& problem, base::Run& run);

} // namespace eliminant::implicit
