// Finite algebras of one generator over a prime field.
#pragma once

#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/run.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::implicit {

using Residue = algebra::PrimeField::Element;
/// Coefficients of a polynomial in one variable from the constant one up, or of an element in 1, t, t², ….
using Residues = std::vector<Residue>;

/// Primes of the methods that multiply vectors: products of two residues stay below 2^58, so a word takes 63
/// of them before it must be reduced.
constexpr std::uint64_t short_prime_bound = std::uint64_t{1} << 29;
constexpr std::size_t short_products_in_word = 63;

/// Σ a[i]·b[i] modulo a prime below short_prime_bound; the lengths are equal.
Residue dot_product(const algebra::PrimeField& field, std::span<const Residue> a, std::span<const Residue> b);

/// A = GF(p)[t]/(R) for a monic R of degree n ≥ 1 and p below short_prime_bound: the functions on n points,
/// the roots of R, as long as these are distinct. Not to be shared by threads: products use scratch memory.
class QuotientAlgebra {
  public:
    /// \param run polled once a product
    QuotientAlgebra(const algebra::PrimeField& field, Residues modulus, const base::Run& run);

    std::size_t dimension() const { return modulus_.size() - 1; }
    const Residues& modulus() const { return modulus_; }

    /// The class of a polynomial of any degree.
    Residues element(Residues polynomial) const;
    /// The class of t.
    Residues generator() const { return element({0, 1}); }
    /// O(n²).
    Residues multiply(std::span<const Residue> a, std::span<const Residue> b) const;
    /// Σ coefficients[i]·aⁱ, by Horner's rule; coefficients of any degree.
    Residues value(std::span<const Residues> coefficients, std::span<const Residue> a) const;
    /// nullopt if a vanishes at a root of R. O(n²).
    std::optional<Residues> inverse(const Residues& a) const;

    /// The traces of a, a², …, a^count: the power sums of the values of a at the roots of R, with their
    /// multiplicities. By baby steps aⁱ and giant steps a^(qj), of which tr(aⁱ·a^(qj)) is a bilinear form:
    /// about 2√count products instead of count (Shoup, J. Symb. Comput. 20 (1995), §3).
    Residues traces_of_powers(const Residues& a, std::size_t count) const;

  private:
    void fold(std::size_t end) const;
    void accumulate(std::size_t at, Residue factor, std::span<const Residue> row) const;
    Residues reduced(std::size_t length) const;
    const Residues& traces_of_generator() const;

    const algebra::PrimeField& field_;
    const base::Run& run_;
    Residues modulus_;
    Residues negated_tail_; ///< −R without its leading term: tⁿ in A
    mutable std::vector<std::uint64_t> wide_;
    mutable std::size_t pending_ = 0; ///< products that a word of wide_ may hold
    mutable Residues traces_;         ///< tr(tⁱ), once they were needed
};

/// The monic polynomial of degree n whose roots, with multiplicities, have the power sums s₁, …, sₙ; n < p.
/// Newton's identities, O(n²).
Residues from_power_sums(const algebra::PrimeField& field, std::span<const Residue> sums);

} // namespace eliminant::implicit
