/// \file
/// The kernels of lane_kernels.hpp for one kind of vector. Each source that includes it defines before, in
/// its own unnamed namespace, a type `Vector` of eight 64-bit lanes, so that nothing here is shared between
/// files that are compiled for different processors.
#pragma once

#include "groebner/lane_kernels.hpp"

namespace eliminant::groebner {
namespace {

/// x·R⁻¹ mod p, in [0, p), for x < p·R (Montgomery, Math. Comp. 44 (1985)). The low halves of x and of
/// (x·negative mod R)·p cancel, and the sum is below p² + p·R < 2^64.
inline Vector montgomery_reduce(const Vector& x, const Vector& p, const Vector& negative) {
    const Vector m = multiply_low_halves(x, negative);
    const Vector t = high_halves(add(x, multiply_low_halves(m, p)));
    return subtract_if_not_less(t, p);
}

void scatter(const LanePrimes& primes, const LaneRow& row, LaneSum* dense) {
    const Vector one = load(primes.one);
    for (std::size_t i = 0; i < row.size; ++i) {
        const Vector entry = load(row.coefficients[i]);
        store(dense[row.columns[i]], multiply_low_halves(entry, one));
    }
}

/// dense −= factor·row, without its leading entry.
inline void subtract_multiple(const Vector& factor, const Vector& square, const LaneRow& row,
                              LaneSum* dense) {
    const std::uint32_t* columns = row.columns;
    const LaneEntry* coefficients = row.coefficients;
    for (std::size_t i = 1; i < row.size; ++i) {
        LaneSum& entry = dense[columns[i]];
        const Vector product = multiply_low_halves(factor, load(coefficients[i]));
        store(entry, subtract_modulo(load(entry), product, square));
    }
}

std::size_t reduce(const LanePrimes& primes, const LaneRow* by_column, std::size_t begin, std::size_t end,
                   LaneSum* dense, std::uint32_t* columns, LaneEntry* coefficients) {
    const Vector p = load(primes.p);
    const Vector square = load(primes.square);
    const Vector negative = load(primes.negative);
    std::size_t count = 0;
    for (std::size_t c = begin; c < end; ++c) {
        const Vector sum = load(dense[c]);
        if (is_zero(sum)) continue;
        store(dense[c], zero());
        const Vector value = montgomery_reduce(sum, p, negative);
        if (is_zero(value)) continue;
        if (by_column[c].columns != nullptr) {
            subtract_multiple(value, square, by_column[c], dense);
            continue;
        }
        columns[count] = static_cast<std::uint32_t>(c);
        store(coefficients[count], value);
        ++count;
    }
    return count;
}

void scale(const LanePrimes& primes, const LaneEntry& factor, std::size_t size, LaneEntry* coefficients) {
    const Vector p = load(primes.p);
    const Vector negative = load(primes.negative);
    const Vector by = load(factor);
    for (std::size_t i = 0; i < size; ++i)
        store(coefficients[i],
              montgomery_reduce(multiply_low_halves(load(coefficients[i]), by), p, negative));
}

constexpr LaneKernels kernels{scatter, reduce, scale};

} // namespace
} // namespace eliminant::groebner
