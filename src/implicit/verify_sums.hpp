// The inner loop of evaluation at eight points, for each vector unit.
#pragma once

#include "base/vector_unit.hpp"

#include <cstddef>
#include <cstdint>

namespace eliminant::implicit {

/// sums[k] += Σ powers[8·exponents[i] + k]·values[8·i + k] over 0 ≤ i < count, for eight lanes k; the caller
/// knows that no sum overflows.
using ProductSums = void (*)(std::uint64_t* sums, const std::uint32_t* powers, const std::uint32_t* exponents,
                             const std::uint32_t* values, std::size_t count);

/// The loop for a vector unit; the portable one where there is none of its own.
ProductSums product_sums(base::VectorUnit unit);

void product_sums_avx2(std::uint64_t* sums, const std::uint32_t* powers, const std::uint32_t* exponents,
                       const std::uint32_t* values, std::size_t count);
void product_sums_avx512(std::uint64_t* sums, const std::uint32_t* powers, const std::uint32_t* exponents,
                         const std::uint32_t* values, std::size_t count);

} // namespace eliminant::implicit
