#pragma once

#include "eliminant/groebner/buchberger.hpp"

#include <span>

namespace eliminant::groebner {

/// The reduced Groebner basis by F4 (Faugère, J. Pure Appl. Algebra 139 (1999)): the pairs of one degree are
/// reduced together, as rows of a sparse matrix whose other rows are all the multiples of basis elements that
/// they may need. Options, result and errors are those of buchberger(), and so is the basis; of the
/// statistics, reduction steps stay 0. Sugar is here the largest degree of a term: with graded orders,
/// selection sugar takes all pairs of the least degree, as selection normal does; with lex and elimination
/// orders it is the one that keeps degrees small. LinearAlgebra::probabilistic is for this engine. Matrices
/// are reduced on all threads of the run, with the same result.
///
/// Over ℚ it is computed modulo primes, eight at a time, until its coefficients are found as fractions.
///
/// With Proof::none the result has passed one test: the residues modulo one more prime agree, and modulo that
/// prime the generators reduce to zero. No theorem bounds the probability that it is wrong all the same.
///
/// With Proof::full it is proved that the elements G are a Groebner basis of the ideal I of the generators F.
/// Let p be the prime that was learned, and I_p the ideal of the images of F; G has the leading monomials of
/// I_p. Three statements, of which those that are cheapest are proved:
///
/// (1) G lies in I. The elements that each matrix found are combinations of its rows with rational
///     coefficients. These are lifted as well, and the identities hold modulo a product of primes larger than
///     twice what can stand on either side.
/// (2) I has no more leading monomials: either F are as many as the variables and dim F_p[x]/I_p is finite,
///     whence dim ℚ[x]/I ≥ dim F_p[x]/I_p; or they are homogeneous and a regular sequence modulo p, whence
///     the Hilbert functions are the same. See src/groebner/trace_proof.hpp.
/// (3) G is a Groebner basis of ⟨G⟩, and I ⊆ ⟨G⟩: all S-polynomials that the criteria leave are combinations
///     of multiples of G with small enough leading monomials, by identities as in (1), and F reduces to zero.
///     See src/groebner/basis_proof.hpp.
///
/// (1) and (2) are a proof, as are (1) and (3). So is (3) alone where F is homogeneous, as then, in each
/// degree, dim (ℚ[x]/I) ≤ dim (F_p[x]/I_p) = dim (ℚ[x]/⟨G⟩) ≤ dim (ℚ[x]/I): a rank can only fall modulo p
/// (Arnold, J. Symb. Comp. 35 (2003)). For other input it is not: it would prove ⟨x, y⟩ for ⟨y, y + x + p·x²⟩
/// in lex. Should an identity not be found, all S-polynomials are reduced exactly.
///
/// Over ℚ the computation cannot be stopped early (DomainError).
GroebnerBasis f4(const algebra::Ring& ring, std::span<const algebra::Polynomial> generators,
                 const BuchbergerOptions& options, base::Run& run);

} // namespace eliminant::groebner

namespace eliminant {
using groebner::f4;
} // namespace eliminant
