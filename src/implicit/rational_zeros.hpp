// Rational and real zeros of polynomials in one variable.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <vector>

namespace eliminant::implicit {

/// The distinct rational zeros, ascending, of a nonzero polynomial over ℚ in a ring of one variable.
///
/// A zero n/d of the squarefree part a_k·tᵏ + … is one of a zero modulo a prime at which that stays
/// squarefree and keeps its degree; by Newton's iteration modulo powers of the prime beyond 2(|a_k| + max
/// |aᵢ|) the integer a_k·n/d is known, of which Cauchy's bound says that it is not larger (von zur Gathen and
/// Gerhard, Modern Computer Algebra, §15.6). What is found is confirmed by division.
std::vector<mpq_class> rational_zeros(const algebra::Polynomial& polynomial, base::Run& run);

/// How many distinct real zeros a nonzero polynomial over ℚ in one variable has: by Sturm's theorem, from the
/// signs of its remainder sequence at both infinities.
std::size_t count_real_zeros(const algebra::Polynomial& polynomial, base::Run& run);

} // namespace eliminant::implicit
