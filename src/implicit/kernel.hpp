// The kernel of a graded map.
#pragma once

#include "eliminant/groebner/buchberger.hpp"
#include "implicit/graded_map.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace eliminant::implicit {

/// Generators of a kernel, primitive integer polynomials in the kept variables, and what they took.
struct Kernel {
    std::vector<algebra::Polynomial> generators; ///< a reduced Groebner basis
    std::uint64_t primes_used = 0;
    groebner::Statistics statistics;
};

/// What is known of a kernel before it is computed.
enum class Codimension {
    one_at_most, ///< the image has dimension n − 1 or more, so the kernel is zero or principal
    unknown,
};

/// An elimination modulo the first prime, and what it took.
struct EliminationEffort {
    double products;           ///< about so many: reduction steps, times the median of the numbers of terms
    double bits;               ///< about log₂ of the product of primes that a proof needs
    algebra::Polynomial image; ///< of the generator of the kernel, monic
};

/// In codimension one: nullopt if it would take more, as far as the sizes of the elements tell when they
/// come, before one of the kernel is met.
std::optional<EliminationEffort> elimination_effort(const GradedMap& map, double max_products,
                                                    base::Run& run);

/// The kernel of a map whose domain has no relations but rotations, from its images modulo word-size primes,
/// put together by Chinese remaindering and rational reconstruction. Time and memory are those of a Groebner
/// basis, for which no useful bound is known; methods for hypersurfaces are preferred where they can be had
/// (method_choice.hpp). Coefficients of the intermediate
/// polynomials are then at no time longer than a word, while over ℚ they dwarf those of the result:
/// `dense10_curve` takes Singular 20 s over ℚ, and less than 10 ms modulo each of 11 primes.
///
/// The result is proved. Let N be the kernel, N(p) that of the map modulo p, both graded. φ in degree D is an
/// integer matrix, whose rank modulo p is at most that over ℚ, so dim N_D ≤ dim N(p)_D. Let G ⊂ ℤ[kept] be
/// homogeneous with the leading monomials of the reduced basis of N(p).
///
/// 1. G ⊂ N: each g(φ(X)) is zero modulo the primes' product M, since g is a multiple of an element of N(p)
///    modulo each, and M > 2·vanishing_bound(g).
/// 2. G is a Groebner basis of N, as in each degree the monomials that lm(G) generates are dim N(p)_D many,
///    and they lie in the leading ideal of N, which has dim N_D ≤ dim N(p)_D.
///
/// In codimension one, N is principal and the computation modulo p ends with the first element of N(p), of
/// some degree D. Then N(p), and so N, has nothing in lower degrees, and g ∈ N of degree D generates N.
///
/// A prime at which N(p) is larger than N gives other leading monomials (in codimension one: a lower degree);
/// such primes are put together apart, and can never pass step 1 as long as the right ones are among them.
///
/// \param known of this map, of codimension one: saves the first prime
Kernel kernel_by_primes(const GradedMap& map, Codimension codimension, base::Run& run,
                        const EliminationEffort* known = nullptr);

/// The kernel of any graded map, over ℚ: the elimination theorem as it stands.
Kernel kernel_over_rationals(const GradedMap& map, base::Run& run);

} // namespace eliminant::implicit
