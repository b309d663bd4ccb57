#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

namespace eliminant::algebra {

/// gcd of nonzero polynomials by primitive polynomial remainder sequences, recursive in the variables;
/// normalised.
///
/// It needs nothing of the field but exact division, so it is the last resort where modular methods lack
/// evaluation points, and the twin they are tested against. Coefficients in the other variables swell (Brown
/// 1971): slow.
Polynomial gcd_by_remainders(const Polynomial& f, const Polynomial& g, base::Run& run);

} // namespace eliminant::algebra
