// Hypersurfaces that are closures of images of tori.
#pragma once

#include "implicit/verify_monomials.hpp"

#include <cstdint>
#include <optional>

namespace eliminant::implicit {

/// The equation of a map by terms, if its image closure is a hypersurface: the exponents, as rows, then have
/// one relation Σ uᵢ·aᵢ = 0 up to multiples. With a primitive u it is ∏ (xᵢ/cᵢ)^uᵢ = 1, cleared of
/// denominators; see is_irreducible_binomial_on(). It takes the same time for all exponents.
/// \param ring of coordinates, then constants
/// \throws OverflowError if an exponent or coefficient is too large
std::optional<algebra::Polynomial> toric_equation(const TermMap& map, const algebra::Ring& ring);

/// How many parameter values reach a general point of the image: the index of the lattice that the exponents
/// of the coordinates span in that of all exponents of the parameters. nullopt if infinitely many, 2^64 or
/// more, or if there is no parameter.
std::optional<std::uint64_t> toric_degree(const TermMap& terms, const RationalMap& map);

} // namespace eliminant::implicit
