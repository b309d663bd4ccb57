// The proof that a polynomial is the equation of an image.
#pragma once

#include "implicit/verify_irreducible.hpp"
#include "implicit/verify_rank.hpp"
#include "implicit/verify_vanishing.hpp"

#include <optional>
#include <string_view>

namespace eliminant::implicit {

constexpr std::string_view hypersurface_theorem =
    "the polynomial vanishes on the parametrization, modulo primes whose product exceeds the coefficients of "
    "what is "
    "zero, at enough points for its degrees; the differential has rank n - 1 at a point modulo a prime, so "
    "the ideal "
    "of the image is principal; and the polynomial is irreducible, because it is so on a line modulo a "
    "prime, where "
    "it keeps its degree";

/// Proves that f generates the ideal of the image of a map in n-dimensional space, over the field of
/// constants:
///
/// 1. f is zero on the map, so in the ideal of the image, which is prime, and not {0};
/// 2. the image has dimension at least n − 1, so the ideal has height one, and is principal (the ring being
///    factorial): f is a multiple of its generator;
/// 3. f is irreducible, so it is the generator, up to a constant.
///
/// \param f in the ring of the map's coordinates, not zero, without factors in ℤ[constants] alone
/// \returns nullopt if one of the three fails, or is not found
std::optional<Claims> prove_hypersurface(const RationalMap& map, const algebra::Polynomial& f,
                                         base::Run& run);

} // namespace eliminant::implicit
