#include "groebner/residue_kernels.hpp"

#include "base/pack.hpp"

namespace eliminant::groebner {
namespace {

// Compilers turn these loops into vector code as they are.

ResidueKernels::Sum dot(const std::uint32_t* a, const std::uint32_t* b, std::size_t n) {
    std::uint64_t high = 0;
    std::uint64_t low = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const std::uint64_t product = std::uint64_t{a[i]} * b[i];
        high += product >> 32;
        low += product & 0xffffffffU;
    }
    return {high, low};
}

void subtract_multiple(std::uint64_t* __restrict v, const std::uint32_t* __restrict row, std::size_t n,
                       std::uint32_t factor, std::uint64_t p_squared) {
    for (std::size_t i = 0; i < n; ++i) {
        // Both are below p² < 2^62, so the difference has its sign in the top bit.
        const std::uint64_t difference = v[i] - std::uint64_t{factor} * row[i];
        const auto sign = static_cast<std::uint64_t>(static_cast<std::int64_t>(difference) >> 63);
        v[i] = difference + (p_squared & sign);
    }
}

} // namespace

template <base::VectorUnit unit>
const ResidueKernels& residue_kernels_of() noexcept {
    static constexpr ResidueKernels kernels = {dot, subtract_multiple};
    return kernels;
}

template const ResidueKernels& residue_kernels_of<base::this_unit>() noexcept;

} // namespace eliminant::groebner
