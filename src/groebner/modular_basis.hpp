// Bases over ℚ by F4 modulo many primes.
#pragma once

#include "f4_trace.hpp"
#include "prime_sequence.hpp"

#include "algebra/rational_lifting.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// A basis over ℚ that its images modulo primes determine, without a proof that it is the right one: F4 is
/// learned modulo one prime and replayed modulo others, eight at a time (F4Trace), until the coefficients are
/// found as fractions (algebra::RationalLifting).
///
/// Bad primes. One that divides a coefficient of the input is skipped. One modulo which other leading
/// monomials, or other monomials, come out than were learned does not count. If most do not agree with what
/// was learned, or one has monomials that were not, the learned prime is the suspect: the same primes are
/// tried with what another prime teaches. A learned prime modulo which an S-polynomial vanishes by accident
/// can go unnoticed here, as the replays leave that S-polynomial out; see find().
class ModularBasis {
  public:
    /// \param ring over ℚ
    /// \param generators of the ring
    /// \param options of F4
    /// \param primes from here on
    /// \param run kept as a reference
    /// \param lifted whether all elements of the computation are lifted, or those of the basis only; asked
    ///   for each computation that is learned, if it is a function
    /// \param hilbert_numerator as for F4Trace::learn()
    ModularBasis(const algebra::Ring& ring, std::span<const algebra::Polynomial> generators,
                 const BuchbergerOptions& options, PrimeSequence primes, base::Run& run,
                 std::function<F4Trace::Extent(const F4Trace&)> lifted,
                 const SparseSeries* hilbert_numerator = nullptr);
    ModularBasis(const algebra::Ring& ring, std::span<const algebra::Polynomial> generators,
                 const BuchbergerOptions& options, PrimeSequence primes, base::Run& run,
                 F4Trace::Extent lifted = F4Trace::Extent::basis);

    /// The basis that passes this test: its residues are those of the replay modulo one more prime, and
    /// modulo that prime the generators reduce to zero by it. No theorem bounds the probability that it is
    /// wrong.
    std::vector<algebra::Polynomial> find();

    /// The F4 computation that was repeated; after find().
    const F4Trace& trace() const { return attempt_->trace; }
    /// What was lifted; after find().
    F4Trace::Extent extent() const { return attempt_->extent; }
    /// With Extent::elements, the distinct elements of the trace, in its sequence; after find().
    const std::vector<algebra::RationalLifting::Vector>& lifted_elements() const {
        return attempt_->lifting.vectors();
    }
    /// The same; what they were lifted from goes too.
    std::vector<algebra::RationalLifting::Vector> take_elements() { return attempt_->lifting.take_vectors(); }
    PrimeSequence& primes() { return primes_; }
    /// The number of primes whose images were made, those of bad ones too.
    std::size_t primes_used() const { return primes_used_; }

  private:
    using Images = std::vector<F4Trace::Image>;

    struct Attempt {
        Attempt(F4Trace learned, F4Trace::Extent lifted);
        F4Trace trace;
        F4Trace::Extent extent;
        algebra::RationalLifting lifting;
    };

    void begin();
    Attempt learn();
    void add_batch();
    bool agrees_with_witness();
    bool generators_reduce_to_zero() const;
    std::vector<algebra::Polynomial> image_of_basis(const F4Trace::Image& image,
                                                    const algebra::Ring& image_ring) const;
    std::size_t vector_of(std::size_t element) const;
    std::vector<algebra::Polynomial> polynomials() const;

    algebra::Ring ring_;
    std::vector<algebra::Polynomial> generators_;
    BuchbergerOptions options_;
    PrimeSequence primes_;
    base::Run& run_;
    std::function<F4Trace::Extent(const F4Trace&)> extent_;
    const SparseSeries* hilbert_numerator_;
    std::optional<Attempt> attempt_;
    std::optional<F4Trace::Image> witness_; ///< the image of the prime that is kept for the test
    std::size_t primes_used_ = 0;
};

} // namespace eliminant::groebner
