#include "groebner/residue_kernels_body.hpp"

namespace eliminant::groebner {

extern const ResidueKernels residue_kernels_avx512;
const ResidueKernels residue_kernels_avx512 = compiled_kernels;

} // namespace eliminant::groebner
