#pragma once

#include "computation.hpp"
#include "f4_batch.hpp"
#include "monomial_ideal.hpp"

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace eliminant::groebner {

/// One run of F4: batches of pairs where Buchberger's algorithm treats single ones. Its sugar is the largest
/// degree of a term, not a bound that is handed down: so with graded orders it is the degree.
class F4Computation final : public Computation<algebra::PrimeDomain> {
  public:
    /// The ring is over GF(p). Appends each matrix to `rounds`, unless it is null; the last one reduces the
    /// tails of the minimal basis. If it `rechecks` a basis, the generators are taken all at once before any
    /// pair, and all rows of the matrices are kept: see F4Round::zero_rows.
    ///
    /// \param hilbert_numerator for homogeneous generators, N(t) where N(t)/(1 − t)ⁿ is the Hilbert series of
    ///   their ideal or one that is nowhere larger, if known. It tells how many leading monomials of each
    ///   degree there are at most: once they are found, the pairs that remain in that degree reduce to zero
    ///   and are passed over (Traverso, J. Symb. Comp. 22 (1996)).
    F4Computation(const algebra::Ring& ring, std::span<const algebra::Polynomial> generators,
                  const BuchbergerOptions& options, base::Run& run, std::vector<F4Round>* rounds,
                  const SparseSeries* hilbert_numerator = nullptr, bool rechecks = false);

  private:
    std::string_view name() const override { return "F4"; }
    void step() override;
    void layout_changed() override;
    void reduce_tails(std::span<const std::size_t> minimal) override;

    BatchReducer& batch_reducer();
    std::uint64_t degree_of(const TermList<Element>& terms) const;
    void treat_batch(const std::vector<CriticalPair>& pairs, std::optional<std::size_t> rank);
    std::optional<std::size_t> missing_leads(std::uint64_t degree);

    std::vector<F4Round>* rounds_;
    const SparseSeries* hilbert_numerator_;
    bool rechecks_;
    /// The least degree in which leading monomials are missing, and how many; that of no degree if none is.
    std::optional<std::pair<std::uint64_t, std::size_t>> missing_; ///< nothing if elements came since
    std::unique_ptr<BatchReducer> batch_reducer_;
};

} // namespace eliminant::groebner
