// Proof that a lifted F4 computation is one over ℚ.
#pragma once

#include "f4_trace.hpp"
#include "prime_sequence.hpp"

#include "algebra/rational_lifting.hpp"

#include <span>

namespace eliminant::groebner {

/// Whether the elements of a trace, lifted to ℚ, are proved to lie in the ideal of its generators.
///
/// One matrix of the trace has rows that are multiples of generators and earlier elements, pivots that are
/// multiples of earlier elements, and elements that it found, as many as rows. The rows are proved to be
/// combinations of the pivots and the found elements, and the multipliers of the latter to be an invertible
/// matrix (see IdentityProver). So the found elements are combinations of rows and pivots, and by induction
/// over the matrices all elements are in the ideal.
///
/// \param trace the recorded computation
/// \param elements its distinct elements in sequence, lifted
/// \param primes new ones
/// \param run polled, and its threads used
bool lies_in_ideal_of_generators(const F4Trace& trace, std::vector<algebra::RationalLifting::Vector> elements,
                                 PrimeSequence& primes, base::Run& run);

/// Whether the leading monomials modulo the learned prime p are known to be all those of the ideal I over ℚ
/// as soon as polynomials with these leading monomials lie in I. Two theorems say so:
///
/// (a) n generators in n variables, and F_p[x]/I_p of finite dimension D. Then F_p[x] has them for a regular
///     sequence (it is Cohen–Macaulay), so p is no zero divisor modulo them in the p-adic completion A of
///     ℤ_p[x]/(f), which is finite over ℤ_p by Nakayama's lemma: A is free of rank D, and as A ⊗ ℚ is a
///     quotient of ℚ_p[x]/I, the dimension of ℚ[x]/I is at least D. If polynomials with the leading monomials
///     of I_p lie in I it is at most D; one leading monomial more, and it would be less.
/// (b) Homogeneous generators of degrees dᵢ, and F_p[x]/I_p with the Hilbert series Π(1 − t^dᵢ)/(1 − t)ⁿ.
/// Then
///     they are a regular sequence modulo p (Stanley, Adv. Math. 28 (1978), Cor. 3.2), and over ℚ, where the
///     Koszul complex stays exact; so I and I_p have the same Hilbert function.
///
/// And the unit ideal has no leading monomials that 1 does not divide.
bool has_all_leading_monomials(const F4Trace& trace, std::span<const algebra::Polynomial> generators,
                               base::Run& run);

} // namespace eliminant::groebner
