#pragma once

#include "gcd_dense.hpp"
#include "gcd_sparse.hpp"

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// The terms of a polynomial as exponent rows in chosen variables, decreasing in lex. Coefficients are
/// numerators over ℚ and residues over GF(p); only one of the two lists is used.
struct TermRows {
    ExponentRows exponents;
    std::vector<Integer> integers;
    std::vector<std::uint32_t> residues;
};

/// No variables but these occur in f.
TermRows term_rows(const Polynomial& f, std::span<const std::size_t> variables, base::Run& run);

/// Two polynomials whose gcd is sought, with their variables in the sequence that suits a method.
struct GcdProblem {
    const Polynomial& f;
    const Polynomial& g;
    std::vector<std::size_t> variables; ///< indices in the ring, the main variable first
    std::vector<std::size_t> bounds;    ///< degrees of the gcd are at most these, in the same sequence
};

/// Operations that a method is expected to need modulo one prime; what methods are compared by.
double dense_cost(const GcdProblem& problem);
double sparse_cost(const GcdProblem& problem);

/// Whether the coefficient arrays of the dense method are of a size that is ever sensible.
bool dense_fits(const GcdProblem& problem);

/// The variables of the problem sorted for the dense method: the highest degree, which the univariate gcds
/// have, first.
GcdProblem sorted_for_dense(GcdProblem problem);

/// The same for the sparse method: first a variable in which leading coefficients are short, since they
/// multiply the gcd.
GcdProblem sorted_for_sparse(GcdProblem problem);

} // namespace eliminant::algebra
