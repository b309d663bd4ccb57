// The Chinese remainder theorem for many numbers and the same primes.
#pragma once

#include "eliminant/algebra/integer.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// Makes numbers of their residues modulo fixed primes p₁, …, p_k below 2^31 with product M, by
///
///     x ≡ Σ yᵢ·(M/pᵢ),    yᵢ = rᵢ·(M/pᵢ)⁻¹ mod pᵢ
///
/// (von zur Gathen and Gerhard, Modern Computer Algebra, §5.4). Two primes share a row M/(p·p′) of the table,
/// since y·(M/p) + y′·(M/p′) = (y·p′ + y′·p)·(M/(p·p′)) with a first factor below 2^63. So a number takes
/// k/2 multiplications of a word by k/2 words, half of what it takes one prime after the other, and without
/// any division. For thousands of primes a tree of products would be faster.
class RemainderTable {
  public:
    /// A factor for the residues of a number, prepared for this table.
    struct Factor {
        std::vector<std::uint32_t> value;   ///< per prime, (M/p)⁻¹ included
        std::vector<std::uint32_t> shifted; ///< per prime ⌊value·2^32/p⌋
    };

    /// \param primes odd, distinct, below 2^31; at least one
    explicit RemainderTable(std::span<const std::uint32_t> primes);

    std::size_t prime_count() const { return primes_.size(); }
    const mpz_class& modulus() const { return modulus_; }
    /// Number of bits of the modulus.
    std::size_t modulus_bits() const { return mpz_sizeinbase(modulus_.get_mpz_t(), 2); }

    Factor prepare(const Integer& factor) const;
    /// result = factor·x modulo M, in [−M/2, M/2] but for a relative error of 2^−40 of the ends, x being
    /// given by its residues modulo the primes. \param scratch is used as it likes
    void combine(std::span<const std::uint32_t> residues, const Factor& factor,
                 std::vector<mp_limb_t>& scratch, mpz_class& result) const;

  private:
    const mp_limb_t* row(std::size_t pair) const { return rows_.data() + pair * limbs_; }

    std::vector<std::uint32_t> primes_;
    std::vector<std::uint32_t> inverses_; ///< per prime, of M/p
    mpz_class modulus_;
    std::size_t limbs_;              ///< of the modulus
    std::vector<mp_limb_t> rows_;    ///< per pair limbs_ words: M/(p·p′)
    std::vector<double> reciprocal_; ///< per pair 1/(p·p′)
};

} // namespace eliminant::algebra
