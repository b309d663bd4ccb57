/// \file
/// Entry points of the batch kernels; nothing of the standard library, for files of one instruction set.
#pragma once

#include "field/batch_kernel.hpp"

namespace eliminant::field {

void batch_portable(const ProgramView&, const double*, const BatchArrays<double>&, unsigned long count);
void batch_portable(const ProgramView&, const float*, const BatchArrays<float>&, unsigned long count);
#if defined(__x86_64__)
void batch_avx2(const ProgramView&, const double*, const BatchArrays<double>&, unsigned long count);
void batch_avx2(const ProgramView&, const float*, const BatchArrays<float>&, unsigned long count);
void batch_avx512(const ProgramView&, const double*, const BatchArrays<double>&, unsigned long count);
void batch_avx512(const ProgramView&, const float*, const BatchArrays<float>&, unsigned long count);
#endif

} // namespace eliminant::field
