#include "reducer.hpp"

#include "row_store.hpp"
#include "row_sums.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::groebner {

namespace {

/// Reduction with a table of monomials and a heap of those that are pending.
///
/// A row q·m·g costs one table look-up a term; the heap holds each distinct monomial once, so its logarithm
/// is paid per distinct monomial and not per term. The greatest pending monomial is taken, its value
/// collected, and either a row that cancels it is added or it becomes a term of the result. Roune and
/// Stillman (2012) compare this with geobuckets and plain heaps.
template <class Domain, std::size_t Words>
class TableReducer final : public Reducer<Domain> {
  public:
    using Element = typename Domain::Element;

    TableReducer(const Domain& domain, const Basis<Element>& basis, const Grading& grading, base::Run& run)
        : domain_(domain), basis_(basis), layout_(basis.layout()), grading_(grading), run_(run),
          store_(basis), sums_(domain, run), multiplier_(layout_.words()) {}

    Reduction<Element> s_polynomial(std::size_t i, std::size_t j, const Word* lcm) override {
        begin();
        // (lcm/lt gᵢ)·gᵢ − (lcm/lt gⱼ)·gⱼ up to a factor; the leading terms cancel and are left out.
        const BasisElement<Element>& f = basis_[i];
        const BasisElement<Element>& g = basis_[j];
        const auto [cf, cg] = cofactors(f.terms.coefficients.front(), g.terms.coefficients.front());
        layout_.divide(lcm, basis_.lead(i), multiplier_.data());
        add_multiple(f, cf, 1);
        layout_.divide(lcm, basis_.lead(j), multiplier_.data());
        add_multiple(g, cg, 1);
        return reduce(TermList<Element>(layout_));
    }

    Reduction<Element> polynomial(const BasisElement<Element>& f) override {
        begin();
        std::ranges::fill(multiplier_, Word{0});
        add_multiple(f, Domain::one(), 0);
        return reduce(TermList<Element>(layout_));
    }

    Reduction<Element> tail(std::size_t i) override {
        begin();
        std::ranges::fill(multiplier_, Word{0});
        add_multiple(basis_[i], Domain::one(), 1);
        TermList<Element> lead(layout_);
        lead.monomials.assign(basis_.lead(i), basis_.lead(i) + words());
        sums_.emit(basis_[i].terms.coefficients.front());
        return reduce(std::move(lead));
    }

  private:
    using Store = RowStore<Element, Words>;
    using Index = typename Store::Index;

    /// What has accumulated at a monomial.
    struct Entry {
        typename RowSums<Domain>::Cell cell;
        std::uint32_t pending_in = 0; ///< the reduction in whose heap it is or was
    };
    /// A pending monomial with its first word, flipped so that it compares as unsigned: most comparisons in
    /// the heap end there, without a look at the table.
    struct Pending {
        Word key;
        Index index;
    };

    std::size_t words() const { return store_.words(); }

    auto by_monomial() const {
        return [this](const Pending& a, const Pending& b) {
            if (a.key != b.key) return a.key < b.key;
            const Word* ma = store_.monomial(a.index);
            const Word* mb = store_.monomial(b.index);
            const Word* flip = layout_.flip();
            for (std::size_t w = 1; w < words(); ++w) {
                if (ma[w] != mb[w]) return (ma[w] ^ flip[w]) < (mb[w] ^ flip[w]);
            }
            return false;
        };
    }

    /// Factors for two rows whose leading coefficients are a and b, so that these cancel.
    std::pair<Element, Element> cofactors(const Element& a, const Element& b) const {
        if constexpr (Domain::is_field) {
            return {Domain::one(), domain_.negate(Domain::one())}; // both are monic
        } else {
            const Element common = gcd(a, b);
            std::pair<Element, Element> result{b, -a};
            result.first.divide_exactly(common);
            result.second.divide_exactly(common);
            return result;
        }
    }

    void begin() {
        // Cells are empty after a reduction, unless it ended by an exception.
        for (const Pending& pending : heap_) static_cast<void>(sums_.collect(entries_[pending.index].cell));
        heap_.clear();
        if (store_.is_large() || ++generation_ == 0) {
            store_.clear();
            entries_.clear();
            generation_ = 1;
        }
        sums_.begin();
        sugar_ = 0;
    }

