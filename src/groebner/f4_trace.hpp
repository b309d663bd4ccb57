#pragma once

#include "f4_round.hpp"
#include "lane_kernels.hpp"
#include "monomial_ideal.hpp"

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/groebner/buchberger.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// How the computation modulo another prime compared with the one that was learned.
enum class Replay : unsigned char {
    agrees,
    input_vanishes,  ///< the prime divides a coefficient of the input: not tried
    leads_differ,    ///< some matrix had another rank or another leading monomial
    support_differs, ///< a monomial occurred that did not occur modulo the learned prime
};

/// An F4 computation over GF(p) that was recorded so that it can be repeated modulo other primes without what
/// is not linear algebra: no pairs, no monomials, and only those rows that gave something new (Traverso,
/// ISSAC 1988; for F4 Joux and Vitse, CT-RSA 2011; Berthomieu, Eder, Safey El Din, ISSAC 2021).
///
/// An image that `agrees` is, coefficient by coefficient, what the recorded sequence of row operations gives
/// modulo its prime; every element is in the ideal of the generators modulo that prime. That the elements are
/// all of the Groebner basis there is *not* checked (rows that reduced to zero modulo the learned prime are
/// not looked at again): it holds for all but finitely many primes if the learned prime was not one of the
/// finitely many unlucky ones. Whoever lifts the images has to verify.
///
/// If the learned prime was unlucky, or had a coefficient vanish by accident, almost all other primes will
/// not agree: learn again with another one.
class F4Trace {
  public:
    /// What an image holds.
    enum class Extent : unsigned char {
        basis,    ///< the reduced basis
        elements, ///< the distinct elements found by all matrices, in the sequence of the rounds
    };

    struct Image {
        std::uint32_t prime = 0;
        Replay replay = Replay::input_vanishes;
        /// If it agrees: residues in [0, p) for all terms of basis() in sequence, or of all elements, leading
        /// ones (= 1) included. Any other may be 0.
        std::vector<std::uint32_t> coefficients;
    };

    /// Computes the reduced basis modulo a prime of generators over ℚ (primitive parts are taken) with
    /// the options of buchberger(), which do not stop it early. Nothing if the prime divides a coefficient.
    /// `hilbert_numerator`, of the ideal over ℚ, as for F4Computation; modulo a prime an ideal has at most as
    /// many elements of each degree. Throws DomainError if p is not a prime below 2^31, or if a bound or a
    /// condition to stop is set.
    static std::optional<F4Trace> learn(const algebra::Ring& ring,
                                        std::span<const algebra::Polynomial> generators, std::uint64_t p,
                                        const BuchbergerOptions& options, base::Run& run,
                                        const SparseSeries* hilbert_numerator = nullptr);

    std::uint32_t prime() const { return ring_.field().characteristic(); }
    /// The ring over GF(prime()).
    const algebra::Ring& ring() const { return ring_; }
    /// The reduced basis modulo prime(), ascending by leading monomial, and the statistics of its
    /// computation. Its monomials are the support of all images.
    const GroebnerBasis& basis() const { return basis_; }
    /// Number of terms of the basis.
    std::size_t coefficient_count() const { return coefficient_count_; }
    /// Memory held, roughly, in bytes.
    std::size_t size_in_bytes() const;

    /// The images modulo primes below 2^31, in their sequence. Eight primes take little longer than one
    /// (see lane_kernels.hpp), so give as many as there is use for; packs of eight, and the rows of each
    /// matrix, are shared out over the threads of the run. Any number of calls may run at the same time.
    /// Polls `run`.
    std::vector<Image> replay(std::span<const std::uint32_t> primes, base::Run& run,
                              Extent extent = Extent::basis) const;

    /// Of replay(): at most eight primes, by the kernels given.
    std::vector<Image> replay_pack(std::span<const std::uint32_t> primes, const LaneKernels& kernels,
                                   base::Run& run, Extent extent = Extent::basis) const;

    /// The recorded matrices; the last one reduces the tails of the minimal basis, descending.
    const std::vector<F4Round>& rounds() const { return rounds_; }
    /// For each element found, in sequence: its number among the distinct ones. What the last matrix finds is
    /// mostly what was there before, term by term: a *copy*.
    std::span<const std::uint32_t> element_numbers() const { return element_numbers_; }
    bool is_copy(std::size_t found) const { return copies_[found]; }
    /// Of each distinct element the number of its terms.
    std::span<const std::size_t> element_sizes() const { return element_sizes_; }
    /// Integer coefficients of the generators, without those that are 0.
    const std::vector<std::vector<algebra::Integer>>& generators() const { return generators_; }

  private:
    explicit F4Trace(algebra::Ring ring) : ring_(std::move(ring)) {}

    void number_elements();
    std::optional<std::uint32_t> copied_element(const F4Round& round, std::size_t row,
                                                std::span<const std::uint32_t> support) const;

    algebra::Ring ring_;
    std::vector<std::vector<algebra::Integer>> generators_;
    GroebnerBasis basis_;
    std::size_t coefficient_count_ = 0;
    std::vector<F4Round> rounds_;
    std::vector<std::uint32_t> element_numbers_;
    std::vector<bool> copies_;
    std::vector<std::size_t> element_sizes_;
};

} // namespace eliminant::groebner
