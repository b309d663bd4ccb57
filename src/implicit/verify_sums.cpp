#include "implicit/verify_sums.hpp"

#include <algorithm>
#include <array>

namespace eliminant::implicit {

MontgomeryModulus::MontgomeryModulus(std::uint32_t characteristic)
    : p(characteristic), negative_inverse(1),
      one(static_cast<std::uint32_t>((std::uint64_t{1} << 32) % characteristic)),
      square_of_one(static_cast<std::uint32_t>(std::uint64_t{one} * one % characteristic)) {
    // Newton: each step doubles the number of bits that are right, starting with one.
    for (int step = 0; step < 5; ++step) negative_inverse *= 2 + p * negative_inverse;
}

namespace {

constexpr std::size_t lanes = evaluation_lanes;

std::uint32_t reduced(std::uint64_t sum, const MontgomeryModulus& modulus) {
    const std::uint32_t factor = static_cast<std::uint32_t>(sum) * modulus.negative_inverse;
    auto result = static_cast<std::uint32_t>((sum + std::uint64_t{factor} * modulus.p) >> 32);
    result = std::min(result, result - 2 * modulus.p); // the difference wraps if it is negative
    return std::min(result, result - modulus.p);
}

void powers_portable(std::uint64_t* powers, const std::uint32_t* x, std::size_t count,
                     const MontgomeryModulus& modulus) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        const std::uint32_t factor = reduced(std::uint64_t{x[lane]} * modulus.square_of_one, modulus);
        powers[lane] = modulus.one;
        for (std::size_t e = 1; e < count; ++e)
            powers[e * lanes + lane] = reduced(powers[(e - 1) * lanes + lane] * factor, modulus);
    }
}

/// \param value_of (child, lane)
template <class ValueOf>
void sum_children(std::uint32_t* sums, const TreeEdges& edges, const std::uint64_t* powers,
                  const ValueOf& value_of, const MontgomeryModulus& modulus) {
    for (std::size_t node = 0; node < edges.node_count; ++node) {
        std::array<std::uint32_t, lanes> total = {};
        const std::size_t last = edges.first_child[node + 1];
        for (std::size_t child = edges.first_child[node]; child < last;) {
            const std::size_t stop = std::min(last, child + products_in_a_sum);
            std::array<std::uint64_t, lanes> sum = {};
            for (; child < stop; ++child) {
                const std::uint64_t* const power = powers + lanes * edges.exponents[child];
                for (std::size_t lane = 0; lane < lanes; ++lane)
                    sum[lane] += power[lane] * value_of(child, lane);
            }
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const std::uint32_t both = total[lane] + reduced(sum[lane], modulus);
                total[lane] = std::min(both, both - modulus.p);
            }
        }
        std::ranges::copy(total, sums + node * lanes);
    }
}

void sums_portable(std::uint32_t* sums, const TreeEdges& edges, const std::uint64_t* powers,
                   const std::uint32_t* values, const MontgomeryModulus& modulus) {
    sum_children(
        sums, edges, powers,
        [values](std::size_t child, std::size_t lane) { return values[child * lanes + lane]; }, modulus);
}

void sums_of_leaves_portable(std::uint32_t* sums, const TreeEdges& edges, const std::uint64_t* powers,
                             const std::uint32_t* values, const MontgomeryModulus& modulus) {
    sum_children(
        sums, edges, powers, [values](std::size_t child, std::size_t) { return values[child]; }, modulus);
}

} // namespace

EvaluationLoops evaluation_loops(base::VectorUnit unit) {
#if defined(__x86_64__)
    if (unit == base::VectorUnit::avx512) return evaluation_loops_avx512();
    if (unit == base::VectorUnit::avx2) return evaluation_loops_avx2();
#else
    static_cast<void>(unit);
#endif
    return {powers_portable, sums_portable, sums_of_leaves_portable};
}

} // namespace eliminant::implicit
