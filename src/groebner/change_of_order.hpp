// Bases of zero-dimensional ideals in another order, and of their elimination ideals.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/groebner/buchberger.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// What change_order() found.
struct ChangedOrder {
    std::vector<algebra::Polynomial> elements; ///< as in GroebnerBasis
    std::uint64_t primes = 0;                  ///< modulo which it was computed; 0 over GF(p)
};

/// The reduced basis, in the order of `target`, of I ∩ K[target's variables], for an ideal I of dimension
/// zero with the given reduced basis; the variables of target are among those of I's ring, matched by name.
/// nullopt if I is not of dimension zero, or K[x]/I is so large that linear algebra in it would not fit, or
/// large and the basis so sparse that it would not pay.
///
/// Over GF(p) by fglm(), for lex and a single variable in shape position if it can. Over ℚ modulo primes that
/// divide no leading coefficient: coefficients are lifted until another prime agrees, and with `proof` full
/// the candidate is proved (order_proof.hpp). Primes modulo which other monomials are standard than modulo
/// the best ones are left out: monomials independent modulo a prime are independent over ℚ, so the standard
/// monomials over ℚ precede those modulo any prime.
std::optional<ChangedOrder> change_order(std::span<const algebra::Polynomial> reduced_basis,
                                         const algebra::Ring& target, Proof proof, base::Run& run);

} // namespace eliminant::groebner
