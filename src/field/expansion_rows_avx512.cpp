#include "field/expansion_rows_kernel.hpp"
#include "field/pack_avx512.hpp"

namespace eliminant::field {

void detail::expand_avx512(const ExpansionView& f, const double* const* points, double* workspace,
                           double* rows) {
    ExpansionKernel<Pack8>(f, points, workspace, rows).run();
}

} // namespace eliminant::field
