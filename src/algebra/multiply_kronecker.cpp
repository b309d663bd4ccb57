#include "multiply_kronecker.hpp"

#include <algorithm>

namespace eliminant::algebra {

namespace {

constexpr std::size_t limb_bits = 64;
static_assert(sizeof(mp_limb_t) * 8 == limb_bits && GMP_NAIL_BITS == 0);

/// Non-negative numbers laid side by side.
class SlotWriter {
  public:
    SlotWriter(std::uint64_t slots, std::size_t slot_bits)
        : limbs_(static_cast<std::size_t>(slots) * slot_bits / limb_bits + 2, 0), slot_bits_(slot_bits) {}
    void write(std::uint64_t slot, std::span<const mp_limb_t> value) {
        const std::size_t bit = static_cast<std::size_t>(slot) * slot_bits_;
        const std::size_t shift = bit % limb_bits;
        mp_limb_t* out = limbs_.data() + bit / limb_bits;
        for (const mp_limb_t limb : value) {
            *out |= limb << shift;
            ++out;
            if (shift != 0 && limb >> (limb_bits - shift) != 0) *out |= limb >> (limb_bits - shift);
        }
    }
    mpz_class take() const {
        mpz_t view;
        return mpz_class(mpz_roinit_n(view, limbs_.data(), static_cast<mp_size_t>(limbs_.size())));
    }

  private:
    std::vector<mp_limb_t> limbs_;
    std::size_t slot_bits_;
};

/// `write_magnitude(i, writer)` writes |cᵢ| to its slot.
template <class Coefficients, class WriteMagnitude>
SlotInteger pack_signed(std::span<const std::uint64_t> keys, const Coefficients& coefficients,
                        std::size_t slot_bits, auto&& is_negative, WriteMagnitude&& write_magnitude) {
    SlotWriter positive(keys[0] + 1, slot_bits);
    bool any_negative = false;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (is_negative(coefficients[i]))
            any_negative = true;
        else
            write_magnitude(positive, keys[i], coefficients[i]);
    }
    mpz_class value = positive.take();
    if (any_negative) {
        SlotWriter negative(keys[0] + 1, slot_bits);
        for (std::size_t i = 0; i < keys.size(); ++i) {
            if (is_negative(coefficients[i])) write_magnitude(negative, keys[i], coefficients[i]);
        }
        value -= negative.take();
    }
    return {std::move(value), slot_bits};
}

/// 1 if the slots below `bit` add up to a negative number; see the class comment. Of the magnitude, as all
/// reading.
unsigned borrowed(mpz_srcptr z, std::size_t bit) {
    if (bit == 0) return 0;
    return static_cast<unsigned>(mpz_getlimbn(z, static_cast<mp_size_t>((bit - 1) / limb_bits)) >>
                                 ((bit - 1) % limb_bits)) &
           1U;
}

} // namespace

SlotInteger SlotInteger::pack(std::span<const std::uint64_t> keys,
                              std::span<const std::uint32_t> coefficients, std::size_t slot_bits) {
    SlotWriter writer(keys[0] + 1, slot_bits);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const mp_limb_t limb = coefficients[i];
        writer.write(keys[i], {&limb, 1});
    }
    return {writer.take(), slot_bits};
}

SlotInteger SlotInteger::pack(std::span<const std::uint64_t> keys, std::span<const std::int64_t> coefficients,
                              std::size_t slot_bits) {
    const auto write = [](SlotWriter& writer, std::uint64_t slot, std::int64_t c) {
        const auto limb = static_cast<mp_limb_t>(c < 0 ? -c : c);
        writer.write(slot, {&limb, 1});
    };
    return pack_signed(
        keys, coefficients, slot_bits, [](std::int64_t c) { return c < 0; }, write);
}

SlotInteger SlotInteger::pack(std::span<const std::uint64_t> keys, std::span<const Integer> coefficients,
                              std::size_t slot_bits) {
    const auto write = [](SlotWriter& writer, std::uint64_t slot, const Integer& c) {
        const Integer::View view(c);
        writer.write(slot, {mpz_limbs_read(view), mpz_size(view)});
    };
    return pack_signed(
        keys, coefficients, slot_bits, [](const Integer& c) { return c.sign() < 0; }, write);
}

std::optional<SlotInteger> SlotInteger::exact_quotient(const SlotInteger& divisor) const {
    mpz_class quotient;
    mpz_class rest;
    mpz_tdiv_qr(quotient.get_mpz_t(), rest.get_mpz_t(), value_.get_mpz_t(), divisor.value_.get_mpz_t());
    if (rest != 0) return std::nullopt;
    return SlotInteger(std::move(quotient), slot_bits_);
}

base::Int128 SlotInteger::word(std::uint64_t k) const {
    mpz_srcptr z = value_.get_mpz_t();
    const std::size_t bit = static_cast<std::size_t>(k) * slot_bits_;
    const auto limb = static_cast<mp_size_t>(bit / limb_bits);
    const std::size_t shift = bit % limb_bits;
    // Limbs beyond the end read as 0. Three of them hold every slot of less than 128 bits.
    auto field =
        (static_cast<base::UInt128>(mpz_getlimbn(z, limb + 1)) << limb_bits | mpz_getlimbn(z, limb)) >> shift;
    if (shift != 0) field |= static_cast<base::UInt128>(mpz_getlimbn(z, limb + 2)) << (2 * limb_bits - shift);
    field += borrowed(z, bit);
    const auto unused = static_cast<unsigned>(2 * limb_bits - slot_bits_);
    const auto value = static_cast<base::Int128>(field << unused) >> unused; // extends the slot's sign
    return mpz_sgn(z) < 0 ? -value : value;
}

Integer SlotInteger::integer(std::uint64_t k) const {
    const std::size_t bit = static_cast<std::size_t>(k) * slot_bits_;
    mpz_srcptr z = value_.get_mpz_t();
    const auto first = bit / limb_bits;
    const std::size_t size = mpz_size(z);
    const std::size_t count = first >= size ? 0 : std::min(size - first, slot_bits_ / limb_bits + 2);
    mpz_t view;
    mpz_srcptr limbs =
        mpz_roinit_n(view, mpz_limbs_read(z) + (count != 0 ? first : 0), static_cast<mp_size_t>(count));
    mpz_class value;
    mpz_fdiv_q_2exp(value.get_mpz_t(), limbs, bit % limb_bits);
    value += borrowed(z, bit);
    mpz_fdiv_r_2exp(value.get_mpz_t(), value.get_mpz_t(), slot_bits_);
    if (mpz_tstbit(value.get_mpz_t(), slot_bits_ - 1) != 0) {
        mpz_class turn = 1;
        turn <<= slot_bits_;
        value -= turn;
    }
    if (mpz_sgn(z) < 0) value = -value;
    return Integer(value);
}

} // namespace eliminant::algebra
