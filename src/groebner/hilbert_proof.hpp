// Proof by Hilbert functions that a lifted basis is one.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <cstddef>
#include <span>

namespace eliminant::groebner {

/// Whether homogeneous polynomials over ℚ are a Groebner basis, in the order of their ring, of the
/// homogenisation Iʰ of an ideal I by variable h; the ring has the variables of I's and h.
///
/// Theorem. Let G lie in Iʰ, and the ideal of its leading monomials have the Hilbert function of Iʰ. Then it
/// is the leading ideal of Iʰ: it is contained in it, and in each degree of the same dimension (Macaulay
/// 1927; Traverso, J. Symb. Comp. 22 (1996)). A homogeneous g is in Iʰ if g at h = 1 is in I; and the Hilbert
/// function of Iʰ is that of the leading monomials of a Groebner basis of I in an order that compares degrees
/// first (Cox, Little, O'Shea, §9.3, Theorem 12).
///
/// So no S-polynomial is formed; the time is that of the exact normal forms.
///
/// \param candidate G
/// \param h the index of h in the ring of the candidate
/// \param graded_basis a Groebner basis of I in degrevlex or deglex
/// \param run polled
bool is_basis_of_homogenization(std::span<const algebra::Polynomial> candidate, std::size_t h,
                                std::span<const algebra::Polynomial> graded_basis, base::Run& run);

} // namespace eliminant::groebner
