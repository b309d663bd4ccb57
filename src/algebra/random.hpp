#pragma once

#include <cstdint>

namespace eliminant::algebra {

/// SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): a random word in a few instructions, and a state that
/// costs nothing to set up, unlike a Mersenne twister, which takes as long to seed as most gcds of small
/// polynomials.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t operator()() {
        state_ += 0x9e3779b97f4a7c15;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }
    /// In [0, bound), bound > 0. The bias, below bound/2^64, is of no account in choosing points.
    std::uint32_t below(std::uint32_t bound) { return static_cast<std::uint32_t>((*this)() % bound); }

  private:
    std::uint64_t state_;
};

} // namespace eliminant::algebra
