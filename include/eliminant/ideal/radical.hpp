/// \file
/// The radical of an ideal.
#pragma once

#include "eliminant/ideal/ideal.hpp"

namespace eliminant::ideal {

/// √I = {f : some power of f belongs to I}, over ℚ and over GF(p) for every p.
///
/// Laplagne's scheme (ISSAC 2006): an intersection P of radical ideals above I grows smaller until P ⊆ √I.
/// While an element g of P is outside √I, the minimal primes of J = I : g^∞ are those of I that P does not
/// yet know. For a maximal set U of variables independent modulo J, J generates a zero-dimensional ideal over
/// K(U), whose radical needs the squarefree part of a univariate polynomial for each other variable
/// (Seidenberg 1974, Lemma 92; Becker and Weispfenning, Gröbner Bases, §8.2 and §8.7); its contraction to
/// K[x], a saturation by leading coefficients, joins the intersection.
///
/// Over GF(p) Seidenberg's lemma asks for univariate polynomials without multiple roots in the algebraic
/// closure, which a squarefree polynomial over K(U) may have once its degree reaches p. Then the radical
/// is the limit of I, φ⁻¹(I), φ⁻²(I), … for the Frobenius map φ(f) = f^p (Matsumoto 2001).
Ideal radical(const Ideal& I, base::Run& run);

} // namespace eliminant::ideal

namespace eliminant {
using ideal::radical;
} // namespace eliminant