    /// Adds q times the row, without its first `first` terms.
    void add_row(std::span<const Index> row, const BasisElement<Element>& f, Element q, std::size_t first) {
        run_.poll();
        sums_.add_row(f, std::move(q));
        for (std::size_t t = first; t < row.size(); ++t) {
            const Index index = row[t];
            Entry& entry = entries_[index];
            if (entry.pending_in != generation_) {
                entry.pending_in = generation_;
                heap_.push_back({*store_.monomial(index) ^ *layout_.flip(), index});
                std::ranges::push_heap(heap_, by_monomial());
            }
            sums_.add_term(entry.cell, t);
        }
    }
    /// Adds q·multiplier_·f, without its first `first` terms.
    void add_multiple(const BasisElement<Element>& f, Element q, std::size_t first) {
        indices_.clear();
        store_.product(multiplier_.data(), f, indices_);
        entries_.resize(store_.size());
        add_row(indices_, f, std::move(q), first);
    }

    Index take_greatest() {
        std::ranges::pop_heap(heap_, by_monomial());
        const Index top = heap_.back().index;
        heap_.pop_back();
        return top;
    }

    /// Evaluates all that is pending and continues with one row of it (RowSums::collapse).
    void collapse() {
        std::vector<Element> values;
        std::erase_if(heap_, [&](const Pending& pending) {
            Entry& entry = entries_[pending.index];
            Element value = sums_.collect(entry.cell);
            const bool vanishes = Domain::is_zero(value);
            if (vanishes)
                entry.pending_in = 0;
            else
                values.push_back(std::move(value));
            return vanishes;
        });
        sums_.collapse(std::move(values));
        for (std::size_t i = 0; i < heap_.size(); ++i) sums_.add_term(entries_[heap_[i].index].cell, i);
        std::ranges::make_heap(heap_, by_monomial());
    }

    /// Normal form of what is pending, after the leading terms that are given and emitted already.
    Reduction<Element> reduce(TermList<Element> leading) {
        Reduction<Element> result{std::move(leading), 0, 0};
        while (!heap_.empty()) {
            const Index top = take_greatest();
            Element value = sums_.collect(entries_[top].cell);
            if (Domain::is_zero(value)) continue;
            const std::uint32_t k = store_.reducer_of(top);
            if (k == Store::none) {
                const Word* m = store_.monomial(top);
                result.terms.monomials.insert(result.terms.monomials.end(), m, m + words());
                sums_.emit(std::move(value));
                continue;
            }
            const BasisElement<Element>& g = basis_[k];
            const std::span<const Index> row = store_.row(top, k);
            entries_.resize(store_.size());
            if (result.terms.monomials
                    .empty()) // sugar of (top/lm g)·g is the degree of top plus the excess of g
                sugar_ = std::max(sugar_, grading_.degree(layout_, store_.monomial(top)) + g.excess);
            add_row(row, g, sums_.eliminate(value, g), 1);
            ++result.steps;
            if (sums_.wants_collapse()) collapse();
        }
        sums_.finish(result.terms.coefficients);
        result.sugar = sugar_;
        return result;
    }

    Domain domain_;
    const Basis<Element>& basis_;
    const MonomialLayout& layout_;
    const Grading& grading_;
    base::Run& run_;
    Store store_;
    std::vector<Entry> entries_; ///< parallel to the store
    std::vector<Pending> heap_;
    std::uint32_t generation_ = 0;
    RowSums<Domain> sums_;
    std::vector<Word> multiplier_;
    std::vector<Index> indices_; ///< scratch for rows that are not stored
    std::uint64_t sugar_ = 0;    ///< of the rows added above the leading term of the result
};

template <class Domain>
std::unique_ptr<Reducer<Domain>> make(const Domain& domain, const Basis<typename Domain::Element>& basis,
                                      const Grading& grading, base::Run& run) {
    switch (basis.layout().words()) {
    case 1:
        return std::make_unique<TableReducer<Domain, 1>>(domain, basis, grading, run);
    case 2:
        return std::make_unique<TableReducer<Domain, 2>>(domain, basis, grading, run);
    case 3:
        return std::make_unique<TableReducer<Domain, 3>>(domain, basis, grading, run);
    default:
        return std::make_unique<TableReducer<Domain, 0>>(domain, basis, grading, run);
    }
}

} // namespace

std::unique_ptr<Reducer<algebra::PrimeDomain>> make_reducer(const algebra::PrimeDomain& domain,
                                                            const Basis<std::uint32_t>& basis,
                                                            const Grading& grading, base::Run& run) {
    return make(domain, basis, grading, run);
}

std::unique_ptr<Reducer<algebra::IntegerDomain>> make_reducer(const algebra::IntegerDomain& domain,
                                                              const Basis<algebra::Integer>& basis,
                                                              const Grading& grading, base::Run& run) {
    return make(domain, basis, grading, run);
}

} // namespace eliminant::groebner
