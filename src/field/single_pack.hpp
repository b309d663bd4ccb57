#pragma once

#include <cmath>
#include <cstddef>

namespace eliminant::field {

/// One double as a Pack (first_root_kernel.hpp).
struct SinglePack {
    struct Mask {
        bool bit;
        friend Mask operator&(Mask a, Mask b) { return {a.bit && b.bit}; }
        friend Mask operator|(Mask a, Mask b) { return {a.bit || b.bit}; }
        friend Mask operator~(Mask a) { return {!a.bit}; }
        friend bool any(Mask a) { return a.bit; }
    };
    static constexpr std::size_t lanes = 1;
    static constexpr int most_pieces = 48;
    static constexpr double shortest_piece = 0x1p-22;
    double v;

    static SinglePack all(double x) { return {x}; }
    static SinglePack load(const double* p) { return {*p}; }
    static Mask nowhere() { return {false}; }
    static bool test(Mask mask, std::size_t /*lane*/) { return mask.bit; }
    static Mask opposite(SinglePack a, SinglePack b) { return {std::signbit(a.v) != std::signbit(b.v)}; }
    void store(double* p) const { *p = v; }
    double lane(std::size_t /*i*/) const { return v; }

    friend SinglePack operator+(SinglePack a, SinglePack b) { return {a.v + b.v}; }
    friend SinglePack operator-(SinglePack a, SinglePack b) { return {a.v - b.v}; }
    friend SinglePack operator*(SinglePack a, SinglePack b) { return {a.v * b.v}; }
    friend SinglePack operator/(SinglePack a, SinglePack b) { return {a.v / b.v}; }
    friend Mask operator>(SinglePack a, SinglePack b) { return {a.v > b.v}; }
    friend Mask operator==(SinglePack a, SinglePack b) { return {a.v == b.v}; }
    friend SinglePack fma(SinglePack a, SinglePack b, SinglePack c) { return {a.v * b.v + c.v}; }
    /// Rounded once, which fma() need not be.
    friend SinglePack fused(SinglePack a, SinglePack b, SinglePack c) { return {std::fma(a.v, b.v, c.v)}; }
    friend SinglePack max(SinglePack a, SinglePack b) { return {a.v > b.v ? a.v : b.v}; }
    friend SinglePack sqrt(SinglePack a) { return {std::sqrt(a.v)}; }
    friend SinglePack min(SinglePack a, SinglePack b) { return {a.v < b.v ? a.v : b.v}; }
    friend SinglePack abs(SinglePack a) { return {std::fabs(a.v)}; }
    friend SinglePack select(Mask mask, SinglePack a, SinglePack b) { return mask.bit ? a : b; }
};

} // namespace eliminant::field
