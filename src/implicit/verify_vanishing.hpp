// Whether a polynomial is zero on a rational map: exactly, from values modulo primes.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/run.hpp"
#include "implicit/verify_map.hpp"

#include <gmpxx.h>

#include <cstdint>
#include <vector>

namespace eliminant::implicit {

/// f over ℤ in the coordinates of a map becomes, with the parameters T put in and the denominator f₀ and the
/// denominators qᵢ of coefficients cleared, G(T) = f₀^δ ∏ qᵢ^δᵢ · f(x(T)), a polynomial over ℤ.
struct VanishingBounds {
    std::vector<std::uint64_t> degrees; ///< of G in each variable of the map's ring, at most
    std::uint64_t total_degree;         ///< of G, at most
    mpz_class height;                   ///< sum of the absolute values of G's coefficients, at most
};

/// \param f in the ring of coordinates: variable i is component i; integer coefficients
VanishingBounds vanishing_bounds(const RationalMap& map, const algebra::Polynomial& f);

/// The greatest primes below 2^30 that divide no denominator of the map's coefficients, as many as their
/// product exceeds the height: a G that is zero modulo all of them is zero.
std::vector<std::uint64_t> vanishing_primes(const RationalMap& map, const mpz_class& height);

/// Whether G is zero modulo p. Proved by values: a polynomial whose exponents lie in a set L with each e also
/// all smaller exponent vectors is zero if it vanishes at the points (a_e₁, b_e₂, …) for e ∈ L, where the a,
/// the b, … are distinct (by induction over the variables, the coefficients of the last one being polynomials
/// with smaller sets; Lorentz, Multivariate Birkhoff Interpolation, 1992). L is given by the bounds. As many
/// evaluations of f as L has elements.
bool vanishes_modulo(const RationalMap& map, const algebra::Polynomial& f, const VanishingBounds& bounds,
                     const algebra::PrimeField& field, base::Run& run);

} // namespace eliminant::implicit
