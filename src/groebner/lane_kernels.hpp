/// \file
/// Sparse elimination modulo eight primes at once, one in each lane.
///
/// The same matrix modulo several primes has the same columns, so what costs most in the elimination of one
/// sparse row (reading columns, scattered loads and stores) is paid once for eight: an entry is eight
/// neighbouring numbers, and every operation on it is one on vectors.
///
///     coefficients   | c₀ mod p₀ … p₇ | c₁ mod p₀ … p₇ | …      32 bits each, Montgomery form, below p
///     dense          | column 0: eight lanes of 64 bits | …      a row during elimination, entries below p²
///
/// Plain arrays and no standard library: sources compiled for one processor may share no inline function with
/// others.
#pragma once

#include "base/vector_unit.hpp"

#include <cstddef>
#include <cstdint>

namespace eliminant::groebner {

inline constexpr std::size_t lane_count = 8;

/// A coefficient.
struct alignas(32) LaneEntry {
    std::uint32_t lane[lane_count];
};
/// A column of a dense row.
struct alignas(64) LaneSum {
    std::uint64_t lane[lane_count];
};

/// Eight odd primes below 2^31, and what Montgomery reduction with R = 2^32 needs for each.
struct LanePrimes {
    explicit LanePrimes(const LaneEntry& primes);

    LaneSum p;
    LaneSum square;   ///< p²
    LaneSum negative; ///< −1/p mod R
    LaneSum one;      ///< R mod p: 1 in Montgomery form
    LaneEntry into;   ///< R² mod p: times it takes a residue into the form
};

/// A sparse row by which others are reduced: monic, columns ascending.
struct LaneRow {
    const std::uint32_t* columns = nullptr; ///< null where there is none
    const LaneEntry* coefficients = nullptr;
    std::size_t size = 0;
};

/// The kernels, one set for each vector unit; all compute the same.
struct LaneKernels {
    /// Puts a row into `dense`, which is zero at its columns.
    void (*scatter)(const LanePrimes& primes, const LaneRow& row, LaneSum* dense);

    /// Eliminates the columns begin ≤ c < end of `dense`, in ascending sequence, by the rows by_column[c].
    /// The nonzero entries of those that have no row are appended to `columns` and `coefficients`, and all
    /// become 0. Returns how many were appended.
    std::size_t (*reduce)(const LanePrimes& primes, const LaneRow* by_column, std::size_t begin,
                          std::size_t end, LaneSum* dense, std::uint32_t* columns, LaneEntry* coefficients);

    /// Multiplies `size` entries by one: both in Montgomery form gives Montgomery form.
    void (*scale)(const LanePrimes& primes, const LaneEntry& factor, std::size_t size,
                  LaneEntry* coefficients);
};

/// The kernels for a vector unit that this machine has; the portable ones where there are none of its own.
const LaneKernels& lane_kernels(base::VectorUnit unit);

} // namespace eliminant::groebner
