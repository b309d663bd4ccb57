#include "lane_kernels.hpp"

#include <bit>

namespace eliminant::groebner {

LanePrimes::LanePrimes(const LaneEntry& primes) {
    for (std::size_t i = 0; i < lane_count; ++i) {
        const std::uint64_t prime = primes.lane[i];
        const auto bits = static_cast<unsigned>(std::bit_width(prime));
        p.lane[i] = prime;
        square.lane[i] = prime * prime;
        reciprocal.lane[i] = (std::uint64_t{1} << (2 * bits)) / prime;
        low_shift.lane[i] = bits - 1;
        high_shift.lane[i] = bits + 1;
    }
}

} // namespace eliminant::groebner
