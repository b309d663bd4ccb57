#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <optional>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// a·b. The method follows the shape of the operands: dense accumulation where the products crowd their box,
/// a heap where they do not.
Polynomial multiply(const Polynomial& a, const Polynomial& b, base::Run& run);

/// f^exponent; f^0 = 1, also for f = 0.
Polynomial pow(const Polynomial& f, std::uint64_t exponent, base::Run& run);
Polynomial pow(const Polynomial& f, std::uint64_t exponent);

/// The quotient a/b if b divides a, otherwise nullopt. Throws DomainError for b = 0.
std::optional<Polynomial> try_divide(const Polynomial& a, const Polynomial& b, base::Run& run);
std::optional<Polynomial> try_divide(const Polynomial& a, const Polynomial& b);

/// a/b; throws DomainError if b is 0 or does not divide a.
Polynomial divide_exactly(const Polynomial& a, const Polynomial& b, base::Run& run);
Polynomial divide_exactly(const Polynomial& a, const Polynomial& b);

/// Quotients and remainder of multivariate division.
struct Division {
    std::vector<Polynomial> quotients; ///< one a divisor
    Polynomial remainder;
};

/// f = Σ quotients[i]·divisors[i] + remainder, where no term of the remainder is divisible by any
/// lt(divisors[i]) and lm(quotients[i]·divisors[i]) ≤ lm(f). In each step the first divisor whose leading
/// term divides is used (Cox, Little, O'Shea, Ideals, Varieties, and Algorithms, §2.3). Throws DomainError
/// for a zero divisor.
Division divide(const Polynomial& f, std::span<const Polynomial> divisors, base::Run& run);

/// The remainder of divide() alone.
Polynomial normal_form(const Polynomial& f, std::span<const Polynomial> divisors, base::Run& run);

/// lcm/lt(f)·f − lcm/lt(g)·g with lcm = lcm(lm f, lm g). Throws DomainError for a zero operand.
Polynomial s_polynomial(const Polynomial& f, const Polynomial& g);

} // namespace eliminant::algebra

namespace eliminant {
using algebra::divide;
using algebra::divide_exactly;
using algebra::Division;
using algebra::multiply;
using algebra::normal_form;
using algebra::pow;
using algebra::s_polynomial;
using algebra::try_divide;
} // namespace eliminant
