// Whether a polynomial is zero on a rational map: exactly, from values modulo primes.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/implicit/certificate.hpp"
#include "implicit/verify_map.hpp"

namespace eliminant::implicit {

/// The bounds of the claim that f is zero on the map, and the primes that it takes.
///
/// f over ℤ in the coordinates of a map becomes, with the parameters T put in and the denominator f₀ and the
/// denominators qᵢ of coefficients cleared, G(T) = f₀^δ ∏ qᵢ^δᵢ · f(x(T)), a polynomial over ℤ, which the
/// bounds are for: the height is one of the sum of the absolute values of its coefficients. The primes are
/// the greatest below 2^30 that divide no qᵢ, as many as their product exceeds the height.
///
/// \param f in the ring of coordinates: variable i is component i; integer coefficients
VanishingClaim vanishing_claim(const RationalMap& map, const algebra::Polynomial& f);

/// Whether G is zero modulo all primes of the claim, at the same time on several threads; see Grid.
bool vanishes(const RationalMap& map, const algebra::Polynomial& f, const VanishingClaim& claim,
              base::Run& run);

} // namespace eliminant::implicit
