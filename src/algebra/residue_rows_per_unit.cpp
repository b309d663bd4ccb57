#include "algebra/residue_rows.hpp"

#include "base/pack.hpp"

namespace eliminant::algebra {
namespace {

// Compilers turn these loops into vector code as they are.

/// The lesser of x and x − p modulo 2^32: x mod p for x < 2p.
inline std::uint32_t corrected(std::uint32_t x, std::uint32_t p) {
    const std::uint32_t less = x - p;
    return less < x ? less : x;
}

inline std::uint32_t times(std::uint32_t x, ResidueFactor factor, std::uint32_t p) {
    const auto quotient = static_cast<std::uint32_t>((std::uint64_t{x} * factor.scaled) >> 32);
    return corrected(x * factor.value - quotient * p, p);
}

void add(std::uint32_t* __restrict x, const std::uint32_t* __restrict y, std::size_t n, std::uint32_t p) {
    for (std::size_t i = 0; i < n; ++i) x[i] = corrected(x[i] + y[i], p);
}

void subtract(std::uint32_t* __restrict x, const std::uint32_t* __restrict y, std::size_t n,
              std::uint32_t p) {
    for (std::size_t i = 0; i < n; ++i) x[i] = corrected(x[i] + (p - y[i]), p);
}

void add_multiple(std::uint32_t* __restrict x, const std::uint32_t* __restrict y, std::size_t n,
                  ResidueFactor factor, std::uint32_t p) {
    for (std::size_t i = 0; i < n; ++i) x[i] = corrected(x[i] + times(y[i], factor, p), p);
}

void scale(std::uint32_t* __restrict x, std::size_t n, ResidueFactor factor, std::uint32_t p) {
    for (std::size_t i = 0; i < n; ++i) x[i] = times(x[i], factor, p);
}

void combine(std::uint32_t* __restrict x, const std::uint32_t* __restrict y, std::size_t n, ResidueFactor s,
             ResidueFactor t, ResidueFactor u, std::uint32_t p) {
    for (std::size_t i = 0; i < n; ++i) {
        const std::uint32_t sum = corrected(times(y[i], t, p) + times(y[i + 1], u, p), p);
        x[i] = corrected(times(x[i], s, p) + sum, p);
    }
}

/// x·y/2^32 mod p, then the same with 2^64 mod p (P. Montgomery, Math. Comp. 44, 1985).
void multiply(std::uint32_t* __restrict x, const std::uint32_t* __restrict y, std::size_t n,
              std::uint32_t p) {
    std::uint32_t inverse = p; // modulo 2^32: three right bits, doubled four times
    for (int step = 0; step < 4; ++step) inverse *= 2 - p * inverse;
    const auto square = static_cast<std::uint32_t>(((std::uint64_t{1} << 32) % p << 32) % p);
    const auto reduced = [p, inverse](std::uint64_t product) {
        const std::uint32_t q = static_cast<std::uint32_t>(product) * (0 - inverse);
        return corrected(static_cast<std::uint32_t>((product + std::uint64_t{q} * p) >> 32), p);
    };
    for (std::size_t i = 0; i < n; ++i)
        x[i] = reduced(std::uint64_t{reduced(std::uint64_t{x[i]} * y[i])} * square);
}

} // namespace

template <base::VectorUnit unit>
const ResidueRows& residue_rows_of() noexcept {
    static constexpr ResidueRows rows = {add, subtract, add_multiple, scale, combine, multiply};
    return rows;
}

template const ResidueRows& residue_rows_of<base::this_unit>() noexcept;

} // namespace eliminant::algebra
