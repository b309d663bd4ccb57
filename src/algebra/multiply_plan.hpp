#pragma once

#include "multiply_window.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace eliminant::algebra {

/// windows[m]: how many windows of 2^m keys the decreasing keys meet, up to m = max_window_bits.
constexpr unsigned max_window_bits = 18;
using WindowCounts = std::array<std::size_t, max_window_bits + 1>;

inline unsigned bit_width(std::uint64_t x) { return static_cast<unsigned>(std::bit_width(x)); }
inline unsigned bit_width(base::UInt128 x) {
    const auto high = static_cast<std::uint64_t>(x >> 64);
    return high != 0 ? 64 + bit_width(high) : bit_width(static_cast<std::uint64_t>(x));
}

template <class Key>
WindowCounts count_windows(const std::vector<Key>& keys) {
    // Neighbours whose highest differing bit is m − 1 share windows from 2^m on.
    std::array<std::size_t, 130> differing{};
    for (std::size_t i = 1; i < keys.size(); ++i) ++differing[bit_width(keys[i - 1] ^ keys[i])];
    WindowCounts counts{};
    std::size_t pairs = keys.size();
    for (unsigned m = 0; m <= max_window_bits; ++m) {
        pairs -= differing[m];
        counts[m] = pairs;
    }
    return counts;
}

/// What a product is expected to cost, in nanoseconds; the constants were measured on Zen 5 with
/// bench_arithmetic.
struct WindowChoice {
    unsigned bits = 0;    ///< 0: the heap
    bool swapped = false; ///< rows are the terms of b
    double cost = 0;
};

/// Of one product where the heap holds so many rows.
inline double heap_cost(double rows) { return 6 + 2.5 * std::log2(rows + 1); }
/// Of one product added to a window of so many bytes: level 1, 2 and 3 caches.
inline double cell_cost(double bytes) {
    return bytes <= 16e3 ? 0.8 : bytes <= 300e3 ? 1.0 : bytes <= 800e3 ? 1.4 : 3.0;
}
/// Of passing over one untouched cell.
constexpr double scan_cost = 0.5 / 128;

/// `extra` is what a product of coefficients costs beyond one of words.
inline WindowChoice choose_window(const WindowCounts& a, const WindowCounts& b, double key_range,
                                  std::size_t cell_bytes, double extra) {
    const auto products = static_cast<double>(a[0]) * static_cast<double>(b[0]);
    WindowChoice best;
    best.swapped = b[0] < a[0];
    best.cost = products * (extra + heap_cost(static_cast<double>(std::min(a[0], b[0]))));
    for (unsigned m = min_window_bits; m <= max_window_bits; ++m) {
        const auto cells = std::ldexp(1.0, static_cast<int>(m));
        const double bytes = cells * static_cast<double>(cell_bytes);
        for (const bool swapped : {false, true}) {
            const double events = swapped ? static_cast<double>(b[0]) * static_cast<double>(a[m])
                                          : static_cast<double>(a[0]) * static_cast<double>(b[m]);
            const double visited = std::min(events, key_range / cells + 1);
            const double cost = products * (extra + cell_cost(bytes)) + events * 6 +
                                visited * cells * scan_cost + bytes * 0.05;
            if (cost < best.cost) best = {m, swapped, cost};
            if (key_range < cells && m > min_window_bits) break;
        }
    }
    return best;
}

/// Of packing, multiplying and unpacking integers of key·slot_bits bits (GMP 6.2 needs about 0.65·log₂²n a
/// limb). Infinite where they would not be in proportion to the operands.
inline double kronecker_cost(std::uint64_t last_a, std::uint64_t last_b, std::size_t terms,
                             std::size_t slot_bits) {
    const double slots = static_cast<double>(last_a) + static_cast<double>(last_b) + 1;
    if (slots > 8 * static_cast<double>(terms) + 1024) return std::numeric_limits<double>::infinity();
    const double limbs_a = static_cast<double>(last_a + 1) * static_cast<double>(slot_bits) / 64 + 1;
    const double limbs_b = static_cast<double>(last_b + 1) * static_cast<double>(slot_bits) / 64 + 1;
    const double logarithm = std::log2(std::min(limbs_a, limbs_b) + 1);
    return std::max(limbs_a, limbs_b) * (0.65 * logarithm * logarithm + 3) +
           slots * (8 + static_cast<double>(slot_bits) / 32) + static_cast<double>(terms) * 5 + 500;
}

/// The window for dividing a by b; the number of quotient terms is a guess between #a/#b and #a.
inline unsigned choose_division_window(const WindowCounts& a, const WindowCounts& b, std::size_t cell_bytes) {
    const auto divisor_terms = static_cast<double>(b[0]);
    const double quotient_terms = static_cast<double>(a[0]) / std::sqrt(divisor_terms) + 1;
    unsigned best = 0;
    double least = quotient_terms * divisor_terms * heap_cost(quotient_terms);
    for (unsigned m = min_window_bits; m <= max_window_bits; ++m) {
        const double cells = std::ldexp(1.0, static_cast<int>(m));
        const double bytes = cells * static_cast<double>(cell_bytes);
        const double cost =
            quotient_terms * (divisor_terms * cell_cost(bytes) + static_cast<double>(b[m]) * 6) +
            static_cast<double>(a[m]) * cells * scan_cost + bytes * 0.05;
        if (cost < least) {
            least = cost;
            best = m;
        }
    }
    return best;
}

} // namespace eliminant::algebra
