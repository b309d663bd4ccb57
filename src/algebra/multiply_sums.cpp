#include "multiply_sums.hpp"

namespace eliminant::algebra {

base::Int128 wide_value(const Integer& value) {
    if (value.is_small()) return value.small_value();
    const Integer::View view(value);
    const auto low = static_cast<base::UInt128>(mpz_getlimbn(view, 0));
    const auto high = static_cast<base::UInt128>(mpz_getlimbn(view, 1));
    const auto magnitude = static_cast<base::Int128>(high << 64 | low);
    return value.sign() < 0 ? -magnitude : magnitude;
}

void TripleSums::add_value(Cell& sum, const Integer& value) {
    if (value.bit_length() < 127) {
        sum.add(wide_value(value));
        return;
    }
    const Integer::View view(value);
    Cell limbs{mpz_getlimbn(view, 0), mpz_getlimbn(view, 1), mpz_getlimbn(view, 2)};
    if (value.sign() < 0) {
        limbs = {~limbs.low, ~limbs.middle, ~limbs.high};
        limbs.add(1);
    }
    const auto lower = static_cast<base::UInt128>(limbs.middle) << 64 | limbs.low;
    const auto before = static_cast<base::UInt128>(sum.middle) << 64 | sum.low;
    const base::UInt128 after = before + lower;
    sum = {static_cast<std::uint64_t>(after), static_cast<std::uint64_t>(after >> 64),
           sum.high + limbs.high + (after < lower ? 1 : 0)};
}

Integer TripleSums::take(Cell& sum) {
    const Cell value = std::exchange(sum, Cell{});
    const auto lower = static_cast<base::UInt128>(value.middle) << 64 | value.low;
    const auto sign = static_cast<std::uint64_t>(static_cast<base::Int128>(lower) >> 127);
    if (value.high == sign) return Integer::from_wide(static_cast<base::Int128>(lower));
    Integer result(static_cast<std::int64_t>(value.high));
    for (const std::uint64_t limb : {value.middle, value.low})
        result = result * Integer::from_wide(static_cast<base::Int128>(1) << 64) +
                 Integer::from_wide(static_cast<base::Int128>(limb));
    return result;
}

CoefficientSize coefficient_size(std::span<const Integer> coefficients) {
    CoefficientSize size;
    std::uint64_t any = 0; // an OR of magnitudes has the bit length of the largest
    base::UInt128 sum = 0;
    for (const Integer& c : coefficients) {
        if (!c.is_small()) {
            size.all_small = false;
            size.max_bits = std::max(size.max_bits, c.bit_length());
            continue;
        }
        const std::int64_t value = c.small_value();
        const auto magnitude = static_cast<std::uint64_t>(value < 0 ? -value : value);
        any |= magnitude;
        sum += magnitude;
    }
    const auto bit_length = [](std::uint64_t x) {
        return static_cast<std::size_t>(64 - std::countl_zero(x));
    };
    size.max_bits = std::max(size.max_bits, bit_length(any));
    const auto high = static_cast<std::uint64_t>(sum >> 64);
    size.sum_bits = high != 0 ? 64 + bit_length(high) : bit_length(static_cast<std::uint64_t>(sum));
    if (!size.all_small) size.sum_bits = size.max_bits + bit_length(coefficients.size());
    return size;
}

std::vector<std::int64_t> small_values(std::span<const Integer> coefficients) {
    std::vector<std::int64_t> values(coefficients.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = coefficients[i].small_value();
    return values;
}

} // namespace eliminant::algebra
