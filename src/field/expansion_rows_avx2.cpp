#include "field/expansion_rows_kernel.hpp"
#include "field/pack_avx2.hpp"

namespace eliminant::field {

void detail::expand_avx2(const ExpansionView& f, const double* const* points, double* workspace,
                         double* rows) {
    ExpansionKernel<Pack4>(f, points, workspace, rows).run();
}

} // namespace eliminant::field
