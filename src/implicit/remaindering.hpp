// Polynomials over ℚ from their images modulo primes.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace eliminant::implicit {

/// Monic polynomials modulo a growing product M of primes, and the rational polynomials behind them.
class Remaindering {
  public:
    /// \param ring over ℚ, with names and order of the rings of the images
    explicit Remaindering(algebra::Ring ring) : ring_(std::move(ring)) {}

    /// Whether images have the leading monomials of those added so far; true if there are none.
    bool accepts(const std::vector<algebra::Polynomial>& images) const;
    /// Adds the images, monic over some GF(p), for a prime not used before (Garner's form of the Chinese
    /// remainder theorem: von zur Gathen and Gerhard, Modern Computer Algebra, §5.4).
    void add(const std::vector<algebra::Polynomial>& images, base::Run& run);

    /// Primitive integer polynomials, each a multiple modulo M of one of the images, with coefficients n of
    /// 2n² < M; nullopt if there are none. At most one such polynomial exists up to sign (ibid., §5.10).
    std::optional<std::vector<algebra::Polynomial>> reconstruct(base::Run& run) const;

    const mpz_class& modulus() const { return modulus_; } ///< M; 1 at the beginning.
    std::uint64_t prime_count() const { return primes_; } ///< How many primes M has.

  private:
    algebra::Ring ring_;
    std::vector<algebra::Polynomial> residues_; ///< integer coefficients in (−M/2, M/2]
    mpz_class modulus_ = 1;
    std::uint64_t primes_ = 0;
};

} // namespace eliminant::implicit
