// The loops of ResidueKernels, in a form that compilers turn into vector code; each instruction set compiles
// its own copy, so everything has internal linkage.
#pragma once

#include "groebner/residue_kernels.hpp"

namespace eliminant::groebner {
namespace {

inline ResidueKernels::Sum dot(const std::uint32_t* a, const std::uint32_t* b, std::size_t n) {
    std::uint64_t high = 0;
    std::uint64_t low = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const std::uint64_t product = std::uint64_t{a[i]} * b[i];
        high += product >> 32;
        low += product & 0xffffffffU;
    }
    return {high, low};
}

inline void subtract_multiple(std::uint64_t* __restrict v, const std::uint32_t* __restrict row, std::size_t n,
                              std::uint32_t factor, std::uint64_t p_squared) {
    for (std::size_t i = 0; i < n; ++i) {
        // Both are below p² < 2^62, so the difference has its sign in the top bit.
        const std::uint64_t difference = v[i] - std::uint64_t{factor} * row[i];
        const auto sign = static_cast<std::uint64_t>(static_cast<std::int64_t>(difference) >> 63);
        v[i] = difference + (p_squared & sign);
    }
}

inline constexpr ResidueKernels compiled_kernels = {dot, subtract_multiple};

} // namespace
} // namespace eliminant::groebner
