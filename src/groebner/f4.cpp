#include "eliminant/groebner/f4.hpp"

#include "computation.hpp"
#include "macaulay_matrix.hpp"
#include "row_store.hpp"

#include <numeric>

namespace eliminant::groebner {

namespace {

using Element = std::uint32_t;

/// What a batch of pairs adds to the basis, and the size of the matrix that told.
struct Batch {
    std::vector<TermList<Element>> found; ///< descending by leading monomial
    std::size_t rows = 0;
    std::size_t columns = 0;
};

/// Builds the matrix of a batch of pairs and reduces it.
class BatchReducer {
  public:
    virtual ~BatchReducer() = default;
    virtual Batch reduce(std::span<const CriticalPair> pairs,
                         std::span<const BasisElement<Element>> generators) = 0;
};

template <std::size_t Words>
class StoreBatchReducer final : public BatchReducer {
  public:
    StoreBatchReducer(const algebra::PrimeField& field, const Basis<Element>& basis, base::Run& run)
        : field_(field), basis_(basis), layout_(basis.layout()), run_(run), store_(basis),
          multiplier_(layout_.words()) {}

    Batch reduce(std::span<const CriticalPair> pairs,
                 std::span<const BasisElement<Element>> generators) override {
        begin();
        add_rows(pairs, generators);
        add_pivots();
        return reduce_matrix();
    }

  private:
    using Store = RowStore<Element, Words>;
    using Index = typename Store::Index;

    /// A row to be reduced: a multiple of an element or generator.
    struct WantedRow {
        const BasisElement<Element>* element;
        std::size_t begin; ///< of its indices in wanted_indices_
    };
    struct PivotRow {
        Index lead;
        std::uint32_t element;
    };

    void begin() {
        if (store_.is_large() || ++round_ == 0) {
            store_.clear();
            seen_in_.clear();
            round_ = 1;
        }
        monomials_.clear();
        wanted_.clear();
        wanted_indices_.clear();
        pivots_.clear();
    }

    void want(const Word* multiplier, const BasisElement<Element>& f) {
        wanted_.push_back({&f, wanted_indices_.size()});
        store_.product(multiplier, f, wanted_indices_);
    }

    /// Both halves of each pair. Pairs with a common lcm share halves, and the half that is the lcm's own
    /// pivot is not wanted as a row as well.
    void add_rows(std::span<const CriticalPair> pairs, std::span<const BasisElement<Element>> generators) {
        std::vector<std::pair<Index, std::uint32_t>> halves;
        for (const CriticalPair& pair : pairs) {
            if (pair.first == CriticalPair::generator) {
                std::ranges::fill(multiplier_, Word{0});
                want(multiplier_.data(), generators[pair.second]);
                continue;
            }
            const Index lcm = store_.index_of(pair.lcm.data());
            for (const std::uint32_t half : {pair.first, pair.second}) {
                if (half != store_.reducer_of(lcm)) halves.emplace_back(lcm, half);
            }
        }
        std::ranges::sort(halves);
        halves.erase(std::unique(halves.begin(), halves.end()), halves.end());
        for (const auto& [lcm, half] : halves) {
            layout_.divide(store_.monomial(lcm), basis_.lead(half), multiplier_.data());
            want(multiplier_.data(), basis_[half]);
        }
    }

    void see(std::span<const Index> indices) {
        seen_in_.resize(store_.size(), 0);
        for (const Index index : indices) {
            if (seen_in_[index] == round_) continue;
            seen_in_[index] = round_;
            monomials_.push_back(index);
        }
    }

    /// Symbolic preprocessing: every monomial that some basis element divides gets that multiple as a pivot.
    void add_pivots() {
        see(wanted_indices_);
        for (std::size_t i = 0; i < monomials_.size(); ++i) {
            const Index index = monomials_[i];
            const std::uint32_t k = store_.reducer_of(index);
            if (k == Store::none) continue;
            if (i % 256 == 0) run_.poll();
            pivots_.push_back({index, k});
            see(store_.row(index, k));
        }
    }

