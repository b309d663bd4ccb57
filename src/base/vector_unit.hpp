/// \file
/// Which vector instructions the processor has.
#pragma once

#include <string_view>
#include <type_traits>
#include <vector>

namespace eliminant::base {

/// The instruction sets for which some kernels are compiled. `portable` is plain C++ and runs everywhere; it
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

/// visit(std::integral_constant<VectorUnit, unit>{}), or that of `portable` for a unit of other machines: how
/// the instance of a kernel (pack.hpp) is chosen.
template <class Visitor>
auto with_unit(VectorUnit unit, const Visitor& visit) {
    switch (unit) {
#if defined(__x86_64__)
    case VectorUnit::avx512:
        return visit(std::integral_constant<VectorUnit, VectorUnit::avx512>{});
    case VectorUnit::avx2:
        return visit(std::integral_constant<VectorUnit, VectorUnit::avx2>{});
#elif defined(__aarch64__)
    case VectorUnit::neon:
        return visit(std::integral_constant<VectorUnit, VectorUnit::neon>{});
#endif
    default:
        return visit(std::integral_constant<VectorUnit, VectorUnit::portable>{});
    }
}

} // namespace eliminant::base
