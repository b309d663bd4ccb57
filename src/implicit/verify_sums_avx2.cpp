#include "implicit/verify_sums.hpp"

#include <immintrin.h>

namespace eliminant::implicit {

namespace {

constexpr std::size_t lanes = evaluation_lanes;

/// Eight lanes of 64 bits.
struct Wide {
    __m256i low;
    __m256i high;
};

struct Constants {
    explicit Constants(const MontgomeryModulus& modulus)
        : p(_mm256_set1_epi64x(modulus.p)), twice_p(_mm256_set1_epi64x(2 * std::int64_t{modulus.p})),
          negative_inverse(_mm256_set1_epi64x(modulus.negative_inverse)) {}
    __m256i p;
    __m256i twice_p;
    __m256i negative_inverse;
};

__m256i load_four(const std::uint64_t* from) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
}

void store_four(std::uint64_t* to, __m256i values) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), values);
}

__m256i widened_four(const std::uint32_t* from) {
    return _mm256_cvtepu32_epi64(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from)));
}

__m256i reduced(__m256i sum, const Constants& c) {
    const __m256i multiple = _mm256_mul_epu32(_mm256_mul_epu32(sum, c.negative_inverse), c.p);
    __m256i result = _mm256_srli_epi64(_mm256_add_epi64(sum, multiple), 32);
    result = _mm256_min_epu32(result, _mm256_sub_epi32(result, c.twice_p));
    return _mm256_min_epu32(result, _mm256_sub_epi32(result, c.p));
}

__m256i sum_modulo(__m256i a, __m256i b, const Constants& c) {
    const __m256i both = _mm256_add_epi32(a, b);
    return _mm256_min_epu32(both, _mm256_sub_epi32(both, c.p));
}

/// The lower halves of eight lanes.
void store_narrowed(std::uint32_t* to, const Wide& wide) {
    const __m256i even = _mm256_setr_epi32(0, 2, 4, 6, 0, 2, 4, 6);
    const __m256i low = _mm256_permutevar8x32_epi32(wide.low, even);
    const __m256i high = _mm256_permutevar8x32_epi32(wide.high, even);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_blend_epi32(low, high, 0xf0));
}

void make_powers(std::uint64_t* powers, const std::uint32_t* x, std::size_t count,
                 const MontgomeryModulus& modulus) {
    const Constants c(modulus);
    const __m256i square = _mm256_set1_epi64x(modulus.square_of_one);
    for (std::size_t half = 0; half < lanes; half += 4) {
        const __m256i factor = reduced(_mm256_mul_epu32(widened_four(x + half), square), c);
        __m256i power = _mm256_set1_epi64x(modulus.one);
        for (std::size_t e = 0; e < power_stride; ++e) {
            if (e < count) store_four(powers + e * lanes + half, power);
            power = reduced(_mm256_mul_epu32(power, factor), c);
        }
        for (std::size_t e = power_stride; e < count; ++e) {
            const __m256i before = load_four(powers + (e - power_stride) * lanes + half);
            store_four(powers + e * lanes + half, reduced(_mm256_mul_epu32(before, power), c));
        }
    }
}

struct LeafValues {
    const std::uint32_t* values;
    Wide operator()(std::size_t child) const {
        const __m256i value = _mm256_set1_epi64x(values[child]);
        return {value, value};
    }
};

struct NodeValues {
    const std::uint32_t* values;
    Wide operator()(std::size_t child) const {
        const std::uint32_t* const value = values + child * lanes;
        return {widened_four(value), widened_four(value + 4)};
    }
};

template <class Values>
void sum_children(std::uint32_t* sums, const TreeEdges& edges, const std::uint64_t* powers,
                  const std::uint32_t* values, const MontgomeryModulus& modulus) {
    const Constants c(modulus);
    const Values value_of{values};
    for (std::size_t node = 0; node < edges.node_count; ++node) {
        Wide total{_mm256_setzero_si256(), _mm256_setzero_si256()};
        const std::size_t last = edges.first_child[node + 1];
        for (std::size_t child = edges.first_child[node]; child < last;) {
            const std::size_t stop = last - child > products_in_a_sum ? child + products_in_a_sum : last;
            Wide sum{_mm256_setzero_si256(), _mm256_setzero_si256()};
            for (; child < stop; ++child) {
                const std::uint64_t* const power = powers + lanes * edges.exponents[child];
                const Wide value = value_of(child);
                sum.low = _mm256_add_epi64(sum.low, _mm256_mul_epu32(load_four(power), value.low));
                sum.high = _mm256_add_epi64(sum.high, _mm256_mul_epu32(load_four(power + 4), value.high));
            }
            total.low = sum_modulo(total.low, reduced(sum.low, c), c);
            total.high = sum_modulo(total.high, reduced(sum.high, c), c);
        }
        store_narrowed(sums + node * lanes, total);
    }
}

} // namespace

EvaluationLoops evaluation_loops_avx2() {
    return {make_powers, sum_children<NodeValues>, sum_children<LeafValues>};
}

} // namespace eliminant::implicit
