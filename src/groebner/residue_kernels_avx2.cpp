#include "groebner/residue_kernels_body.hpp"

namespace eliminant::groebner {

extern const ResidueKernels residue_kernels_avx2;
const ResidueKernels residue_kernels_avx2 = compiled_kernels;

} // namespace eliminant::groebner
