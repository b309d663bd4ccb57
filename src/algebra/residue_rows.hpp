// Rows of residues modulo a prime, added and multiplied by the widest vector instructions at hand.
#pragma once

#include "base/vector_unit.hpp"

#include <cstddef>
#include <cstdint>

namespace eliminant::algebra {

/// A factor c for residues modulo p, with ⌊c·2^32/p⌋ beside it: c·x − ⌊x·scaled/2^32⌋·p lies in [0, 2p) for
/// every 32-bit x (V. Shoup's modular multiplication; D. Harvey, J. Symb. Comput. 60 (2014)).
struct ResidueFactor {
    std::uint32_t value = 0;
    std::uint32_t scaled = 0;

    ResidueFactor() = default;
    ResidueFactor(std::uint32_t c, std::uint32_t p)
        : value(c), scaled(static_cast<std::uint32_t>((std::uint64_t{c} << 32) / p)) {}
};

/// Loops over n residues in [0, p), p < 2^31. Rows do not overlap. Get one by residue_rows().
struct ResidueRows {
    /// x[i] += y[i].
    void (*add)(std::uint32_t* x, const std::uint32_t* y, std::size_t n, std::uint32_t p);
    /// x[i] −= y[i].
    void (*subtract)(std::uint32_t* x, const std::uint32_t* y, std::size_t n, std::uint32_t p);
    /// x[i] += factor·y[i].
    void (*add_multiple)(std::uint32_t* x, const std::uint32_t* y, std::size_t n, ResidueFactor factor,
                         std::uint32_t p);
    /// x[i] *= factor.
    void (*scale)(std::uint32_t* x, std::size_t n, ResidueFactor factor, std::uint32_t p);
    /// x[i] = s·x[i] + t·y[i] + u·y[i + 1]; y has n + 1 residues.
    void (*combine)(std::uint32_t* x, const std::uint32_t* y, std::size_t n, ResidueFactor s, ResidueFactor t,
                    ResidueFactor u, std::uint32_t p);
    /// x[i] *= y[i] for an odd p.
    void (*multiply)(std::uint32_t* x, const std::uint32_t* y, std::size_t n, std::uint32_t p);
};

/// Defined for each unit by residue_rows_per_unit.cpp.
template <base::VectorUnit unit>
const ResidueRows& residue_rows_of() noexcept;

inline const ResidueRows& residue_rows(base::VectorUnit unit = base::best_vector_unit()) noexcept {
    return *base::with_unit(unit, [](auto u) { return &residue_rows_of<u()>(); });
}

} // namespace eliminant::algebra
