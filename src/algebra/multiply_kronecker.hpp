#pragma once

#include "eliminant/algebra/integer.hpp"
#include "eliminant/base/run.hpp"

#include "multiply_kernels.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace eliminant::algebra {

/// A polynomial in one variable evaluated at 2^slot_bits, and back.
///
///     Σ cₖ·2^(k·slot_bits) with |cₖ| < 2^(slot_bits − 1)
///
/// Coefficients are read off in any sequence: what the slots below slot k borrow from it is the bit just
/// under it, for their sum is less than half of 2^(k·slot_bits) in size, so modulo that it has its top bit
/// set iff negative.
class SlotInteger {
  public:
    SlotInteger(mpz_class value, std::size_t slot_bits) : value_(std::move(value)), slot_bits_(slot_bits) {}
    /// For factors of a product whose coefficients fit in slot_bits.
    static SlotInteger pack(std::span<const std::uint64_t> keys, std::span<const std::uint32_t> coefficients,
                            std::size_t slot_bits);
    static SlotInteger pack(std::span<const std::uint64_t> keys, std::span<const std::int64_t> coefficients,
                            std::size_t slot_bits);
    static SlotInteger pack(std::span<const std::uint64_t> keys, std::span<const Integer> coefficients,
                            std::size_t slot_bits);

    friend SlotInteger operator*(const SlotInteger& a, const SlotInteger& b) {
        return {a.value_ * b.value_, a.slot_bits_};
    }
    /// *this / divisor, which is not 0; nullopt if that is no integer.
    std::optional<SlotInteger> exact_quotient(const SlotInteger& divisor) const;
    /// The coefficient cₖ; requires slot_bits < 128.
    base::Int128 word(std::uint64_t k) const;
    /// The coefficient cₖ for slots of any size.
    Integer integer(std::uint64_t k) const;

  private:
    mpz_class value_;
    std::size_t slot_bits_;
};

/// Emits the terms of a·b, largest first, by one multiplication of integers (L. Kronecker 1882; for
/// polynomials on computers A. Schönhage 1982). Keys are below 2^64/slot_bits. GMP's multiplication cannot be
/// interrupted.
template <class Sums, class Emit>
void multiply_by_kronecker(const KeyedTerms<std::uint64_t, typename Sums::Operand>& a,
                           const KeyedTerms<std::uint64_t, typename Sums::Operand>& b, std::size_t slot_bits,
                           const Sums& sums, base::Run& run, Emit&& emit) {
    run.poll();
    const SlotInteger product = SlotInteger::pack(a.keys, a.coefficients, slot_bits) *
                                SlotInteger::pack(b.keys, b.coefficients, slot_bits);
    for (std::uint64_t key = a.keys[0] + b.keys[0] + 1; key-- > 0;) {
        if (key % 1024 == 0) run.poll();
        typename Sums::Element value{};
        if constexpr (std::is_same_v<typename Sums::Element, Integer>)
            value = slot_bits < 128 ? sums.from_slot(product.word(key)) : product.integer(key);
        else
            value = sums.from_slot(product.word(key));
        if (!Sums::is_zero(value)) emit(key, std::move(value));
    }
}

} // namespace eliminant::algebra
