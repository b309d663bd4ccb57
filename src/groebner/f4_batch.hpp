#pragma once

#include "f4_round.hpp"
#include "pair_queue.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// What a matrix adds to the basis, and its size.
struct Batch {
    std::vector<TermList<std::uint32_t>> found; ///< monic, descending by leading monomial
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::size_t entries = 0;  ///< that are not 0
    double failure_bound = 0; ///< probability that something is missing is at most this
};

/// Builds and reduces the matrices of F4 over the present layout of the basis. Methods throw LayoutTooNarrow
/// where a product does not fit, Stopped when the run is stopped, and may be called again after either.
/// `record`, if not null, is filled in, and the linear algebra is then exact.
class BatchReducer {
  public:
    using Element = std::uint32_t;

    virtual ~BatchReducer() = default;
    /// The S-polynomials of the pairs and the generators among them, reduced by the basis and one another,
    /// but only by multiples whose sugar is at most `limit`. `rank` is how many will be found, if known.
    virtual Batch reduce(std::span<const CriticalPair> pairs,
                         std::span<const BasisElement<Element>> generators, std::uint64_t limit,
                         std::optional<std::size_t> rank, F4Round* record) = 0;
    /// The elements of a minimal basis, their tails reduced by one another.
    virtual Batch reduce_tails(std::span<const std::size_t> minimal, F4Round* record) = 0;
};

/// Specialised for the number of words of a monomial. It refers to all arguments but the field.
/// `generator_count` is the number of the first basis element among the operands of F4Round.
std::unique_ptr<BatchReducer> make_batch_reducer(const algebra::PrimeField& field,
                                                 const Basis<std::uint32_t>& basis, const Grading& grading,
                                                 std::size_t generator_count, LinearAlgebra linear_algebra,
                                                 base::Run& run);

} // namespace eliminant::groebner