    Batch reduce_matrix() {
        std::ranges::sort(monomials_, [this](Index a, Index b) {
            return layout_.compare(store_.monomial(a), store_.monomial(b)) > 0;
        });
        column_of_.resize(store_.size());
        for (std::size_t c = 0; c < monomials_.size(); ++c) column_of_[monomials_[c]] = static_cast<Index>(c);
        const auto to_columns = [this](std::span<const Index> indices,
                                       std::span<MacaulayMatrix::Column> columns) {
            std::ranges::transform(indices, columns.begin(), [this](Index i) { return column_of_[i]; });
        };
        MacaulayMatrix matrix(field_, monomials_.size());
        for (const PivotRow& pivot : pivots_) {
            to_columns(store_.row(pivot.lead, pivot.element),
                       matrix.add_pivot(basis_[pivot.element].terms.coefficients));
        }
        for (const WantedRow& row : wanted_) {
            const auto& coefficients = row.element->terms.coefficients;
            to_columns({wanted_indices_.data() + row.begin, coefficients.size()},
                       matrix.add_row(coefficients));
        }
        Batch batch;
        batch.rows = matrix.row_count();
        batch.columns = matrix.column_count();
        for (MacaulayMatrix::Row& row : matrix.echelon(run_)) {
            TermList<Element>& terms = batch.found.emplace_back(layout_);
            for (const MacaulayMatrix::Column c : row.columns) {
                const Word* m = store_.monomial(monomials_[c]);
                terms.monomials.insert(terms.monomials.end(), m, m + store_.words());
            }
            terms.coefficients = std::move(row.coefficients);
        }
        return batch;
    }

    algebra::PrimeField field_;
    const Basis<Element>& basis_;
    const MonomialLayout& layout_;
    base::Run& run_;
    Store store_;
    std::uint32_t round_ = 0;
    std::vector<std::uint32_t> seen_in_; ///< per index: the round in which it was last seen
    std::vector<Index> column_of_;       ///< per index, for those seen in this round
    std::vector<Index> monomials_;       ///< seen in this round: the columns
    std::vector<WantedRow> wanted_;
    std::vector<Index> wanted_indices_;
    std::vector<PivotRow> pivots_;
    std::vector<Word> multiplier_;
};

std::unique_ptr<BatchReducer> make_batch_reducer(const algebra::PrimeField& field,
                                                 const Basis<Element>& basis, base::Run& run) {
    switch (basis.layout().words()) {
    case 1:
        return std::make_unique<StoreBatchReducer<1>>(field, basis, run);
    case 2:
        return std::make_unique<StoreBatchReducer<2>>(field, basis, run);
    case 3:
        return std::make_unique<StoreBatchReducer<3>>(field, basis, run);
    default:
        return std::make_unique<StoreBatchReducer<0>>(field, basis, run);
    }
}

class F4Computation final : public Computation<algebra::PrimeDomain> {
  public:
    using Computation::Computation;

  private:
    void step() override {
        const std::vector<CriticalPair> pairs = queue_.best_batch();
        widening_if_needed([&] { treat_batch(pairs); });
    }

    void layout_changed() override {
        batch_reducer_.reset();
        Computation::layout_changed();
    }

    void treat_batch(const std::vector<CriticalPair>& pairs) {
        if (!batch_reducer_) batch_reducer_ = make_batch_reducer(domain_.field, basis_, run_);
        Batch batch = batch_reducer_->reduce(pairs, generators_);
        std::uint64_t sugar = 0;
        std::uint64_t treated = 0;
        for (const CriticalPair& pair : pairs) {
            const bool is_generator = pair.first == CriticalPair::generator;
            treated += is_generator ? 0 : 1;
            sugar = std::max(sugar, is_generator ? generators_[pair.second].sugar : pair.sugar);
        }
        queue_.remove_best(pairs.size());
        Statistics& statistics = result_.statistics;
        statistics.pairs_treated += treated;
        statistics.zero_reductions += treated - std::min<std::uint64_t>(treated, batch.found.size());
        ++statistics.matrices;
        if (batch.rows * batch.columns > statistics.largest_matrix_rows * statistics.largest_matrix_columns) {
            statistics.largest_matrix_rows = batch.rows;
            statistics.largest_matrix_columns = batch.columns;
        }
        // Descending: where one leading monomial divides another, the larger one comes first and is then
        // superseded, as the criteria expect.
        for (TermList<Element>& terms : batch.found) {
            if (!stopped_) insert(widened(std::move(terms), *layout_), sugar);
        }
    }

    std::unique_ptr<BatchReducer> batch_reducer_;
};

} // namespace

GroebnerBasis f4(const algebra::Ring& ring, std::span<const algebra::Polynomial> generators,
                 const BuchbergerOptions& options, base::Run& run) {
    if (ring.field().is_rationals())
        throw DomainError("F4 works over GF(p), the ring is " + ring.to_string());
    check_grading(ring, options);
    return F4Computation(algebra::PrimeDomain{ring.field().prime_field()}, ring, generators, options, run,
                         true)
        .run();
}

} // namespace eliminant::groebner
