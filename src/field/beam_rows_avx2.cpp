#include "beam_rows_kernel.hpp"
#include "pack_avx2.hpp"

namespace eliminant::field {

void detail::solve_beam_row_avx2(const BeamRow& row) { solve_row<Pack4>(row); }
void detail::first_roots_avx2(const FirstRootBatch& batch) { solve_batch<Pack4>(batch); }

} // namespace eliminant::field
