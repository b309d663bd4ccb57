#include "algebra/residue_rows_body.hpp"

namespace eliminant::algebra {

#if defined(__x86_64__)
extern const ResidueRows residue_rows_avx2;
extern const ResidueRows residue_rows_avx512;
#endif

const ResidueRows& residue_rows(base::VectorUnit unit) noexcept {
    switch (unit) {
#if defined(__x86_64__)
    case base::VectorUnit::avx2:
        return residue_rows_avx2;
    case base::VectorUnit::avx512:
        return residue_rows_avx512;
#endif
    default:
        return compiled_rows; // on arm64 these are NEON code already
    }
}

} // namespace eliminant::algebra
