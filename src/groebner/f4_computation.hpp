#pragma once

#include "computation.hpp"
#include "f4_batch.hpp"

#include <memory>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// One run of F4: batches of pairs where Buchberger's algorithm treats single ones. Its sugar is the largest
/// degree of a term, not a bound that is handed down: so with graded orders it is the degree.
class F4Computation final : public Computation<algebra::PrimeDomain> {
  public:
    /// The ring is over GF(p). Appends each matrix to `rounds`, unless it is null; the last one reduces the
    /// tails of the minimal basis.
    F4Computation(const algebra::Ring& ring, std::span<const algebra::Polynomial> generators,
                  const BuchbergerOptions& options, base::Run& run, std::vector<F4Round>* rounds);

  private:
    std::string_view name() const override { return "F4"; }
    void step() override;
    void layout_changed() override;
    void reduce_tails(std::span<const std::size_t> minimal) override;

    BatchReducer& batch_reducer();
    std::uint64_t degree_of(const TermList<Element>& terms) const;
    void treat_batch(const std::vector<CriticalPair>& pairs);

    std::vector<F4Round>* rounds_;
    std::unique_ptr<BatchReducer> batch_reducer_;
};

} // namespace eliminant::groebner
