#include "clip_rows_kernel.hpp"

#include "field/pack_avx2.hpp"

namespace eliminant::scene {

void detail::clip_row_avx2(const ClipRow& row) { clip_row<Pack4>(row); }
void detail::clip_stars_avx2(const ClipStars& stars) { clip_stars<Pack4>(stars); }

} // namespace eliminant::scene
