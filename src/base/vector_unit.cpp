#include "base/vector_unit.hpp"

namespace eliminant::base {
namespace {

VectorUnit detect() noexcept {
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"))
        return VectorUnit::avx512;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return VectorUnit::avx2;
    return VectorUnit::portable;
#elif defined(__aarch64__)
    return VectorUnit::neon; // part of every 64-bit Arm
#else
    return VectorUnit::portable;
#endif
}

} // namespace

VectorUnit best_vector_unit() noexcept {
    static const VectorUnit best = detect();
    return best;
}

std::vector<VectorUnit> available_vector_units() {
    std::vector<VectorUnit> units = {VectorUnit::portable};
    const VectorUnit best = best_vector_unit();
    if (best == VectorUnit::avx512) units.push_back(VectorUnit::avx2);
    if (best != VectorUnit::portable) units.push_back(best);
    return units;
}

std::string_view name(VectorUnit unit) noexcept {
    switch (unit) {
    case VectorUnit::neon:
        return "neon";
    case VectorUnit::avx2:
        return "avx2";
    case VectorUnit::avx512:
        return "avx512";
    case VectorUnit::portable:
        break;
    }
    return "portable";
}

} // namespace eliminant::base
