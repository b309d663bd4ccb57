/// \file
/// Which vector instructions the processor has.
#pragma once

#include <string_view>
#include <vector>

namespace eliminant::base {

/// The instruction sets for which some kernels exist twice. `portable` is plain C++ and runs everywhere; it
/// is what the others are tested against.
enum class VectorUnit : unsigned char {
    portable,
    neon,   ///< arm64: 128-bit registers
    avx2,   ///< x86-64: 256-bit registers, with FMA
    avx512, ///< x86-64: 512-bit registers: F, DQ, BW, VL
};

/// The widest one that this processor and operating system support; asked once.
VectorUnit best_vector_unit() noexcept;

/// All that can run here, `portable` first: what a test of kernels goes through.
std::vector<VectorUnit> available_vector_units();

/// As `avx2`.
std::string_view name(VectorUnit unit) noexcept;

} // namespace eliminant::base
