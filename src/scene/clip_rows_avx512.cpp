#include "clip_rows_kernel.hpp"

#include "field/pack_avx512.hpp"

namespace eliminant::scene {

void detail::clip_row_avx512(const ClipRow& row) { clip_row<Pack8>(row); }
void detail::clip_stars_avx512(const ClipStars& stars) { clip_stars<Pack8>(stars); }

} // namespace eliminant::scene
