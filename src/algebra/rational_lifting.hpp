// Vectors of rationals from their images modulo many primes.
#pragma once

#include "eliminant/algebra/integer.hpp"
#include "eliminant/base/run.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace eliminant::algebra {

class RemainderTable;

/// Vectors of rationals, each over its common denominator, that are known by their residues modulo more and
/// more primes: the coefficients of the polynomials of a basis, say.
///
/// Residues are only stored as they come. lift() looks at one entry at first, the one that needed more primes
/// the last time; only if that is found, at those after it. An entry once found is kept. So a prime that
/// is not enough costs one reconstruction, and enough primes cost about one a vector: that of the
/// denominator. With it all other entries are integers of half the length, for which part of the primes is
/// enough and no reconstruction is needed.
///
///     residues[prime]   | vector 0: r₀ r₁ … | vector 1: r₀ … | …        rᵢ ≡ nᵢ/d
class RationalLifting {
  public:
    struct Vector {
        Integer denominator = Integer(1); ///< positive; its gcd with all numerators is 1
        std::vector<Integer> numerators;
    };

    /// \param sizes of the vectors
    explicit RationalLifting(const std::vector<std::size_t>& sizes);
    ~RationalLifting();
    RationalLifting(RationalLifting&&) noexcept;
    RationalLifting& operator=(RationalLifting&&) noexcept;

    /// Sum of the sizes.
    std::size_t entry_count() const { return begins_.back(); }
    std::size_t prime_count() const { return primes_.size(); }
    /// The primes in the sequence in which they were added.
    std::span<const std::uint32_t> primes() const { return primes_; }

    /// Adds the residues of all entries modulo an odd prime below 2^31 that is new.
    void add(std::uint32_t prime, std::vector<std::uint32_t> residues);

    /// Whether vectors are found whose entries are so small beside the product of the primes that chance
    /// would hardly make them so (by a factor of 2^40 for each entry). That they agree with primes which were
    /// added after they were found is not checked: see agrees(). With the same primes added, the same answer
    /// for every number of threads.
    bool lift(base::Run& run);

    /// The same anew, with all primes for each entry: what is found has the residues that were added, all of
    /// them.
    bool lift_with_all_primes(base::Run& run);

    /// What was found; only after lift() returned true.
    const std::vector<Vector>& vectors() const { return vectors_; }
    /// The same; the residues go too.
    std::vector<Vector> take_vectors();

    /// Whether the vectors found have these residues; if not, those that differ are dropped, and lift()
    /// begins them again. \param run its threads are used
    bool agrees(std::uint32_t prime, std::span<const std::uint32_t> residues, base::Run& run);
    /// The same for a prime that was added.
    bool agrees_with_added(std::size_t index, base::Run& run);

  private:
    class Worker;

    bool is_found(std::size_t g) const { return vectors_[g].numerators.size() == size(g); }
    std::size_t size(std::size_t g) const { return begins_[g + 1] - begins_[g]; }
    void extend_tables(base::Run& run);

    std::vector<std::size_t> begins_; ///< of the vectors among all entries, and their end
    std::vector<std::uint32_t> primes_;
    std::vector<std::vector<std::uint32_t>> residues_; ///< per prime
    std::vector<Vector> vectors_;                      ///< as far as found: a prefix of each
    /// Per vector, whether part of the primes misled: coefficients may be made of the first primes.
    std::vector<char> needs_all_primes_;
    std::size_t hardest_ = 0; ///< the vector that is looked at first
    /// For more and more of the first primes; the last one for all of them.
    std::vector<std::unique_ptr<const RemainderTable>> tables_;
};

} // namespace eliminant::algebra
