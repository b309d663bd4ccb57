// The primes of a modular computation.
#pragma once

#include "algebra/random.hpp"
#include "eliminant/algebra/prime_field.hpp"

#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <utility>
#include <vector>

namespace eliminant::groebner {

/// Distinct primes between 2^30 and 2^31. They are drawn at random, so that no input that was made without
/// knowledge of the seed has all the first ones for bad primes.
class PrimeSequence {
  public:
    /// \param seed the same seed gives the same primes
    /// \param first these come before the others
    explicit PrimeSequence(std::uint64_t seed, std::vector<std::uint32_t> first = {})
        : random_(seed), first_(std::move(first)) {}

    std::uint32_t next() {
        std::uint32_t p = 0;
        do p = count_ < first_.size() ? first_[count_++] : drawn();
        while (!used_.insert(p).second);
        return p;
    }

  private:
    std::uint32_t drawn() {
        constexpr std::uint32_t least = 1U << 30;
        return static_cast<std::uint32_t>(algebra::previous_prime(least + 64 + random_.below(least - 64)));
    }

    algebra::Random random_;
    std::vector<std::uint32_t> first_;
    std::size_t count_ = 0;
    std::unordered_set<std::uint32_t> used_;
};

} // namespace eliminant::groebner
