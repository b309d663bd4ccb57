#include "remainder_table.hpp"

#include <cmath>

namespace eliminant::algebra {

namespace {

static_assert(GMP_NUMB_BITS == 64, "words of the Chinese remainder theorem are limbs");

/// r·c mod p for a prepared c (Shoup): one product too large by less than p at most.
std::uint32_t times(std::uint32_t r, std::uint32_t c, std::uint32_t shifted, std::uint32_t p) {
    const std::uint64_t quotient = (static_cast<std::uint64_t>(r) * shifted) >> 32;
    const std::uint64_t rest = static_cast<std::uint64_t>(r) * c - quotient * p;
    return static_cast<std::uint32_t>(rest >= p ? rest - p : rest);
}

} // namespace

RemainderTable::RemainderTable(std::span<const std::uint32_t> primes)
    : primes_(primes.begin(), primes.end()), modulus_(1) {
    for (const std::uint32_t p : primes_) modulus_ *= p;
    limbs_ = mpz_size(modulus_.get_mpz_t());
    for (std::size_t i = 0; i < primes_.size(); i += 2) {
        const bool paired = i + 1 < primes_.size();
        const std::uint64_t product = static_cast<std::uint64_t>(primes_[i]) * (paired ? primes_[i + 1] : 1);
        mpz_class rest;
        mpz_divexact_ui(rest.get_mpz_t(), modulus_.get_mpz_t(), product);
        for (std::size_t k = 0; k < limbs_; ++k)
            rows_.push_back(mpz_getlimbn(rest.get_mpz_t(), static_cast<mp_size_t>(k)));
        reciprocal_.push_back(1 / static_cast<double>(product));
        for (std::size_t j = i; j < i + (paired ? 2 : 1); ++j) {
            const std::uint64_t p = primes_[j];
            const std::uint64_t residue = mpz_fdiv_ui(rest.get_mpz_t(), p) * (product / p % p) % p;
            mpz_class inverse(residue);
            const mpz_class prime(p);
            mpz_invert(inverse.get_mpz_t(), inverse.get_mpz_t(), prime.get_mpz_t());
            inverses_.push_back(static_cast<std::uint32_t>(inverse.get_ui()));
        }
    }
}

RemainderTable::Factor RemainderTable::prepare(const Integer& factor) const {
    Factor result;
    for (std::size_t i = 0; i < primes_.size(); ++i) {
        const std::uint64_t c = factor.residue(primes_[i]) * inverses_[i] % primes_[i];
        result.value.push_back(static_cast<std::uint32_t>(c));
        result.shifted.push_back(static_cast<std::uint32_t>((c << 32) / primes_[i]));
    }
    return result;
}

void RemainderTable::combine(std::span<const std::uint32_t> residues, const Factor& factor,
                             std::vector<mp_limb_t>& scratch, mpz_class& result) const {
    // The sum is below k·M and so has one limb more than M.
    scratch.assign(limbs_ + 1, 0);
    const auto size = static_cast<mp_size_t>(limbs_);
    double quotient = 0; // of the sum by M
    const auto y = [&](std::size_t i) {
        return std::uint64_t{times(residues[i], factor.value[i], factor.shifted[i], primes_[i])};
    };
    for (std::size_t i = 0; i < primes_.size(); i += 2) {
        const std::uint64_t word =
            i + 1 < primes_.size() ? y(i) * primes_[i + 1] + y(i + 1) * primes_[i] : y(i);
        if (word == 0) continue;
        quotient += static_cast<double>(word) * reciprocal_[i / 2];
        scratch[limbs_] += mpn_addmul_1(scratch.data(), row(i / 2), size, word);
    }
    // Rounded, the quotient leaves the residue of least magnitude.
    const auto multiple = static_cast<mp_limb_t>(std::llround(quotient));
    const mp_limb_t borrow =
        mpn_submul_1(scratch.data(), mpz_limbs_read(modulus_.get_mpz_t()), size, multiple);
    const bool negative = scratch[limbs_] < borrow;
    if (negative) mpn_neg(scratch.data(), scratch.data(), size);
    mp_limb_t* const limbs = mpz_limbs_write(result.get_mpz_t(), size);
    mpn_copyi(limbs, scratch.data(), size);
    mpz_limbs_finish(result.get_mpz_t(), negative ? -size : size);
}

} // namespace eliminant::algebra
