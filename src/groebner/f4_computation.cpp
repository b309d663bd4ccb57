#include "f4_computation.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::groebner {

F4Computation::F4Computation(const algebra::Ring& ring, std::span<const algebra::Polynomial> generators,
                             const BuchbergerOptions& options, base::Run& run, std::vector<F4Round>* rounds,
                             const SparseSeries* hilbert_numerator, bool rechecks)
    : Computation(algebra::PrimeDomain{ring.field().prime_field()}, ring, generators, options, run, true),
      rounds_(rounds), hilbert_numerator_(hilbert_numerator), rechecks_(rechecks) {
    if (rechecks_) queue_.advance_generators(*layout_);
}

void F4Computation::step() {
    const std::vector<CriticalPair> pairs = queue_.best_batch();
    const std::optional<std::size_t> rank = missing_leads(pairs.back().sugar);
    if (rank == 0U) return queue_.remove_best(pairs.size());
    widening_if_needed([&] { treat_batch(pairs, rank); });
}

/// How many leading monomials of this degree are still to be found, if that is known. With all of lower
/// degree there, the series of those found and the known one agree up to the least degree in which some are
/// missing, where they differ by their number; and so do the numerators.
std::optional<std::size_t> F4Computation::missing_leads(std::uint64_t degree) {
    if (hilbert_numerator_ == nullptr) return std::nullopt;
    if (!missing_) {
        std::vector<Exponents> leads;
        for (std::size_t i = 0; i < basis_.size(); ++i) {
            if (basis_[i].redundant) continue;
            layout_->decode(basis_.lead(i), leads.emplace_back(ring_.variable_count()));
        }
        const auto difference =
            lowest_difference(hilbert_numerator(std::move(leads), run_), *hilbert_numerator_);
        missing_.emplace(~std::uint64_t{0}, 0);
        if (difference && difference->second.sign() > 0 && difference->second.is_small())
            missing_.emplace(difference->first, static_cast<std::size_t>(difference->second.small_value()));
        else if (difference)
            hilbert_numerator_ = nullptr; // it is not that of this ideal
    }
    if (missing_->first < degree) hilbert_numerator_ = nullptr; // a smaller ideal than was thought
    if (hilbert_numerator_ == nullptr) return std::nullopt;
    return missing_->first == degree ? missing_->second : 0;
}

void F4Computation::layout_changed() {
    batch_reducer_.reset();
    Computation::layout_changed();
}

BatchReducer& F4Computation::batch_reducer() {
    if (!batch_reducer_)
        batch_reducer_ = make_batch_reducer(domain_.field, basis_, grading_, generators_.size(),
                                            options_.linear_algebra, run_);
    return *batch_reducer_;
}

std::uint64_t F4Computation::degree_of(const TermList<Element>& terms) const {
    std::uint64_t degree = 0;
    for (std::size_t i = 0; i < terms.size(); ++i)
        degree = std::max(degree, grading_.degree(*terms.layout, terms.monomial(i)));
    return degree;
}

void F4Computation::treat_batch(const std::vector<CriticalPair>& pairs, std::optional<std::size_t> rank) {
    std::uint64_t sugar = 0;
    std::uint64_t treated = 0;
    for (const CriticalPair& pair : pairs) {
        const bool is_generator = pair.first == CriticalPair::generator;
        treated += is_generator ? 0 : 1;
        sugar = std::max(sugar, is_generator ? generators_[pair.second].sugar : pair.sugar);
    }
    // Where monomials of high degree can be small (lex, elimination), reducing by all elements in all terms
    // would raise degrees without bound: cyclic-5 in lex makes matrices of 100,000 rows out of 5. So
    // reductions that raise the degree by more than half are put off: the element that was not reduced is
    // then redundant when it is found, and its pair with what reduces it waits. Graded orders never get
    // there.
    constexpr std::uint64_t no_limit = ~std::uint64_t{0};
    const std::uint64_t degree_limit = options_.selection == Selection::sugar ? sugar + sugar / 2 : no_limit;
    F4Round record;
    record.keeps_zero_rows = rechecks_;
    Batch batch = batch_reducer().reduce(pairs, generators_, degree_limit, rank, rounds_ ? &record : nullptr);
    if (rounds_) rounds_->push_back(std::move(record));
    queue_.remove_best(pairs.size());
    if (batch.failure_bound > 0) result_.proof = Proof::bounded;
    result_.failure_bound += batch.failure_bound;
    Statistics& statistics = result_.statistics;
    statistics.pairs_treated += treated;
    const std::uint64_t zero_reductions = treated - std::min<std::uint64_t>(treated, batch.found.size());
    statistics.zero_reductions += zero_reductions;
    statistics.matrices.push_back(
        {sugar, pairs.size(), batch.rows, batch.columns, batch.entries, batch.found.size(), zero_reductions});
    if (!batch.found.empty()) missing_.reset();
    // Descending: where one leading monomial divides another, the larger one comes first and is then
    // superseded, as the criteria expect.
    for (TermList<Element>& terms : batch.found) {
        run_.poll();
        const std::uint64_t degree = degree_of(terms);
        if (!stopped_) insert(widened(std::move(terms), *layout_), degree);
    }
}

void F4Computation::reduce_tails(std::span<const std::size_t> minimal) {
    if (minimal.empty()) return;
    F4Round record;
    Batch batch;
    while (!widening_if_needed(
        [&] { batch = batch_reducer().reduce_tails(minimal, rounds_ ? &record : nullptr); })) {
    }
    if (rounds_) rounds_->push_back(std::move(record));
    batch_reducer_.reset(); // it was the last matrix: its memory is of use for the result
    // Found in descending sequence, one for each.
    for (std::size_t i = 0; i < minimal.size(); ++i)
        basis_.replace(minimal[minimal.size() - 1 - i], std::move(batch.found[i]), 0);
}

} // namespace eliminant::groebner
