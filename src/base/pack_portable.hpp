/// \file
/// Packs in plain C++ (pack.hpp): what the operations mean, and what the other units are tested against.
#pragma once

#include "base/vector_unit.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace eliminant::base {
namespace {

inline constexpr VectorUnit this_unit = VectorUnit::portable;

/// One number.
template <class Number>
struct Single {
    struct Mask {
        bool bit;
        friend Mask operator&(Mask a, Mask b) { return {a.bit && b.bit}; }
        friend Mask operator|(Mask a, Mask b) { return {a.bit || b.bit}; }
        friend Mask operator~(Mask a) { return {!a.bit}; }
        friend bool any(Mask a) { return a.bit; }
    };
    static constexpr std::size_t lanes = 1;
    Number v;

    static Single all(Number x) { return {x}; }
    static Single load(const Number* p) { return {*p}; }
    static Mask nowhere() { return {false}; }
    static bool test(Mask mask, std::size_t /*lane*/) { return mask.bit; }
    /// Where the signs differ, those of zeros included.
    static Mask opposite(Single a, Single b) { return {std::signbit(a.v) != std::signbit(b.v)}; }
    void store(Number* p) const { *p = v; }
    Number lane(std::size_t /*i*/) const { return v; }

    friend Single operator+(Single a, Single b) { return {a.v + b.v}; }
    friend Single operator-(Single a, Single b) { return {a.v - b.v}; }
    friend Single operator*(Single a, Single b) { return {a.v * b.v}; }
    friend Single operator/(Single a, Single b) { return {a.v / b.v}; }
    friend Mask operator>(Single a, Single b) { return {a.v > b.v}; }
    friend Mask operator==(Single a, Single b) { return {a.v == b.v}; }
    /// a·b + c, rounded once where the processor does that, else twice.
    friend Single fma(Single a, Single b, Single c) { return {a.v * b.v + c.v}; }
    /// Rounded once, at whatever cost.
    friend Single fused(Single a, Single b, Single c) { return {std::fma(a.v, b.v, c.v)}; }
    /// The second where one of them is not a number; so is min.
    friend Single max(Single a, Single b) { return {a.v > b.v ? a.v : b.v}; }
    friend Single min(Single a, Single b) { return {a.v < b.v ? a.v : b.v}; }
    friend Single sqrt(Single a) { return {std::sqrt(a.v)}; }
    friend Single abs(Single a) { return {std::fabs(a.v)}; }
    friend Single select(Mask mask, Single a, Single b) { return mask.bit ? a : b; }
};

using Doubles = Single<double>;
using Floats = Single<float>;

// Words and halves are eight, in loops of which compilers make vector code of the base architecture.

template <class Pack, class F>
inline Pack per_lane(const F& f) {
    Pack result;
    for (std::size_t i = 0; i < Pack::lanes; ++i) result.lane[i] = f(i);
    return result;
}

struct Halves {
    using Lane = std::uint32_t;
    static constexpr std::size_t lanes = 8;
    std::uint32_t lane[lanes];

    static Halves all(std::uint32_t x) {
        return per_lane<Halves>([&](std::size_t) { return x; });
    }
    static Halves load(const std::uint32_t* p) {
        return per_lane<Halves>([&](std::size_t i) { return p[i]; });
    }
    void store(std::uint32_t* p) const {
        for (std::size_t i = 0; i < lanes; ++i) p[i] = lane[i];
    }

    friend Halves operator+(const Halves& a, const Halves& b) {
        return per_lane<Halves>([&](std::size_t i) { return a.lane[i] + b.lane[i]; });
    }
    /// a < b ? a : a − b.
    friend Halves subtract_if_not_less(const Halves& a, const Halves& b) {
        return per_lane<Halves>(
            [&](std::size_t i) { return a.lane[i] - (a.lane[i] < b.lane[i] ? 0 : b.lane[i]); });
    }
};

struct Words {
    using Lane = std::uint64_t;
    static constexpr std::size_t lanes = Halves::lanes;
    std::uint64_t lane[lanes];

    static Words all(std::uint64_t x) {
        return per_lane<Words>([&](std::size_t) { return x; });
    }
    static Words load(const std::uint64_t* p) {
        return per_lane<Words>([&](std::size_t i) { return p[i]; });
    }
    void store(std::uint64_t* p) const {
        for (std::size_t i = 0; i < lanes; ++i) p[i] = lane[i];
    }

    friend Words operator+(const Words& a, const Words& b) {
        return per_lane<Words>([&](std::size_t i) { return a.lane[i] + b.lane[i]; });
    }
    friend Words operator-(const Words& a, const Words& b) {
        return per_lane<Words>([&](std::size_t i) { return a.lane[i] - b.lane[i]; });
    }
    friend Words operator>>(const Words& a, const Words& bits) {
        return per_lane<Words>([&](std::size_t i) { return a.lane[i] >> bits.lane[i]; });
    }
    /// Modulo 2^32.
    friend Halves halves(const Words& a) {
        return per_lane<Halves>([&](std::size_t i) { return static_cast<std::uint32_t>(a.lane[i]); });
    }
    /// ⌊a/2^32⌋.
    friend Halves upper_halves(const Words& a) {
        return per_lane<Halves>([&](std::size_t i) { return static_cast<std::uint32_t>(a.lane[i] >> 32); });
    }
    /// a < b ? a : a − b for a, b < 2^63.
    friend Words subtract_if_not_less(const Words& a, const Words& b) {
        return per_lane<Words>(
            [&](std::size_t i) { return a.lane[i] - (a.lane[i] < b.lane[i] ? 0 : b.lane[i]); });
    }
    /// a − b modulo m for a, b < m < 2^63: all ones where the difference is negative select m.
    friend Words subtract_modulo(const Words& a, const Words& b, const Words& m) {
        return per_lane<Words>([&](std::size_t i) {
            const std::uint64_t difference = a.lane[i] - b.lane[i];
            return difference + (m.lane[i] & (std::uint64_t{0} - (difference >> 63)));
        });
    }
    /// One bit a lane.
    friend unsigned nonzero_lanes(const Words& a) {
        unsigned bits = 0;
        for (std::size_t i = 0; i < lanes; ++i) bits |= (a.lane[i] != 0 ? 1U : 0U) << i;
        return bits;
    }
};

inline Words words(const Halves& a) {
    return per_lane<Words>([&](std::size_t i) { return std::uint64_t{a.lane[i]}; });
}
inline Words operator*(const Halves& a, const Halves& b) {
    return per_lane<Words>([&](std::size_t i) { return std::uint64_t{a.lane[i]} * b.lane[i]; });
}

} // namespace
} // namespace eliminant::base
