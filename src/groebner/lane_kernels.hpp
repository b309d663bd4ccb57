/// \file
/// Sparse elimination in eight lanes: one row modulo eight primes, or eight rows modulo one prime.
///
/// The same matrix modulo several primes has the same columns, and the rows of one matrix of F4 are reduced
/// by much the same pivots. What costs most in the elimination of one sparse row (reading columns, scattered
/// loads and stores) is therefore paid once for eight: an entry is eight neighbouring numbers, and every
/// operation on it is one on vectors.
///
///     entry   | lane 0 | … | lane 7 |      32 bits each, residues
///     dense   | column 0: eight lanes of 64 bits | column 1 | …      a row during elimination, sums below p²
///
/// Plain arrays and no standard library: sources compiled for one processor may share no inline function with
/// others.
#pragma once

#include "base/vector_unit.hpp"

#include <cstddef>
#include <cstdint>

namespace eliminant::groebner {

inline constexpr std::size_t lane_count = 8;

/// A coefficient in each lane.
struct alignas(32) LaneEntry {
    std::uint32_t lane[lane_count];
};
/// A column of a dense row in each lane.
struct alignas(64) LaneSum {
    std::uint64_t lane[lane_count];
};

/// Eight primes below 2^31, not necessarily different, and what Barrett's reduction needs for each.
struct LanePrimes {
    explicit LanePrimes(const LaneEntry& primes);

    LaneSum p;
    LaneSum square; ///< p²
    // With k the number of bits of p:
    LaneSum reciprocal; ///< ⌊2^(2k)/p⌋ < 2^32
    LaneSum low_shift;  ///< k − 1
    LaneSum high_shift; ///< k + 1
};

/// A row by which others are reduced: columns ascending, the leading coefficient is 1. Coefficients are one
/// for all lanes (std::uint32_t) or one for each (LaneEntry).
template <class Coefficient>
struct SparseRow {
    const std::uint32_t* columns = nullptr; ///< null where there is none
    const Coefficient* coefficients = nullptr;
    std::size_t size = 0;
};

/// Eliminates the columns begin ≤ c < end of `dense`, in ascending sequence, by the rows by_column[c]. The
/// nonzero entries of those columns that have no row are appended to `columns` and `entries`; all become 0.
/// Returns how many were appended. With `used` not null, used[c] is raised by the bits of the lanes in which
/// a multiple of by_column[c] was subtracted.
template <class Coefficient>
using LaneReduction = std::size_t (*)(const LanePrimes& primes, const SparseRow<Coefficient>* by_column,
                                      std::size_t begin, std::size_t end, LaneSum* dense,
                                      std::uint32_t* columns, LaneEntry* entries, std::uint8_t* used);

/// The kernels, one set for each vector unit; all compute the same.
struct LaneKernels {
    LaneReduction<std::uint32_t> reduce_rows; ///< eight rows by the same ones
    LaneReduction<LaneEntry> reduce_primes;   ///< one row modulo eight primes

    /// dense −= factor · row, lane by lane, the leading entry included.
    void (*subtract_row)(const LanePrimes& primes, const LaneEntry& factor,
                         const SparseRow<std::uint32_t>& row, LaneSum* dense);
    /// entries[i] *= factor, lane by lane.
    void (*scale)(const LanePrimes& primes, const LaneEntry& factor, std::size_t size, LaneEntry* entries);
    /// entries[i] −= factor · entries[i].lane[lane], lane by lane: subtracts multiples of one lane from the
    /// others. factor.lane[lane] is 0.
    void (*subtract_lane)(const LanePrimes& primes, const LaneEntry& factor, std::size_t lane,
                          std::size_t size, LaneEntry* entries);
    /// Of `count` numbers, given by their digits one after the other, number i by lengths[i] digits below the
    /// primes, the lowest first: result[i] = −Σ digit·power, lane by lane, digit j with powers[j].
    void (*sum_digits)(const LanePrimes& primes, const LaneEntry* powers, const std::uint32_t* digits,
                       const std::uint32_t* lengths, std::size_t count, LaneEntry* result);
};

/// Defined for each unit by lane_kernels_per_unit.cpp.
template <base::VectorUnit unit>
const LaneKernels& lane_kernels_of() noexcept;

inline const LaneKernels& lane_kernels(base::VectorUnit unit) noexcept {
    return *base::with_unit(unit, [](auto u) { return &lane_kernels_of<u()>(); });
}

} // namespace eliminant::groebner
