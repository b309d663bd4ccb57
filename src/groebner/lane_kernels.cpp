#include "lane_kernels.hpp"

#include <bit>

namespace eliminant::groebner {
namespace {

/// Plain C++, and so also NEON: on arm64 compilers make vector instructions of these loops.
using Vector = LaneSum;

template <class F>
inline Vector per_lane(F&& f) {
    Vector result;
    for (std::size_t i = 0; i < lane_count; ++i) result.lane[i] = f(i);
    return result;
}

inline Vector zero() {
    return per_lane([](std::size_t) { return std::uint64_t{0}; });
}
inline Vector load(const LaneSum& x) { return x; }
inline void store(LaneSum& x, const Vector& v) { x = v; }
inline Vector load(const LaneEntry& x) {
    return per_lane([&](std::size_t i) { return x.lane[i]; });
}
inline void store(LaneEntry& x, const Vector& v) {
    for (std::size_t i = 0; i < lane_count; ++i) x.lane[i] = static_cast<std::uint32_t>(v.lane[i]);
}
inline Vector load(const std::uint32_t& x) {
    return per_lane([&](std::size_t) { return x; });
}
inline unsigned nonzero_lanes(const Vector& v) {
    unsigned lanes = 0;
    for (std::size_t i = 0; i < lane_count; ++i) lanes |= (v.lane[i] != 0 ? 1U : 0U) << i;
    return lanes;
}
inline Vector subtract(const Vector& a, const Vector& b) {
    return per_lane([&](std::size_t i) { return a.lane[i] - b.lane[i]; });
}
inline Vector multiply_low_halves(const Vector& a, const Vector& b) {
    return per_lane([&](std::size_t i) { return (a.lane[i] & 0xffffffffU) * (b.lane[i] & 0xffffffffU); });
}
inline Vector shift_down(const Vector& a, const Vector& bits) {
    return per_lane([&](std::size_t i) { return a.lane[i] >> bits.lane[i]; });
}
/// a < b ? a : a − b.
inline Vector subtract_if_not_less(const Vector& a, const Vector& b) {
    return per_lane([&](std::size_t i) { return a.lane[i] - (a.lane[i] < b.lane[i] ? 0 : b.lane[i]); });
}
/// a − b modulo m for a, b < m < 2^63: all ones where the difference is negative select m.
inline Vector subtract_modulo(const Vector& a, const Vector& b, const Vector& m) {
    return per_lane([&](std::size_t i) {
        const std::uint64_t difference = a.lane[i] - b.lane[i];
        return difference + (m.lane[i] & (std::uint64_t{0} - (difference >> 63)));
    });
}

} // namespace
} // namespace eliminant::groebner

#include "lane_kernels_body.hpp"

namespace eliminant::groebner {

#if defined(__x86_64__)
extern const LaneKernels lane_kernels_avx2;
extern const LaneKernels lane_kernels_avx512;
#endif

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

const LaneKernels& lane_kernels(base::VectorUnit unit) {
#if defined(__x86_64__)
    if (unit == base::VectorUnit::avx512) return lane_kernels_avx512;
    if (unit == base::VectorUnit::avx2) return lane_kernels_avx2;
#endif
    static_cast<void>(unit);
    return kernels;
}

} // namespace eliminant::groebner
