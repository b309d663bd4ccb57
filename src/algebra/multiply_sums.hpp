#pragma once

#include "eliminant/algebra/integer.hpp"
#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/wide.hpp"

#include "word_remainders.hpp"

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace eliminant::algebra {

/// \file
/// Accumulators for sums of products, one type per width. The kernels are compiled for each:
///
///     Operand     factor as the kernel reads it        Element    coefficient of the result
///     Cell        the sum; a new one is 0              polls      whether one product is worth a poll
///
/// The caller bounds the sums beforehand, so no cell ever overflows.

/// GF(p). A sum stays below M, the largest multiple of p up to 2^63: since a product is below 2^62, one
/// conditional subtraction restores that, and no division is needed before the end.
struct ResidueSums {
    using Element = PrimeField::Element;
    using Operand = std::uint32_t;
    using Cell = std::uint64_t;
    static constexpr bool polls = false;

    PrimeField field;
    std::uint64_t multiple;

    explicit ResidueSums(const PrimeField& f)
        : field(f), multiple((std::uint64_t{1} << 63) / f.characteristic() * f.characteristic()) {}

    void add(Cell& sum, Operand a, Operand b) const {
        const std::uint64_t raised = sum + static_cast<std::uint64_t>(a) * b;
        sum = std::min(raised, raised - multiple);
    }
    void add_value(Cell& sum, Element value) const { add(sum, value, 1); }
    /// Room for sums of so many bits, which are never negative.
    static std::size_t slot_bits(std::size_t bits) { return bits + 1; }
    Element from_slot(base::Int128 sum) const { return reduced(static_cast<base::UInt128>(sum), field); }
    Operand negative(Element value) const { return field.negate(value); }
    /// The value; the cell is 0 afterwards.
    Element take(Cell& sum) const { return field.reduce(std::exchange(sum, 0)); }
    static bool is_zero(Element value) { return value == 0; }
    static bool is_empty(Cell sum) { return sum == 0; }
};

/// An integer below 2^127 in size.
base::Int128 wide_value(const Integer& value);

/// What the accumulators of integers have in common.
struct IntegerSlots {
    using Element = Integer;
    /// Room for values of so many bits and their sign.
    static std::size_t slot_bits(std::size_t bits) { return bits + 1; }
    static Integer from_slot(base::Int128 sum) { return Integer::from_wide(sum); }
    static bool is_zero(const Integer& value) { return value.is_zero(); }
};

/// Sums below 2^63 (Sum = std::int64_t) or 2^127 (Sum = Int128) of products of word-size integers.
template <class Sum>
struct WordSums : IntegerSlots {
    using Operand = std::int64_t;
    using Cell = Sum;
    static constexpr bool polls = false;
    static constexpr std::size_t capacity = 8 * sizeof(Sum) - 1; ///< bits of the largest sum

    static void add(Cell& sum, Operand a, Operand b) { sum += static_cast<Sum>(a) * b; }
    static void add_value(Cell& sum, const Integer& value) { sum += static_cast<Sum>(wide_value(value)); }
    static Operand negative(const Integer& value) { return -value.small_value(); }
    static Integer take(Cell& sum) { return Integer::from_wide(std::exchange(sum, 0)); }
    static bool is_empty(Cell sum) { return sum == 0; }
};

/// Sums below 2^191 of products of word-size integers: two's complement, least significant limb first.
struct TripleCell {
    std::uint64_t low = 0;
    std::uint64_t middle = 0;
    std::uint64_t high = 0;
    void add(base::Int128 value) {
        const auto bits = static_cast<base::UInt128>(value);
        const auto lower = static_cast<base::UInt128>(middle) << 64 | low;
        const base::UInt128 sum = lower + bits;
        high += static_cast<std::uint64_t>(value >> 127) + (sum < bits ? 1 : 0);
        low = static_cast<std::uint64_t>(sum);
        middle = static_cast<std::uint64_t>(sum >> 64);
    }
};

struct TripleSums : IntegerSlots {
    using Operand = std::int64_t;
    using Cell = TripleCell;
    static constexpr bool polls = false;
    static constexpr std::size_t capacity = 191;

    static void add(Cell& sum, Operand a, Operand b) { sum.add(static_cast<base::Int128>(a) * b); }
    static void add_value(Cell& sum, const Integer& value);
    static Operand negative(const Integer& value) { return -value.small_value(); }
    static Integer take(Cell& sum);
    static bool is_empty(const Cell& sum) { return (sum.low | sum.middle | sum.high) == 0; }
};

/// Sums of any size.
struct IntegerSums : IntegerSlots {
    using Operand = Integer;
    using Cell = Integer;
    static constexpr bool polls = true;
    static constexpr std::size_t capacity = std::numeric_limits<std::size_t>::max();

    static void add(Cell& sum, const Integer& a, const Integer& b) { sum.add_product(a, b); }
    static void add_value(Cell& sum, const Integer& value) { sum += value; }
    static Integer negative(const Integer& value) { return -value; }
    static Integer take(Cell& sum) { return std::exchange(sum, Integer()); }
    static bool is_empty(const Cell& sum) { return sum.is_zero(); }
};

/// What bounds the coefficients of a product.
struct CoefficientSize {
    bool all_small = true;    ///< every coefficient is inline in its Integer
    std::size_t max_bits = 0; ///< of the largest coefficient
    std::size_t sum_bits = 0; ///< of the sum of all absolute values, or a bound
};
CoefficientSize coefficient_size(std::span<const Integer> coefficients);

/// Bits that hold every sum of products in a·b: |Σ aᵢbⱼ| ≤ min(‖a‖₁·‖b‖∞, ‖a‖∞·‖b‖₁).
inline std::size_t product_bits(const CoefficientSize& a, const CoefficientSize& b) {
    return std::min(a.sum_bits + b.max_bits, a.max_bits + b.sum_bits);
}

std::vector<std::int64_t> small_values(std::span<const Integer> coefficients);

/// The coefficients of an operand as the kernels read them, without a copy where they are that already.
template <class Sums>
class OperandValues {
  public:
    using Operand = typename Sums::Operand;
    static constexpr bool copies = !std::same_as<Operand, typename Sums::Element>;

    explicit OperandValues(const std::vector<typename Sums::Element>& coefficients) {
        if constexpr (copies) {
            storage_ = small_values(coefficients);
            values_ = storage_;
        } else {
            values_ = coefficients;
        }
    }
    OperandValues(const OperandValues&) = delete;
    OperandValues& operator=(const OperandValues&) = delete;
    // NOLINTNEXTLINE(google-explicit-constructor): a view
    operator std::span<const Operand>() const { return values_; }

  private:
    std::vector<Operand> storage_;
    std::span<const Operand> values_;
};

} // namespace eliminant::algebra
