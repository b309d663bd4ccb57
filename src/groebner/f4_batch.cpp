#include "f4_batch.hpp"

#include "macaulay_matrix.hpp"
#include "row_store.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::groebner {

namespace {

using Element = BatchReducer::Element;

template <std::size_t Words>
class StoreBatchReducer final : public BatchReducer {
  public:
    StoreBatchReducer(const algebra::PrimeField& field, const Basis<Element>& basis, const Grading& grading,
                      std::size_t generator_count, LinearAlgebra linear_algebra, base::Run& run)
        : field_(field), basis_(basis), grading_(grading), layout_(basis.layout()),
          generator_count_(generator_count),
          combine_(linear_algebra == LinearAlgebra::probabilistic && MacaulayMatrix::can_combine(field)),
          run_(run), store_(basis), multiplier_(layout_.words()) {}

    Batch reduce(std::span<const CriticalPair> pairs, std::span<const BasisElement<Element>> generators,
                 std::uint64_t limit, std::optional<std::size_t> rank, F4Round* record) override {
        begin();
        add_halves(pairs, generators);
        add_pivots(limit);
        return reduce_matrix(rank, record);
    }

    Batch reduce_tails(std::span<const std::size_t> minimal, F4Round* record) override {
        begin();
        std::ranges::fill(multiplier_, Word{0});
        for (const std::size_t i : minimal) want(multiplier_.data(), basis_[i], operand(i));
        for (const WantedRow& row : wanted_) see({wanted_indices_.data() + row.begin, 1});
        heads_ = monomials_.size(); // they stay what they are
        add_pivots(~std::uint64_t{0});
        return reduce_matrix(std::nullopt, record);
    }

  private:
    using Store = RowStore<Element, Words>;
    using Index = typename Store::Index;

    /// A row to be reduced: a multiple of an element or generator.
    struct WantedRow {
        const BasisElement<Element>* element;
        std::uint32_t operand;
        std::size_t begin; ///< of its indices in wanted_indices_
    };
    struct PivotRow {
        Index lead;
        std::uint32_t element;
    };

    std::uint32_t operand(std::size_t element) const {
        return static_cast<std::uint32_t>(generator_count_ + element);
    }

    void begin() {
        if (store_.rows_size() > std::max(rows_limit, 4 * last_entries_)) store_.forget_rows();
        if (store_.is_large() || ++round_ == 0) {
            store_.clear();
            seen_in_.clear();
            round_ = 1;
        }
        monomials_.clear();
        heads_ = 0;
        wanted_.clear();
        wanted_indices_.clear();
        pivots_.clear();
    }

    void want(const Word* multiplier, const BasisElement<Element>& f, std::uint32_t number) {
        run_.poll();
        wanted_.push_back({&f, number, wanted_indices_.size()});
        store_.product(multiplier, f, wanted_indices_);
    }

