/// \file
/// The kernels of lane_kernels.hpp for one kind of vector. Each source that includes it defines before, in
/// its own unnamed namespace, a type `Vector` of eight 64-bit lanes, so that nothing here is shared between
/// files that are compiled for different processors.
#pragma once

#include "groebner/lane_kernels.hpp"

namespace eliminant::groebner {
namespace {

struct Primes {
    Vector p;
    Vector square;
    Vector reciprocal;
    Vector low_shift;
    Vector high_shift;

    explicit Primes(const LanePrimes& primes)
        : p(load(primes.p)), square(load(primes.square)), reciprocal(load(primes.reciprocal)),
          low_shift(load(primes.low_shift)), high_shift(load(primes.high_shift)) {}

    /// x mod p for x < p² (Barrett 1986). All factors are below 2^32, and the quotient found is at most two
    /// too small.
    Vector reduce(const Vector& x) const {
        const Vector quotient =
            shift_down(multiply_low_halves(shift_down(x, low_shift), reciprocal), high_shift);
        const Vector rest = subtract(x, multiply_low_halves(quotient, p));
        return subtract_if_not_less(subtract_if_not_less(rest, p), p);
    }
};

/// dense −= factor·row, from entry `first` of the row on.
template <class Coefficient>
inline void subtract_multiple(const Vector& factor, const Vector& square, const SparseRow<Coefficient>& row,
                              std::size_t first, LaneSum* dense) {
    const std::uint32_t* columns = row.columns;
    const Coefficient* coefficients = row.coefficients;
    for (std::size_t i = first; i < row.size; ++i) {
        LaneSum& entry = dense[columns[i]];
        const Vector product = multiply_low_halves(factor, load(coefficients[i]));
        store(entry, subtract_modulo(load(entry), product, square));
    }
}

template <class Coefficient>
std::size_t reduce(const LanePrimes& lane_primes, const SparseRow<Coefficient>* by_column, std::size_t begin,
                   std::size_t end, LaneSum* dense, std::uint32_t* columns, LaneEntry* entries,
                   std::uint8_t* used) {
    const Primes primes(lane_primes);
    std::size_t count = 0;
    for (std::size_t c = begin; c < end; ++c) {
        const Vector sum = load(dense[c]);
        if (nonzero_lanes(sum) == 0) continue;
        store(dense[c], zero());
        const Vector value = primes.reduce(sum);
        const unsigned lanes = nonzero_lanes(value);
        if (lanes == 0) continue;
        if (by_column[c].columns != nullptr) {
            if (used != nullptr) used[c] = static_cast<std::uint8_t>(used[c] | lanes);
            subtract_multiple(value, primes.square, by_column[c], 1, dense); // entry c is 0 already
            continue;
        }
        columns[count] = static_cast<std::uint32_t>(c);
        store(entries[count], value);
        ++count;
    }
    return count;
}

inline void subtract_row(const LanePrimes& lane_primes, const LaneEntry& factor,
                         const SparseRow<std::uint32_t>& row, LaneSum* dense) {
    subtract_multiple(load(factor), load(lane_primes.square), row, 0, dense);
}

inline void scale(const LanePrimes& lane_primes, const LaneEntry& factor, std::size_t size,
                  LaneEntry* entries) {
    const Primes primes(lane_primes);
    const Vector by = load(factor);
    for (std::size_t i = 0; i < size; ++i)
        store(entries[i], primes.reduce(multiply_low_halves(load(entries[i]), by)));
}

inline void subtract_lane(const LanePrimes& lane_primes, const LaneEntry& factor, std::size_t lane,
                          std::size_t size, LaneEntry* entries) {
    const Primes primes(lane_primes);
    const Vector by = load(factor);
    for (std::size_t i = 0; i < size; ++i) {
        const std::uint32_t subtracted = entries[i].lane[lane];
        if (subtracted == 0) continue;
        const Vector product = multiply_low_halves(by, load(subtracted));
        store(entries[i], primes.reduce(subtract_modulo(load(entries[i]), product, primes.square)));
    }
}

inline void sum_digits(const LanePrimes& lane_primes, const LaneEntry* powers, const std::uint32_t* digits,
                       const std::uint32_t* lengths, std::size_t count, LaneEntry* result) {
    const Primes primes(lane_primes);
    for (std::size_t i = 0; i < count; ++i) {
        Vector sum = zero();
        for (std::uint32_t j = 0; j < lengths[i]; ++j) {
            const Vector product = multiply_low_halves(load(powers[j]), load(digits[j]));
            sum = subtract_modulo(sum, product, primes.square);
        }
        store(result[i], primes.reduce(sum));
        digits += lengths[i];
    }
}

inline constexpr LaneKernels kernels{reduce<std::uint32_t>, reduce<LaneEntry>, subtract_row, scale,
                                     subtract_lane,         sum_digits};

} // namespace
} // namespace eliminant::groebner
