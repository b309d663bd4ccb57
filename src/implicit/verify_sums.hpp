// The inner loops of evaluation at eight points, for each vector unit.
#pragma once

#include "base/vector_unit.hpp"

#include <cstddef>
#include <cstdint>

namespace eliminant::implicit {

/// Points that are treated together.
constexpr std::size_t evaluation_lanes = 8;

/// GF(p), p odd and below 2^30, with the product a·b/2^32 (Montgomery 1985), which needs no division and is
/// the same few instructions in every lane.
struct MontgomeryModulus {
    explicit MontgomeryModulus(std::uint32_t characteristic);

    std::uint32_t p;
    std::uint32_t negative_inverse; ///< −1/p modulo 2^32
    std::uint32_t one;              ///< 2^32 modulo p: the neutral element of that product
    std::uint32_t square_of_one;    ///< 2^64 modulo p
};

/// A sum reduced at once has at most so many products of residues: 11·2^60 and the multiple of p below 2^62
/// that makes it divisible by 2^32 fit in 64 bits, and the quotient is below 4p.
constexpr std::size_t products_in_a_sum = 11;

/// Powers are made of those so many before: a product takes some twenty cycles, but does not wait for others.
constexpr std::size_t power_stride = 4;

/// The edges between two levels of a tree: a node has the children first_child[node] up to, not including,
/// first_child[node + 1].
struct TreeEdges {
    const std::uint32_t* first_child; ///< one more than there are nodes
    std::size_t node_count;
    const std::uint32_t* exponents; ///< of each child
};

/// Loops over arrays [index][lane].
struct EvaluationLoops {
    /// powers[e] = x^e·2^32 for e < count, count > 0.
    void (*powers)(std::uint64_t* powers, const std::uint32_t* x, std::size_t count,
                   const MontgomeryModulus& modulus);
    /// sums[node] = Σ powers[exponents[i]]·values[i]/2^32 over the children i of each node.
    void (*sums)(std::uint32_t* sums, const TreeEdges& edges, const std::uint64_t* powers,
                 const std::uint32_t* values, const MontgomeryModulus& modulus);
    /// The same for values that are alike in all lanes: one a child.
    void (*sums_of_leaves)(std::uint32_t* sums, const TreeEdges& edges, const std::uint64_t* powers,
                           const std::uint32_t* values, const MontgomeryModulus& modulus);
};

/// Defined for each unit by verify_sums_per_unit.cpp.
template <base::VectorUnit unit>
EvaluationLoops evaluation_loops_of();

inline EvaluationLoops evaluation_loops(base::VectorUnit unit) {
    return base::with_unit(unit, [](auto u) { return evaluation_loops_of<u()>(); });
}

} // namespace eliminant::implicit