    /// Both halves of each pair. Pairs with a common lcm share halves, and the half that is the lcm's own
    /// pivot is not wanted as a row as well.
    void add_halves(std::span<const CriticalPair> pairs, std::span<const BasisElement<Element>> generators) {
        std::vector<std::pair<Index, std::uint32_t>> halves;
        for (const CriticalPair& pair : pairs) {
            if (pair.first == CriticalPair::generator) {
                std::ranges::fill(multiplier_, Word{0});
                want(multiplier_.data(), generators[pair.second], pair.second);
                continue;
            }
            const Index lcm = store_.index_of(pair.lcm.data());
            for (const std::uint32_t half : {pair.first, pair.second}) {
                if (half != store_.reducer_of(lcm)) halves.emplace_back(lcm, half);
            }
        }
        // Descending: neighbours have much the same pivots, and are reduced together.
        std::ranges::sort(halves, [this](const auto& a, const auto& b) {
            if (a.first != b.first)
                return layout_.compare(store_.monomial(a.first), store_.monomial(b.first)) > 0;
            return a.second < b.second;
        });
        halves.erase(std::unique(halves.begin(), halves.end()), halves.end());
        for (const auto& [lcm, half] : halves) {
            layout_.divide(store_.monomial(lcm), basis_.lead(half), multiplier_.data());
            want(multiplier_.data(), basis_[half], operand(half));
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

    /// Symbolic preprocessing: every monomial that some basis element divides gets that multiple as a pivot,
    /// unless its sugar is too high.
    void add_pivots(std::uint64_t limit) {
        see(wanted_indices_);
        for (std::size_t i = heads_; i < monomials_.size(); ++i) {
            const Index index = monomials_[i];
            const std::uint32_t k = store_.reducer_of(index);
            if (k == Store::none) continue;
            if (grading_.degree(layout_, store_.monomial(index)) + basis_[k].excess > limit) continue;
            run_.poll();
            pivots_.push_back({index, k});
            see(store_.row(index, k));
        }
    }

    Batch reduce_matrix(std::optional<std::size_t> rank, F4Round* record) {
        std::ranges::sort(monomials_, [this](Index a, Index b) {
            run_.poll(); // a million columns take a second
            return layout_.compare(store_.monomial(a), store_.monomial(b)) > 0;
        });
        column_of_.resize(store_.size());
        for (std::size_t c = 0; c < monomials_.size(); ++c) column_of_[monomials_[c]] = static_cast<Index>(c);
        // Indices become columns: in place for the rows wanted, in a copy for pivots, whose rows are kept.
        to_columns(wanted_indices_, wanted_indices_);
        std::size_t entries = 0;
        for (const PivotRow& pivot : pivots_) entries += basis_[pivot.element].terms.size();
        pivot_columns_.resize(entries);
        last_entries_ = entries + wanted_indices_.size();
        MacaulayMatrix matrix(field_, monomials_.size());
        std::size_t begin = 0;
        for (const PivotRow& pivot : pivots_) {
            run_.poll();
            const std::span<const Index> indices = store_.row(pivot.lead, pivot.element);
            Index* columns = pivot_columns_.data() + begin;
            to_columns(indices, {columns, indices.size()});
            matrix.add_pivot({columns, basis_[pivot.element].terms.coefficients.data(), indices.size()});
            begin += indices.size();
        }
        for (const WantedRow& row : wanted_) {
            const auto& coefficients = row.element->terms.coefficients;
            matrix.add_row({wanted_indices_.data() + row.begin, coefficients.data(), coefficients.size()});
        }
        MacaulayMatrix::Transcript transcript;
        transcript.keeps_zero_rows = record && record->keeps_zero_rows;
        MacaulayMatrix::EchelonOptions options;
        if (record)
            options.transcript = &transcript;
        else
            options.combine = combine_;
        options.rank = rank;
        options.seed = run_.seed() + round_;
        auto [found, failure_bound] = matrix.echelon(options, run_);
        if (record) *record = recorded(transcript, found);
        Batch batch;
        batch.failure_bound = failure_bound;
        batch.entries = matrix.entry_count();
        batch.rows = matrix.row_count();
        batch.columns = matrix.column_count();
        batch.found.reserve(found.size());
        for (MacaulayMatrix::Row& row : found) {
            run_.poll();
            batch.found.push_back(terms_of(std::exchange(row, {})));
        }
        return batch;
    }

    void to_columns(std::span<const Index> indices, std::span<MacaulayMatrix::Column> columns) const {
        std::ranges::transform(indices, columns.begin(), [this](Index i) { return column_of_[i]; });
    }

    TermList<Element> terms_of(MacaulayMatrix::Row row) const {
        TermList<Element> terms(layout_);
        terms.monomials.resize(row.columns.size() * store_.words());
        for (std::size_t i = 0; i < row.columns.size(); ++i)
            std::copy_n(store_.monomial(monomials_[row.columns[i]]), store_.words(), terms.monomial(i));
        terms.coefficients = std::move(row.coefficients);
        return terms;
    }

    F4Round recorded(const MacaulayMatrix::Transcript& transcript,
                     std::span<const MacaulayMatrix::Row> found) {
        F4Round round;
        const auto append = [&](std::vector<F4Round::Row>& rows, std::uint32_t operand_number,
                                std::span<const MacaulayMatrix::Column> columns) {
            rows.push_back({operand_number, round.columns_of_rows.size()});
            round.columns_of_rows.insert(round.columns_of_rows.end(), columns.begin(), columns.end());
        };
        std::size_t begin = 0;
        for (const PivotRow& pivot : pivots_) {
            const std::size_t size = basis_[pivot.element].terms.size();
            const std::span columns(pivot_columns_.data() + begin, size);
            if (transcript.pivots[columns[0]]) append(round.pivots, operand(pivot.element), columns);
            begin += size;
        }
        const auto append_wanted = [&](std::vector<F4Round::Row>& rows, std::size_t i) {
            const WantedRow& row = wanted_[i];
            append(rows, row.operand, {wanted_indices_.data() + row.begin, row.element->terms.size()});
        };
        for (const std::size_t i : transcript.rows) append_wanted(round.rows, i);
        for (const std::size_t i : transcript.zero_rows) append_wanted(round.zero_rows, i);
        round.keeps_zero_rows = transcript.keeps_zero_rows;
        for (const MacaulayMatrix::Row& row : found) {
            round.support.insert(round.support.end(), row.columns.begin(), row.columns.end());
            round.found.push_back(round.support.size());
        }
        round.leads = transcript.leads;
        drop_untouched_columns(round);
        return round;
    }

    void drop_untouched_columns(F4Round& round) const {
        std::vector<std::uint32_t> renumbered(monomials_.size(), 0);
        for (const std::uint32_t column : round.columns_of_rows) renumbered[column] = 1;
        std::uint32_t count = 0;
        for (std::uint32_t& column : renumbered) column = std::exchange(count, count + column);
        for (std::uint32_t& column : round.columns_of_rows) column = renumbered[column];
        for (std::uint32_t& column : round.leads) column = renumbered[column];
        for (std::uint32_t& column : round.support) column = renumbered[column];
        round.column_count = count;
    }

    /// Indices in stored rows that are not many. Beyond, they are forgotten when most belong to matrices of
    /// the past: cyclic-8 makes 60 small matrices and would keep twice the memory that it needs.
    static constexpr std::size_t rows_limit = std::size_t{1} << 20;

    algebra::PrimeField field_;
    const Basis<Element>& basis_;
    const Grading& grading_;
    const MonomialLayout& layout_;
    std::size_t generator_count_;
    bool combine_; ///< random combinations of rows
    base::Run& run_;
    Store store_;
    std::uint32_t round_ = 0;
    std::vector<std::uint32_t> seen_in_; ///< per index: the round in which it was last seen
    std::vector<Index> column_of_;       ///< per index, for those seen in this round
    std::vector<Index> monomials_;       ///< seen in this round: the columns
    std::size_t heads_ = 0;              ///< so many of them, the first, are not to be reduced
    std::vector<WantedRow> wanted_;
    std::vector<Index> wanted_indices_; ///< columns, once those are numbered
    std::vector<PivotRow> pivots_;
    std::vector<Index> pivot_columns_;
    std::size_t last_entries_ = 0; ///< of the last matrix
    std::vector<Word> multiplier_;
};

} // namespace

std::unique_ptr<BatchReducer> make_batch_reducer(const algebra::PrimeField& field,
                                                 const Basis<Element>& basis, const Grading& grading,
                                                 std::size_t generator_count, LinearAlgebra linear_algebra,
                                                 base::Run& run) {
    switch (basis.layout().words()) {
    case 1:
        return std::make_unique<StoreBatchReducer<1>>(field, basis, grading, generator_count, linear_algebra,
                                                      run);
    case 2:
        return std::make_unique<StoreBatchReducer<2>>(field, basis, grading, generator_count, linear_algebra,
                                                      run);
    case 3:
        return std::make_unique<StoreBatchReducer<3>>(field, basis, grading, generator_count, linear_algebra,
                                                      run);
    default:
        return std::make_unique<StoreBatchReducer<0>>(field, basis, grading, generator_count, linear_algebra,
                                                      run);
    }
}

} // namespace eliminant::groebner
