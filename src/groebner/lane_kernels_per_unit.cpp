#include "groebner/lane_kernels.hpp"

#include "base/pack.hpp"

namespace eliminant::groebner {
namespace {

static_assert(lane_count == base::EightWords::lanes);
using Words = base::EightWords;
using Halves = base::EightHalves;

inline Words load(const LaneSum& x) { return Words::load(x.lane); }
inline Halves load(const LaneEntry& x) { return Halves::load(x.lane); }
inline Halves load(const std::uint32_t& x) { return Halves::all(x); }

struct Primes {
    Words p;
    Words square;
    Words reciprocal;
    Words low_shift;
    Words high_shift;

    explicit Primes(const LanePrimes& primes)
        : p(load(primes.p)), square(load(primes.square)), reciprocal(load(primes.reciprocal)),
          low_shift(load(primes.low_shift)), high_shift(load(primes.high_shift)) {}

    /// x mod p for x < p² (Barrett 1986). All factors are below 2^32, and the quotient found is at most two
    /// too small.
    Words reduce(const Words& x) const {
        const Words quotient = (halves(x >> low_shift) * halves(reciprocal)) >> high_shift;
        const Words rest = x - halves(quotient) * halves(p);
        return subtract_if_not_less(subtract_if_not_less(rest, p), p);
    }
};

/// dense −= factor·row, from entry `first` of the row on.
template <class Coefficient>
inline void subtract_multiple(const Halves& factor, const Words& square, const SparseRow<Coefficient>& row,
                              std::size_t first, LaneSum* dense) {
    const std::uint32_t* columns = row.columns;
    const Coefficient* coefficients = row.coefficients;
    for (std::size_t i = first; i < row.size; ++i) {
        LaneSum& entry = dense[columns[i]];
        subtract_modulo(load(entry), factor * load(coefficients[i]), square).store(entry.lane);
    }
}

template <class Coefficient>
std::size_t reduce(const LanePrimes& lane_primes, const SparseRow<Coefficient>* by_column, std::size_t begin,
                   std::size_t end, LaneSum* dense, std::uint32_t* columns, LaneEntry* entries,
                   std::uint8_t* used) {
    const Primes primes(lane_primes);
    const Words zero = Words::all(0);
    std::size_t count = 0;
    for (std::size_t c = begin; c < end; ++c) {
        const Words sum = load(dense[c]);
        if (nonzero_lanes(sum) == 0) continue;
        zero.store(dense[c].lane);
        const Words value = primes.reduce(sum);
        const unsigned lanes = nonzero_lanes(value);
        if (lanes == 0) continue;
        if (by_column[c].columns != nullptr) {
            if (used != nullptr) used[c] = static_cast<std::uint8_t>(used[c] | lanes);
            subtract_multiple(halves(value), primes.square, by_column[c], 1, dense); // entry c is 0 already
            continue;
        }
        columns[count] = static_cast<std::uint32_t>(c);
        halves(value).store(entries[count].lane);
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
    const Halves by = load(factor);
    for (std::size_t i = 0; i < size; ++i)
        halves(primes.reduce(load(entries[i]) * by)).store(entries[i].lane);
}

inline void subtract_lane(const LanePrimes& lane_primes, const LaneEntry& factor, std::size_t lane,
                          std::size_t size, LaneEntry* entries) {
    const Primes primes(lane_primes);
    const Halves by = load(factor);
    for (std::size_t i = 0; i < size; ++i) {
        const std::uint32_t subtracted = entries[i].lane[lane];
        if (subtracted == 0) continue;
        const Words rest = subtract_modulo(words(load(entries[i])), by * load(subtracted), primes.square);
        halves(primes.reduce(rest)).store(entries[i].lane);
    }
}

inline void sum_digits(const LanePrimes& lane_primes, const LaneEntry* powers, const std::uint32_t* digits,
                       const std::uint32_t* lengths, std::size_t count, LaneEntry* result) {
    const Primes primes(lane_primes);
    for (std::size_t i = 0; i < count; ++i) {
        Words sum = Words::all(0);
        for (std::uint32_t j = 0; j < lengths[i]; ++j)
            sum = subtract_modulo(sum, load(powers[j]) * load(digits[j]), primes.square);
        halves(primes.reduce(sum)).store(result[i].lane);
        digits += lengths[i];
    }
}

} // namespace

template <base::VectorUnit unit>
const LaneKernels& lane_kernels_of() noexcept {
    static constexpr LaneKernels kernels{reduce<std::uint32_t>, reduce<LaneEntry>, subtract_row, scale,
                                         subtract_lane,         sum_digits};
    return kernels;
}

template const LaneKernels& lane_kernels_of<base::this_unit>() noexcept;

} // namespace eliminant::groebner
