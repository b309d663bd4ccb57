// A Groebner basis in another order, or of an elimination ideal, by linear algebra in the residue class ring.
#pragma once

#include "groebner/quotient_algebra.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// A reduced Groebner basis modulo a prime: element i is leads[i] − Σ_s tails[i][s]·standard[s].
struct ConvertedBasis {
    std::vector<algebra::Monomial> standard;       ///< ascending
    std::vector<algebra::Monomial> leads;          ///< ascending
    std::vector<std::vector<std::uint32_t>> tails; ///< one residue a standard monomial
    /// Of fglm_in_shape_position() only: N, then Nⱼ in the sequence of leads from the second one on.
    std::vector<std::vector<std::uint32_t>> numerators;
};

/// The reduced basis of I ∩ GF(p)[target's variables] in the order of `target`; variable i of target is
/// variable variables[i] of I's ring. FGLM (see QuotientAlgebra): the monomials of `target` ascending, those
/// that depend linearly on smaller ones being leading. O(n·D³) for D ≥ 1 standard monomials.
ConvertedBasis fglm(QuotientAlgebra& algebra, const algebra::Ring& target,
                    std::span<const std::size_t> variables, base::Run& run);

/// The same for lex when all standard monomials are powers of the last variable y, the general case; nullopt
/// if they are not, and, with probability at most 2D/p, when they are.
///
/// For a random linear form r the sequence r(yⁱ) has, in this case, the minimal polynomial μ of y as its own;
/// μ comes from 2D values (Berlekamp–Massey, Wiedemann 1986), and with N/μ = Σ r(yⁱ)·z^(−i−1) and
/// Nⱼ/μ = Σ r(xⱼ·yⁱ)·z^(−i−1), xⱼ is congruent to Nⱼ/N mod μ at y (Faugère and Mou, J. Symb. Comp. 80
/// (2017)). O(D·m·D) for m products of y with standard monomials that are not standard: in degrevlex a small
/// part of D, and mostly leading monomials, whose normal forms are known.
///
/// The values of r on the standard monomials are integers in [0, 2^31) that depend only on the seed and on D.
std::optional<ConvertedBasis> fglm_in_shape_position(QuotientAlgebra& algebra, const algebra::Ring& target,
                                                     std::span<const std::size_t> variables, base::Run& run);

} // namespace eliminant::groebner
