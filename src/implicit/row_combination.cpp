#include "implicit/row_combination.hpp"

namespace eliminant::implicit {

namespace {

void combine_rows(std::uint64_t* sums, const std::uint32_t* const rows[4], const std::uint32_t factors[4],
                  std::size_t count) {
    const std::uint64_t f0 = factors[0];
    const std::uint64_t f1 = factors[1];
    const std::uint64_t f2 = factors[2];
    const std::uint64_t f3 = factors[3];
    for (std::size_t j = 0; j < count; ++j)
        sums[j] += f0 * rows[0][j] + f1 * rows[1][j] + f2 * rows[2][j] + f3 * rows[3][j];
}

} // namespace

RowCombination row_combination(base::VectorUnit unit) {
#if defined(__x86_64__)
    if (unit == base::VectorUnit::avx512) return combine_rows_avx512;
    if (unit == base::VectorUnit::avx2) return combine_rows_avx2;
#else
    static_cast<void>(unit);
#endif
    return combine_rows;
}

} // namespace eliminant::implicit
