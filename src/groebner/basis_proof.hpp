// Proof that polynomials over ℚ are a Groebner basis of what they generate.
#pragma once

#include "prime_sequence.hpp"

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/groebner/buchberger.hpp"

#include <span>

namespace eliminant::groebner {

/// Whether polynomials over ℚ are proved to be a Groebner basis of the ideal that they generate.
///
/// F4 modulo a prime is given the elements for input. It finds nothing but them, and all S-polynomials that
/// the criteria of Gebauer and Möller leave become rows of matrices that reduce to zero. Each of these rows
/// is then proved to be a combination over ℚ of the pivots and the elements of its matrix (IdentityProver).
/// The leading monomials are the same modulo the prime as over ℚ, and so are the criteria and the leading
/// columns of pivots and elements, no two of which are the same. So the S-polynomial of two elements, the
/// difference of two rows, is a combination of rows whose leading monomials are below the least common
/// multiple: Buchberger's criterion holds in the form of Becker and Weispfenning, Gröbner Bases (1993),
/// Theorem 5.64.
///
/// False also where it is not proved: if an element is not reduced by the others, if a coefficient of an
/// identity vanishes modulo the first primes by accident, or if coefficients are so long and rows so many
/// that exact reductions are likely to be cheaper.
///
/// \param elements of one ring, none zero, each reduced by the others
/// \param options of F4
/// \param primes new ones
/// \param run polled, and its threads used
bool is_proved_groebner(std::span<const algebra::Polynomial> elements, const BuchbergerOptions& options,
                        PrimeSequence& primes, base::Run& run);

} // namespace eliminant::groebner
