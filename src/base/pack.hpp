/// \file
/// Vector registers as types, for the sources that are compiled once for each vector unit, x_per_unit.cpp.
///
/// Such a compilation is given ELIMINANT_PACK, the header of its unit: pack_portable.hpp, pack_avx2.hpp, ….
/// Each of these defines, in an unnamed namespace, so that nothing compiled for one processor is shared with
/// sources compiled for another,
///
///     this_unit   the VectorUnit
///     Doubles     lanes of doubles, and Doubles::Mask: arithmetic, fma, comparison, selection
///     Floats      lanes of floats: arithmetic and fma
///     Words       lanes of unsigned 64 bits
///     Halves      as many lanes of unsigned 32 bits; their products are Words
///
/// pack_portable.hpp says in plain C++ what each operation means. A new unit costs such a header, an
/// enumerator of VectorUnit and a line of CMakeLists.txt.
#pragma once

#include "base/vector_unit.hpp"

#include ELIMINANT_PACK

#include <cstddef>

namespace eliminant::base {
namespace {

/// Two packs of Words or of Halves as one.
template <class Pack>
struct Twice {
    using Lane = typename Pack::Lane;
    static constexpr std::size_t lanes = 2 * Pack::lanes;
    Pack low;
    Pack high;

    static Twice all(Lane x) { return {Pack::all(x), Pack::all(x)}; }
    static Twice load(const Lane* p) { return {Pack::load(p), Pack::load(p + Pack::lanes)}; }
    void store(Lane* p) const {
        low.store(p);
        high.store(p + Pack::lanes);
    }

    friend Twice operator+(Twice a, Twice b) { return {a.low + b.low, a.high + b.high}; }
    friend Twice operator-(Twice a, Twice b) { return {a.low - b.low, a.high - b.high}; }
    friend Twice operator>>(Twice a, Twice bits) { return {a.low >> bits.low, a.high >> bits.high}; }
    friend Twice subtract_if_not_less(Twice a, Twice b) {
        return {subtract_if_not_less(a.low, b.low), subtract_if_not_less(a.high, b.high)};
    }
    friend Twice subtract_modulo(Twice a, Twice b, Twice m) {
        return {subtract_modulo(a.low, b.low, m.low), subtract_modulo(a.high, b.high, m.high)};
    }
    friend unsigned nonzero_lanes(Twice a) {
        return nonzero_lanes(a.low) | nonzero_lanes(a.high) << Pack::lanes;
    }
};

template <class Pack>
Twice(Pack, Pack) -> Twice<Pack>;

template <class Pack>
auto halves(Twice<Pack> a) {
    return Twice{halves(a.low), halves(a.high)};
}
template <class Pack>
auto upper_halves(Twice<Pack> a) {
    return Twice{upper_halves(a.low), upper_halves(a.high)};
}
template <class Pack>
auto words(Twice<Pack> a) {
    return Twice{words(a.low), words(a.high)};
}
template <class Pack>
auto operator*(Twice<Pack> a, Twice<Pack> b) {
    return Twice{a.low * b.low, a.high * b.high};
}

/// A pack doubled until it has eight lanes.
template <class Pack>
struct Octet {
    using type = typename Octet<Twice<Pack>>::type;
};
template <class Pack>
requires(Pack::lanes == 8) struct Octet<Pack> {
    using type = Pack;
};
using EightWords = Octet<Words>::type;
using EightHalves = Octet<Halves>::type;

} // namespace
} // namespace eliminant::base
