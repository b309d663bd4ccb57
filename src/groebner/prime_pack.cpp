#include "prime_pack.hpp"

#include "eliminant/base/wide.hpp"

#include <algorithm>

namespace eliminant::groebner {

using algebra::Integer;

namespace {

/// Appends the digits of the absolute value.
void append_digits(const Integer& integer, std::size_t length, std::vector<std::uint32_t>& digits) {
    constexpr std::uint64_t mask = (std::uint64_t{1} << DigitVector::digit_bits) - 1;
    const mpz_class number = integer.to_mpz();
    const mp_limb_t* const limbs = mpz_limbs_read(number.get_mpz_t());
    const std::size_t size = mpz_size(number.get_mpz_t());
    base::UInt128 buffer = 0;
    unsigned available = 0; // bits in the buffer
    std::size_t next_limb = 0;
    for (std::size_t i = 0; i < length; ++i) {
        if (available < DigitVector::digit_bits && next_limb < size) {
            buffer |= static_cast<base::UInt128>(limbs[next_limb++]) << available;
            available += GMP_NUMB_BITS;
        }
        digits.push_back(static_cast<std::uint32_t>(buffer & mask));
        buffer >>= DigitVector::digit_bits;
        available -= std::min(available, DigitVector::digit_bits);
    }
}

} // namespace

DigitVector::DigitVector(std::span<const Integer> integers) {
    lengths_.reserve(integers.size());
    negative_.reserve(integers.size());
    std::size_t total = 0;
    for (const Integer& integer : integers) {
        const std::size_t bits = integer.bit_length();
        bits_ = std::max(bits_, bits);
        lengths_.push_back(static_cast<std::uint32_t>((bits + digit_bits - 1) / digit_bits));
        negative_.push_back(integer.sign() < 0);
        total += lengths_.back();
    }
    digits_.reserve(total);
    for (std::size_t i = 0; i < integers.size(); ++i) append_digits(integers[i], lengths_[i], digits_);
}

PrimePack::PrimePack(const LaneEntry& primes)
    : lanes_(primes), fields_(std::begin(primes.lane), std::end(primes.lane)), powers_(1) {
    for (std::size_t lane = 0; lane < lane_count; ++lane) powers_[0].lane[lane] = primes.lane[lane] - 1;
}

std::vector<LaneEntry> PrimePack::residues(const DigitVector& integers, base::Run& run) {
    const LaneKernels& kernels = lane_kernels(base::best_vector_unit());
    while (DigitVector::digit_bits * powers_.size() < integers.bits()) {
        LaneEntry power;
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const std::uint64_t last = powers_.back().lane[lane];
            power.lane[lane] = fields_[lane].reduce(last << DigitVector::digit_bits);
        }
        powers_.push_back(power);
    }
    std::vector<LaneEntry> result(integers.size());
    constexpr std::size_t step = 256; // integers between polls
    const std::uint32_t* digits = integers.digits().data();
    for (std::size_t begin = 0; begin < integers.size(); begin += step) {
        run.poll();
        const auto lengths = integers.lengths().subspan(begin, std::min(step, integers.size() - begin));
        kernels.sum_digits(lanes_, powers_.data(), digits, lengths.data(), lengths.size(), &result[begin]);
        for (const std::uint32_t length : lengths) digits += length;
    }
    for (std::size_t i = 0; i < integers.size(); ++i) {
        if (!integers.is_negative(i)) continue;
        for (std::size_t lane = 0; lane < lane_count; ++lane)
            result[i].lane[lane] = fields_[lane].negate(result[i].lane[lane]);
    }
    return result;
}

LaneEntry PrimePack::inverse(const LaneEntry& c) const {
    LaneEntry result{};
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        if (c.lane[lane] != 0) result.lane[lane] = fields_[lane].inverse(c.lane[lane]);
    }
    return result;
}

} // namespace eliminant::groebner
