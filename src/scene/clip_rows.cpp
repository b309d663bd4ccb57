#include "clip_rows_kernel.hpp"

#include "field/single_pack.hpp"

namespace eliminant::scene {

void detail::clip_row_portable(const ClipRow& row) { clip_row<field::SinglePack>(row); }
void detail::clip_stars_portable(const ClipStars& stars) { clip_stars<field::SinglePack>(stars); }

RowClipper row_clipper(base::VectorUnit unit) {
#if defined(__x86_64__)
    if (unit == base::VectorUnit::avx512) return detail::clip_row_avx512;
    if (unit == base::VectorUnit::avx2) return detail::clip_row_avx2;
#endif
    static_cast<void>(unit);
    return detail::clip_row_portable;
}

StarClipper star_clipper(base::VectorUnit unit) {
#if defined(__x86_64__)
    if (unit == base::VectorUnit::avx512) return detail::clip_stars_avx512;
    if (unit == base::VectorUnit::avx2) return detail::clip_stars_avx2;
#endif
    static_cast<void>(unit);
    return detail::clip_stars_portable;
}

} // namespace eliminant::scene
