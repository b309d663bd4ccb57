#include "beam_rows_kernel.hpp"
#include "single_pack.hpp"

namespace eliminant::field {

void detail::solve_beam_row_portable(const BeamRow& row) { solve_row<SinglePack>(row); }
void detail::first_roots_portable(const FirstRootBatch& batch) { solve_batch<SinglePack>(batch); }

BeamRowSolver beam_row_solver(base::VectorUnit unit) {
#if defined(__x86_64__)
    if (unit == base::VectorUnit::avx512) return detail::solve_beam_row_avx512;
    if (unit == base::VectorUnit::avx2) return detail::solve_beam_row_avx2;
#endif
    static_cast<void>(unit);
    return detail::solve_beam_row_portable;
}

FirstRootSolver first_root_solver(base::VectorUnit unit) {
#if defined(__x86_64__)
    if (unit == base::VectorUnit::avx512) return detail::first_roots_avx512;
    if (unit == base::VectorUnit::avx2) return detail::first_roots_avx2;
#endif
    static_cast<void>(unit);
    return detail::first_roots_portable;
}

} // namespace eliminant::field
