// A fraction from its residue.
#pragma once

#include "eliminant/base/run.hpp"

#include <gmpxx.h>

#include <optional>

namespace eliminant::algebra {

struct Fraction {
    mpz_class numerator;
    mpz_class denominator; ///< positive; coprime to the numerator
};

/// The fraction n/d ≡ a modulo M with |n|·d so small beside M that chance would hardly make it so: below
/// M/2^margin_bits, but for a factor of at most 4. Nothing if there is none.
///
/// It is the convergent of M/a before the largest quotient (Monagan, ISSAC 2004): n and d may be as
/// unbalanced as they like, where Wang's bound √(M/2) for both would ask for more primes. For margins of at
/// least 2 bits there is at most one such fraction up to that factor. The remainders are formed by Lehmer's
/// method (Knuth, TAOCP 2, §4.5.2, Algorithm L), in O(log² M).
///
/// \param residue a in [0, modulus)
/// \param modulus M > 0
/// \param margin_bits at least 20
/// \param run polled
std::optional<Fraction> reconstruct_fraction(const mpz_class& residue, const mpz_class& modulus,
                                             unsigned margin_bits, base::Run& run);

} // namespace eliminant::algebra
