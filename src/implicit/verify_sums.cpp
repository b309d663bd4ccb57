#include "implicit/verify_sums.hpp"

namespace eliminant::implicit {

namespace {

void product_sums_portable(std::uint64_t* sums, const std::uint32_t* powers, const std::uint32_t* exponents,
                           const std::uint32_t* values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t* power = powers + std::size_t{8} * exponents[i];
        for (std::size_t lane = 0; lane < 8; ++lane)
            sums[lane] += std::uint64_t{power[lane]} * values[8 * i + lane];
    }
}

} // namespace

ProductSums product_sums(base::VectorUnit unit) {
#if defined(__x86_64__)
    if (unit == base::VectorUnit::avx512) return product_sums_avx512;
    if (unit == base::VectorUnit::avx2) return product_sums_avx2;
#else
    static_cast<void>(unit);
#endif
    return product_sums_portable;
}

} // namespace eliminant::implicit
