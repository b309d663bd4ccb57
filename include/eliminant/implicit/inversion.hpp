/// \file
/// The parameters as functions of the point they reach.
#pragma once

#include "eliminant/implicit/parametrization.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace eliminant::implicit {

/// The inverse of a parametrization as a rational map from the closure of its image.
struct Inversion {
    /// ℚ[coordinates, constants]
    algebra::Ring ring;
    /// How many parameter values over the algebraic closure reach a general point of the image; nullopt if
    /// infinitely many.
    std::optional<std::uint64_t> parametrization_degree;
    /// If it is one value, each parameter, by the name it has in the ring of the parametrization, as a
    /// function of the coordinates; otherwise none.
    std::vector<Coordinate> parameters;
};

/// The inversion formulas of a parametrization that is injective at general points. Each is t = N/D with
///
///     t·D(φ(t, …)) = N(φ(t, …)) and D(φ(t, …)) ≠ 0
///
/// for the map φ, as functions of the parameters; so it holds on an open dense part of the image, where D is
/// not zero. The greater degree of N and D is least possible, and then the leading monomial of D, but for
/// plane curves that need more than degree 15: those of degree n get a formula of degree n − 2 at most. N and
/// D have integer coefficients without common factor, the leading one of D being positive, unless D is 1.
///
/// In general t·D − N is the first linear dependence between monomials in the coordinates and t that are at
/// most linear in t, on the graph of t over the image; it is found at points modulo primes, put together by
/// Chinese remaindering, and then proved: the identity by values modulo enough primes, and that D is not zero
/// by one value. For N such monomials it takes O(N³) products a prime and memory for N² residues. Curves of
/// high degree n are inverted by the subresultant of two moving lines in O(n⁴) a prime, and memory for O(n²)
/// coefficients.
///
/// \throws DomainError if the parameters satisfy relations other than those of angles, or if numerators and
/// denominators have degrees beyond 20000
/// \throws Stopped
Inversion inversion(const Parametrization& parametrization, base::Run& run);

} // namespace eliminant::implicit

namespace eliminant {
using implicit::Inversion;
using implicit::inversion;
} // namespace eliminant
