#include "rational_reconstruction.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace eliminant::algebra {

namespace {

/// ⌊value/2^shift⌋, which has at most 64 bits, for value ≥ 0.
std::uint64_t shifted(const mpz_class& value, std::size_t shift) {
    const std::size_t limb = shift / GMP_NUMB_BITS;
    const std::size_t bit = shift % GMP_NUMB_BITS;
    const std::uint64_t low = mpz_getlimbn(value.get_mpz_t(), static_cast<mp_size_t>(limb)) >> bit;
    if (bit == 0) return low;
    return low | mpz_getlimbn(value.get_mpz_t(), static_cast<mp_size_t>(limb + 1)) << (GMP_NUMB_BITS - bit);
}

/// Two steps' worth or more of Euclid's algorithm: (u, v) ↦ (a·u + b·v, c·u + d·v).
struct Steps {
    std::int64_t a = 1;
    std::int64_t b = 0;
    std::int64_t c = 0;
    std::int64_t d = 1;

    bool none() const { return b == 0; }
};

/// The steps that the leading 62 bits x ≥ y of two numbers determine, as long as quotients stay small.
Steps steps_from_leading_bits(std::int64_t x, std::int64_t y) {
    constexpr std::int64_t largest_quotient = 1 << 16; // larger ones may be what is looked for
    constexpr std::int64_t largest_factor = std::int64_t{1} << 40;
    Steps s;
    while (y + s.c != 0 && y + s.d != 0) {
        const std::int64_t q = (x + s.a) / (y + s.c);
        if (q != (x + s.b) / (y + s.d) || q > largest_quotient) break;
        const std::int64_t c = s.a - q * s.c;
        const std::int64_t d = s.b - q * s.d;
        s = {s.c, s.d, c, d};
        x = std::exchange(y, x - q * y);
        if (std::max(std::abs(c), std::abs(d)) > largest_factor) break;
    }
    return s;
}

void apply(const Steps& s, mpz_class& u, mpz_class& v, mpz_class& scratch) {
    const auto add_multiple = [](mpz_class& sum, const mpz_class& value, std::int64_t factor) {
        if (factor >= 0)
            mpz_addmul_ui(sum.get_mpz_t(), value.get_mpz_t(), static_cast<unsigned long>(factor));
        else
            mpz_submul_ui(sum.get_mpz_t(), value.get_mpz_t(), static_cast<unsigned long>(-factor));
    };
    scratch = u;
    u *= static_cast<long>(s.a);
    add_multiple(u, v, s.b);
    v *= static_cast<long>(s.d);
    add_multiple(v, scratch, s.c);
}

} // namespace

std::optional<Fraction> reconstruct_fraction(const mpz_class& residue, const mpz_class& modulus,
                                             unsigned margin_bits, base::Run& run) {
    // r ≡ t·a modulo M throughout, and r₀·|t₁| + r₁·|t₀| = M: a quotient q = r₀/r₁ makes r₁·|t₁| about M/q.
    mpz_class r0 = modulus;
    mpz_class r1 = residue;
    mpz_class t0 = 0;
    mpz_class t1 = 1;
    mpz_class quotient;
    mpz_class scratch;
    for (unsigned count = 1; r1 != 0; ++count) {
        if (count % 64 == 0) run.poll();
        const std::size_t bits = mpz_sizeinbase(r0.get_mpz_t(), 2);
        const std::size_t shift = bits > 62 ? bits - 62 : 0;
        const Steps steps = steps_from_leading_bits(static_cast<std::int64_t>(shifted(r0, shift)),
                                                    static_cast<std::int64_t>(shifted(r1, shift)));
        if (!steps.none()) {
            apply(steps, r0, r1, scratch);
            apply(steps, t0, t1, scratch);
            continue;
        }
        mpz_tdiv_qr(quotient.get_mpz_t(), r0.get_mpz_t(), r0.get_mpz_t(), r1.get_mpz_t());
        if (mpz_sizeinbase(quotient.get_mpz_t(), 2) > margin_bits) break;
        std::swap(r0, r1);
        mpz_submul(t0.get_mpz_t(), quotient.get_mpz_t(), t1.get_mpz_t());
        std::swap(t0, t1);
    }
    // a = 0 ends at once, with 0/1; any other a without a large quotient with r₁ = 0 and |t₁| = M/gcd(a, M).
    if (r1 == 0 && t1 != 1) return std::nullopt;
    if (t1 < 0) {
        r1 = -r1;
        t1 = -t1;
    }
    if (gcd(r1, t1) != 1) return std::nullopt;
    return Fraction{std::move(r1), std::move(t1)};
}

} // namespace eliminant::algebra
