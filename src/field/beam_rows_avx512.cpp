#include "beam_rows_kernel.hpp"
#include "pack_avx512.hpp"

namespace eliminant::field {

void detail::solve_beam_row_avx512(const BeamRow& row) { solve_row<Pack8>(row); }
void detail::first_roots_avx512(const FirstRootBatch& batch) { solve_batch<Pack8>(batch); }

} // namespace eliminant::field
