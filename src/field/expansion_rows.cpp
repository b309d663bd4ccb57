#include "field/expansion_rows.hpp"

#include "field/expansion_rows_kernel.hpp"
#include "field/single_pack.hpp"

namespace eliminant::field {

void detail::expand_portable(const ExpansionView& f, const double* const* points, double* workspace,
                             double* rows) {
    ExpansionKernel<SinglePack>(f, points, workspace, rows).run();
}

Expander expander(base::VectorUnit unit) {
#if defined(__x86_64__)
    if (unit == base::VectorUnit::avx512) return {detail::expand_avx512, 8};
    if (unit == base::VectorUnit::avx2) return {detail::expand_avx2, 4};
#endif
    static_cast<void>(unit);
    return {detail::expand_portable, 1};
}

} // namespace eliminant::field
