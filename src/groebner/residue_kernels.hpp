// Sums of products of residues, by the widest vector instructions at hand.
#pragma once

#include "base/vector_unit.hpp"

#include <cstddef>
#include <cstdint>

namespace eliminant::groebner {

/// The two loops in which dense linear algebra modulo a prime p < 2^31 spends its time. Get one by
/// residue_kernels().
struct ResidueKernels {
    /// Σ a[i]·b[i] as high·2^32 + low, each a plain sum of halves of products: exact for n < 2^32.
    struct Sum {
        std::uint64_t high;
        std::uint64_t low;
    };
    Sum (*dot)(const std::uint32_t* a, const std::uint32_t* b, std::size_t n);

    /// v[i] −= factor·row[i] modulo p², for v[i] in [0, p²): one correction instead of a reduction.
    void (*subtract_multiple)(std::uint64_t* v, const std::uint32_t* row, std::size_t n, std::uint32_t factor,
                              std::uint64_t p_squared);
};

/// Defined for each unit by residue_kernels_per_unit.cpp.
template <base::VectorUnit unit>
const ResidueKernels& residue_kernels_of() noexcept;

inline const ResidueKernels& residue_kernels(base::VectorUnit unit = base::best_vector_unit()) noexcept {
    return *base::with_unit(unit, [](auto u) { return &residue_kernels_of<u()>(); });
}

} // namespace eliminant::groebner
