/// \file
/// Formal derivatives.
#pragma once

#include "eliminant/algebra/polynomial.hpp"

#include <cstddef>
#include <vector>

namespace eliminant::algebra {

/// ∂f/∂x for x the variable of that index; in characteristic p the derivative of x^p is 0.
///
/// O(terms). Throws DomainError if the ring has no such variable.
Polynomial derivative(const Polynomial& f, std::size_t variable);

/// All first partial derivatives, one a variable of the ring.
std::vector<Polynomial> gradient(const Polynomial& f);

} // namespace eliminant::algebra

namespace eliminant {
using algebra::derivative;
using algebra::gradient;
} // namespace eliminant
