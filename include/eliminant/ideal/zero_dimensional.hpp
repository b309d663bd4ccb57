/// \file
/// Ideals of dimension zero: the residue class ring as a finite-dimensional vector space.
#pragma once

#include "eliminant/ideal/ideal.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace eliminant::ideal {

/// Whether K[x₁, …, xₙ]/I is a finite-dimensional vector space: some power of each variable is a leading
/// monomial. True for the unit ideal, of which the dimension is −1.
bool is_zero_dimensional(const Ideal& I, base::Run& run);

/// The dimension of K[x₁, …, xₙ]/I as a vector space, 0 for the unit ideal; nullopt if it is infinite.
std::optional<mpz_class> vector_space_dimension(const Ideal& I, base::Run& run);

/// The monomials that are not leading monomials of I in the ring's order, ascending: a basis of K[x]/I
/// (Macaulay). \throws DomainError if there are infinitely many
std::vector<algebra::Monomial> standard_monomials(const Ideal& I, base::Run& run);

/// The monic polynomial m of least degree with m(f) ∈ I, the minimal polynomial of multiplication by f on
/// K[x]/I, in a ring of one variable `t` over the same field; 1 for the unit ideal. For f a variable it
/// generates the elimination ideal of the others.
///
/// It is got by linear algebra in K[x]/I, over ℚ modulo primes and with a proof: O(D²·m) operations for the
/// dimension D of K[x]/I and m normal forms, in the general case.
/// \throws DomainError if I is not zero-dimensional
algebra::Polynomial minimal_polynomial(const Ideal& I, const algebra::Polynomial& f, base::Run& run);

} // namespace eliminant::ideal

namespace eliminant {
using ideal::is_zero_dimensional;
using ideal::minimal_polynomial;
using ideal::standard_monomials;
using ideal::vector_space_dimension;
} // namespace eliminant
