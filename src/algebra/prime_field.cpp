#include "eliminant/algebra/prime_field.hpp"

#include "eliminant/base/error.hpp"

#include <array>
#include <limits>
#include <span>
#include <string>

namespace eliminant::algebra {

namespace {

std::uint64_t multiply_modulo(std::uint64_t a, std::uint64_t b, std::uint64_t m) {
    if (m <= std::uint64_t{1} << 32) return a * b % m; // several times faster
    return static_cast<std::uint64_t>(static_cast<base::UInt128>(a) * b % m);
}

std::uint64_t power_modulo(std::uint64_t base, std::uint64_t exponent, std::uint64_t m) {
    std::uint64_t result = 1 % m;
    for (; exponent != 0; exponent >>= 1) {
        if ((exponent & 1) != 0) result = multiply_modulo(result, base, m);
        base = multiply_modulo(base, base, m);
    }
    return result;
}

/// Whether odd n > witness passes the strong pseudoprime test to that base.
bool passes_strong_test(std::uint64_t n, std::uint64_t witness) {
    const int twos = __builtin_ctzll(n - 1);
    std::uint64_t x = power_modulo(witness % n, (n - 1) >> twos, n);
    if (x == 0 || x == 1 || x == n - 1) return true;
    for (int i = 1; i < twos; ++i) {
        x = multiply_modulo(x, x, n);
        if (x == n - 1) return true;
    }
    return false;
}

} // namespace

bool is_prime(std::uint64_t n) {
    constexpr std::array<std::uint64_t, 12> bases = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
    if (n < 2) return false;
    for (const std::uint64_t q : bases) {
        if (n % q == 0) return n == q;
    }
    // Four bases suffice below 3 215 031 751 (Pomerance, Selfridge and Wagstaff 1980).
    for (const std::uint64_t base : std::span(bases).first(n < 3215031751 ? 4 : bases.size())) {
        if (!passes_strong_test(n, base)) return false;
    }
    return true;
}

std::uint64_t previous_prime(std::uint64_t bound) {
    if (bound < 3) throw DomainError("there is no prime below " + std::to_string(bound));
    std::uint64_t n = bound - 1;
    while (!is_prime(n)) --n;
    return n;
}

PrimeField::PrimeField(std::uint64_t p) : p_(0), reciprocal_(0) {
    if (p > max_characteristic)
        throw DomainError("the characteristic of GF(p) is a prime below 2^31, found " + std::to_string(p));
    if (!is_prime(p)) throw DomainError("the characteristic of GF(p) is a prime, found " + std::to_string(p));
    p_ = static_cast<std::uint32_t>(p);
    reciprocal_ = std::numeric_limits<std::uint64_t>::max() / p;
}

PrimeField::Element PrimeField::from_fraction(const Integer& n, const Integer& d) const {
    const Element denominator = from_integer(d);
    if (denominator == 0)
        throw DomainError("the denominator " + d.to_string() + " is zero in GF(" + std::to_string(p_) + ")");
    return multiply(from_integer(n), inverse(denominator));
}

PrimeField::Element PrimeField::inverse(Element a) const {
    if (a == 0) throw DomainError("division by zero in GF(" + std::to_string(p_) + ")");
    std::int64_t r0 = p_;
    std::int64_t r1 = a;
    std::int64_t s0 = 0;
    std::int64_t s1 = 1;
    while (r1 != 0) { // s_i·a ≡ r_i (mod p)
        const std::int64_t q = r0 / r1;
        r0 = std::exchange(r1, r0 - q * r1);
        s0 = std::exchange(s1, s0 - q * s1);
    }
    return static_cast<Element>(s0 < 0 ? s0 + p_ : s0);
}

PrimeField::Element PrimeField::power(Element base, std::uint64_t exponent) const {
    Element result = reduce(1);
    for (; exponent != 0; exponent >>= 1) {
        if ((exponent & 1) != 0) result = multiply(result, base);
        base = multiply(base, base);
    }
    return result;
}

} // namespace eliminant::algebra
