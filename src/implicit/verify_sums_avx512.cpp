#include "implicit/verify_sums.hpp"

// GCC 12 takes the deliberately undefined operand inside its own intrinsics for a mistake of ours.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif
#include <immintrin.h>

namespace eliminant::implicit {

namespace {

constexpr std::size_t lanes = evaluation_lanes;

struct Constants {
    explicit Constants(const MontgomeryModulus& modulus)
        : p(_mm512_set1_epi64(modulus.p)), twice_p(_mm512_set1_epi64(2 * std::int64_t{modulus.p})),
          negative_inverse(_mm512_set1_epi64(modulus.negative_inverse)) {}
    __m512i p;
    __m512i twice_p;
    __m512i negative_inverse;
};

__m512i widened(const std::uint32_t* from) {
    return _mm512_cvtepu32_epi64(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(from)));
}

__m512i reduced(__m512i sum, const Constants& c) {
    const __m512i multiple = _mm512_mul_epu32(_mm512_mul_epu32(sum, c.negative_inverse), c.p);
    __m512i result = _mm512_srli_epi64(_mm512_add_epi64(sum, multiple), 32);
    result = _mm512_min_epu32(result, _mm512_sub_epi32(result, c.twice_p));
    return _mm512_min_epu32(result, _mm512_sub_epi32(result, c.p));
}

void make_powers(std::uint64_t* powers, const std::uint32_t* x, std::size_t count,
                 const MontgomeryModulus& modulus) {
    const Constants c(modulus);
    const __m512i factor = reduced(_mm512_mul_epu32(widened(x), _mm512_set1_epi64(modulus.square_of_one)), c);
    __m512i power = _mm512_set1_epi64(modulus.one);
    for (std::size_t e = 0; e < power_stride; ++e) {
        if (e < count) _mm512_storeu_si512(powers + e * lanes, power);
        power = reduced(_mm512_mul_epu32(power, factor), c);
    }
    for (std::size_t e = power_stride; e < count; ++e) {
        const __m512i before = _mm512_loadu_si512(powers + (e - power_stride) * lanes);
        _mm512_storeu_si512(powers + e * lanes, reduced(_mm512_mul_epu32(before, power), c));
    }
}

struct LeafValues {
    const std::uint32_t* values;
    __m512i operator()(std::size_t child) const { return _mm512_set1_epi64(values[child]); }
};

struct NodeValues {
    const std::uint32_t* values;
    __m512i operator()(std::size_t child) const { return widened(values + child * lanes); }
};

template <class Values>
void sum_children(std::uint32_t* sums, const TreeEdges& edges, const std::uint64_t* powers,
                  const std::uint32_t* values, const MontgomeryModulus& modulus) {
    const Constants c(modulus);
    const Values value_of{values};
    for (std::size_t node = 0; node < edges.node_count; ++node) {
        __m512i total = _mm512_setzero_si512();
        const std::size_t last = edges.first_child[node + 1];
        for (std::size_t child = edges.first_child[node]; child < last;) {
            const std::size_t stop = last - child > products_in_a_sum ? child + products_in_a_sum : last;
            __m512i sum = _mm512_setzero_si512();
            for (; child < stop; ++child) {
                const __m512i power = _mm512_loadu_si512(powers + lanes * edges.exponents[child]);
                sum = _mm512_add_epi64(sum, _mm512_mul_epu32(power, value_of(child)));
            }
            const __m512i both = _mm512_add_epi32(total, reduced(sum, c));
            total = _mm512_min_epu32(both, _mm512_sub_epi32(both, c.p));
        }
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(sums + node * lanes), _mm512_cvtepi64_epi32(total));
    }
}

} // namespace

EvaluationLoops evaluation_loops_avx512() {
    return {make_powers, sum_children<NodeValues>, sum_children<LeafValues>};
}

} // namespace eliminant::implicit
