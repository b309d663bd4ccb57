/// \file
/// Greatest common divisors of multivariate polynomials and what follows from them.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::algebra {

// Results are in the ring of the arguments and normalised as Polynomial::primitive_part(): over ℚ primitive
// integer polynomials with a positive leading coefficient, over GF(p) monic ones. So they are unique. Every
// answer is proved: random choices (evaluation points, primes) decide only how long it takes. Polynomials of
// different rings are a RingMismatchError. The form without Run runs to completion.

/// Greatest common divisor; gcd(f, 0) = f.primitive_part(), gcd(0, 0) = 0.
///
/// Most pairs are coprime; univariate images prove it in O(n·terms). Otherwise evaluation and interpolation
/// (Brown, J. ACM 18 (1971) 478–504, where terms are dense; Zippel, EUROSAM 1979, where they are sparse)
/// modulo word-size primes, over ℚ with Chinese remaindering, over small fields in an extension; then
/// division proves the result. See von zur Gathen and Gerhard, Modern Computer Algebra, chapter 6.
Polynomial gcd(const Polynomial& f, const Polynomial& g, base::Run& run);
Polynomial gcd(const Polynomial& f, const Polynomial& g);

/// gcd of all; 0 if all are 0. Throws DomainError for an empty list, which has no ring.
Polynomial gcd(std::span<const Polynomial> polynomials, base::Run& run);

/// Least common multiple; 0 if an argument is 0.
Polynomial lcm(const Polynomial& f, const Polynomial& g, base::Run& run);
Polynomial lcm(const Polynomial& f, const Polynomial& g);

/// Whether gcd(f, g) is a nonzero constant.
bool coprime(const Polynomial& f, const Polynomial& g, base::Run& run);

/// gcd of the coefficients of f as a polynomial in `variables`; it is free of them. 0 for 0.
Polynomial content(const Polynomial& f, std::span<const std::size_t> variables, base::Run& run);

/// f / content(f, variables), normalised; 0 for 0.
Polynomial primitive_part(const Polynomial& f, std::span<const std::size_t> variables, base::Run& run);

/// A factor of a factorisation.
struct Factor {
    Polynomial base;
    std::uint64_t multiplicity;
};

/// unit · ∏ factors[i].base ^ factors[i].multiplicity.
struct Factorization {
    mpq_class unit; ///< a constant of the field; 0 only for the polynomial 0, which has no factors
    std::vector<Factor> factors;
};

/// The decomposition of f by multiplicities: bases are squarefree, pairwise coprime, normalised and not
/// constant, multiplicities distinct and increasing.
///
/// Yun's algorithm (SYMSAC 1976) where derivatives tell, that is in characteristic 0 and where degrees stay
/// below p. Otherwise the factors whose multiplicity p divides are those that all derivatives miss; what they
/// leave is a p-th power, whose root is taken (von zur Gathen and Gerhard, §14.6 and exercise 14.30).
Factorization squarefree_decomposition(const Polynomial& f, base::Run& run);

/// The product of the distinct irreducible factors of f, normalised: the generator of the radical of (f). 0
/// for 0.
Polynomial squarefree_part(const Polynomial& f, base::Run& run);

} // namespace eliminant::algebra

namespace eliminant {
using algebra::content;
using algebra::coprime;
using algebra::Factor;
using algebra::Factorization;
using algebra::gcd;
using algebra::lcm;
using algebra::primitive_part;
using algebra::squarefree_decomposition;
using algebra::squarefree_part;
} // namespace eliminant
