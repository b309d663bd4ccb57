/// \file
/// A polynomial as a polynomial in some of its variables.
#pragma once

#include "eliminant/algebra/polynomial.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// One term of a polynomial over the ring of the other variables: coefficient · ∏ variables[i]^exponents[i].
struct CoefficientTerm {
    std::vector<std::uint64_t> exponents; ///< one for each of the chosen variables, in their sequence
    Polynomial coefficient;               ///< nonzero, in the ring of f, free of the chosen variables
};

/// f as a polynomial in `variables` with coefficients in the others; exponents are distinct and decrease
/// lexicographically. No terms for f = 0. O(n log n) for n terms.
///
/// Throws DomainError if a variable does not exist or is named twice.
std::vector<CoefficientTerm> coefficients(const Polynomial& f, std::span<const std::size_t> variables);
/// The same for one variable: from the highest power down, powers that do not occur left out.
std::vector<CoefficientTerm> coefficients(const Polynomial& f, std::size_t variable);

/// The coefficient of variable^exponent, 0 if it does not occur.
Polynomial coefficient(const Polynomial& f, std::size_t variable, std::uint64_t exponent);

/// The coefficient of the highest power of the variable; 0 for 0.
Polynomial leading_coefficient(const Polynomial& f, std::size_t variable);

/// The inverse of coefficients(): Σ terms[i].coefficient · ∏ variables[j]^terms[i].exponents[j]. Exponents
/// may come in any sequence and repeat, and coefficients may contain the variables.
Polynomial from_coefficients(const Ring& ring, std::span<const std::size_t> variables,
                             std::span<const CoefficientTerm> terms);

/// The largest sum of the exponents of the first `count` variables in a term; 0 for 0.
std::uint64_t degree_in_first(const Polynomial& f, std::size_t count);

/// Which variables occur in f, one flag a variable of the ring.
std::vector<bool> occurring_variables(const Polynomial& f);

} // namespace eliminant::algebra

namespace eliminant {
using algebra::coefficient;
using algebra::coefficients;
using algebra::CoefficientTerm;
using algebra::from_coefficients;
using algebra::leading_coefficient;
using algebra::occurring_variables;
} // namespace eliminant
