#include "clip_rows_kernel.hpp"

#include "field/pack_avx2.hpp"

namespace eliminant::scene {

void detail::clip_row_avx2(const ClipRow& row) { clip_row<Pack4>(row); }

} // namespace eliminant::scene
