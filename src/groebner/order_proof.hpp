// What proves a basis over ℚ that was lifted from fglm() modulo primes.
#pragma once

#include "algebra/rational_lifting.hpp"
#include "groebner/rational_quotient.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// A candidate for ConvertedBasis over ℚ: tails, and in shape position numerators.
struct LiftedBasis {
    using Vector = algebra::RationalLifting::Vector;
    std::span<const algebra::Monomial> standard;
    std::span<const algebra::Monomial> leads;
    std::span<const Vector> tails;
    std::span<const Vector> numerators;
};

/// Whether the candidate is the reduced basis of the elimination ideal: whether the normal form of each
/// element is 0, exactly.
///
/// Why it suffices: every monomial that is not a multiple of a lead is standard, and the standard monomials,
/// independent in the residue class ring modulo a prime, are so over ℚ. So an element of the ideal that the
/// candidate reduces to standard monomials reduces to 0. O(D²) products of long numbers for each standard
/// monomial and each element.
bool is_in_ideal(const LiftedBasis& candidate, RationalQuotient& quotient,
                 std::span<const std::size_t> variables, base::Run& run);

/// The proof in shape position, without computing in the residue class ring over ℚ.
///
/// Let M be the matrix of multiplication by the last variable y, and Δ the product of the denominators δ_b
/// of its columns. With χ the characteristic polynomial of M, the coefficients of Δ·χ = det((z − M)·diag(δ)),
/// of Δ·N = r·Δ·adj(z − M)·1 and of Δ·dⱼ·Nⱼ, dⱼ the denominator of xⱼ's normal form, are integers, and for
/// |z| = 1 Hadamard's inequality bounds the determinants, and so all coefficients (Cauchy). A candidate that
/// agrees with them modulo primes whose product exceeds the sum of this bound and of its own size is equal to
/// them.
class ShapeProof {
  public:
    /// \param y the last variable \param others the variables xⱼ in the sequence of the numerators
    ShapeProof(RationalQuotient& quotient, std::size_t y, std::span<const std::size_t> others,
               base::Run& run);

    /// The number of bits that the product of the primes must have for the power of y and the numerators of
    /// the candidate to be proved; nullopt if they are wrong.
    std::optional<double> modulus_bits_needed(const LiftedBasis& candidate) const;

    /// Whether the other elements xⱼ − qⱼ(y) follow from these: qⱼ·N ≡ Nⱼ modulo χ.
    static bool follows(const LiftedBasis& candidate, base::Run& run);

  private:
    algebra::Integer denominator_;                        ///< Δ
    double bits_ = 0;                                     ///< log₂ of the bound for Δ·χ
    double form_bits_ = 0;                                ///< log₂ of the sum of the values of r
    std::vector<algebra::Integer> variable_denominators_; ///< dⱼ
    std::vector<double> variable_bits_;                   ///< log₂ of the sum of the numerators of xⱼ
};

} // namespace eliminant::groebner
