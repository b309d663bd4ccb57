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
/// With Proof::full it is proved, by two theorems where their hypotheses hold. (1) The elements are in the
/// ideal I: those of each matrix are combinations of its rows with rational coefficients; these are lifted as
/// well, and the identities hold modulo a product of primes larger than twice what can stand on either side.
/// (2) They are a Groebner basis of I: they have the leading monomials of I_p, the ideal of the images of the
/// generators modulo the prime p that was learned, and I has no others, since either the generators are as
/// many as the variables and dim F_p[x]/I_p is finite, whence dim ℚ[x]/I ≥ dim F_p[x]/I_p; or they are
/// homogeneous and a regular sequence modulo p, whence the Hilbert functions are the same. See
/// src/groebner/trace_proof.hpp. Where (2) does not apply, all S-polynomials that the criteria leave are
/// reduced to zero exactly. The usual criterion that leading ideals agree and the input reduces to zero is
/// not used: it needs homogeneous input (it would prove ⟨x, y⟩ for ⟨y, y + x + p·x²⟩ in lex).
///
/// Over ℚ the computation cannot be stopped early (DomainError).
GroebnerBasis f4(const algebra::Ring& ring, std::span<const algebra::Polynomial> generators,
                 const BuchbergerOptions& options, base::Run& run);

} // namespace eliminant::groebner

namespace eliminant {
using groebner::f4;
} // namespace eliminant
