#pragma once

#include "eliminant/algebra/integer.hpp"
#include "eliminant/algebra/prime_field.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eliminant::algebra {

/// Integers known by their residues modulo more and more primes, in the symmetric range around 0.
///
/// Values are named by places; a place without a residue has residue 0, so that sparse vectors can be
/// collected before their support is known.
class ChineseRemainders {
  public:
    /// Adds residues[i] modulo the prime for places[i], which increase. The prime is new. Returns whether a
    /// value changed; if none did, the values are probably the integers themselves.
    bool add(const PrimeField& field, const std::vector<std::size_t>& places,
             const std::vector<std::uint32_t>& residues);

    const std::vector<std::size_t>& places() const { return places_; }
    const std::vector<Integer>& values() const { return values_; }
    /// Product of the primes.
    const Integer& modulus() const { return modulus_; }
    /// Whether all values are so small beside the modulus that chance would hardly make them so: at most its
    /// square root.
    bool small() const;

  private:
    std::vector<std::size_t> places_;
    std::vector<Integer> values_;
    Integer modulus_ = Integer(1);
};

} // namespace eliminant::algebra
