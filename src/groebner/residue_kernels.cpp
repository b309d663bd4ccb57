#include "groebner/residue_kernels_body.hpp"

namespace eliminant::groebner {

#if defined(__x86_64__)
extern const ResidueKernels residue_kernels_avx2;
extern const ResidueKernels residue_kernels_avx512;
#endif

const ResidueKernels& residue_kernels(base::VectorUnit unit) noexcept {
    switch (unit) {
#if defined(__x86_64__)
    case base::VectorUnit::avx2:
        return residue_kernels_avx2;
    case base::VectorUnit::avx512:
        return residue_kernels_avx512;
#endif
    default:
        return compiled_kernels; // on arm64 these are NEON code already
    }
}

} // namespace eliminant::groebner
