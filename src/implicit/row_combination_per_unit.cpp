#include "implicit/row_combination.hpp"

#include "base/pack.hpp"

namespace eliminant::implicit {

using base::Halves;
using base::Words;

template <base::VectorUnit unit>
void combine_rows(std::uint64_t* sums, const std::uint32_t* const rows[4], const std::uint32_t factors[4],
                  std::size_t count) {
    Halves f[4];
    for (int i = 0; i < 4; ++i) f[i] = Halves::all(factors[i]);
    std::size_t j = 0;
    for (; j + Words::lanes <= count; j += Words::lanes) {
        Words sum = Words::load(sums + j);
        for (int i = 0; i < 4; ++i) sum = sum + Halves::load(rows[i] + j) * f[i];
        sum.store(sums + j);
    }
    for (; j < count; ++j)
        for (int i = 0; i < 4; ++i) sums[j] += std::uint64_t{factors[i]} * rows[i][j];
}

template void combine_rows<base::this_unit>(std::uint64_t*, const std::uint32_t* const[4],
                                            const std::uint32_t[4], std::size_t);

} // namespace eliminant::implicit
