#include "reducer.hpp"

#include "monomial_table.hpp"
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
          table_(layout_.words()), sums_(domain), multiplier_(layout_.words()), scratch_(layout_.words()) {}

    Reduction<Element> s_polynomial(std::size_t i, std::size_t j, const Word* lcm) override {
        begin();
        // (lcm/lt gᵢ)·gᵢ − (lcm/lt gⱼ)·gⱼ up to a factor; the leading terms cancel and are left out.
        const BasisElement<Element>& f = basis_[i];
        const BasisElement<Element>& g = basis_[j];
        const auto [cf, cg] = cofactors(f.terms.coefficients.front(), g.terms.coefficients.front());
        layout_.divide(lcm, basis_.lead(i), multiplier_.data());
        add_row(f, cf, 1);
        layout_.divide(lcm, basis_.lead(j), multiplier_.data());
        add_row(g, cg, 1);
        return reduce(TermList<Element>(layout_));
    }

    Reduction<Element> polynomial(const BasisElement<Element>& f) override {
        begin();
        std::ranges::fill(multiplier_, Word{0});
        add_row(f, Domain::one(), 0);
        return reduce(TermList<Element>(layout_));
    }

    Reduction<Element> tail(std::size_t i) override {
        begin();
        std::ranges::fill(multiplier_, Word{0});
        add_row(basis_[i], Domain::one(), 1);
        TermList<Element> lead(layout_);
        lead.monomials.assign(basis_.lead(i), basis_.lead(i) + words());
        sums_.emit(basis_[i].terms.coefficients.front());
        return reduce(std::move(lead));
    }

  private:
    using Index = typename MonomialTable<Words>::Index;
    using Cell = typename RowSums<Domain>::Cell;
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    /// Above this many monomials (some hundred megabytes) the table is emptied between two reductions.
    static constexpr std::size_t table_limit = std::size_t{1} << 22;

    /// Above this many indices in stored rows (half a gigabyte) likewise.
    static constexpr std::size_t row_limit = std::size_t{1} << 27;

    /// The part of a monomial's record that every term of every row touches.
    struct Entry {
        Cell cell;
        std::uint32_t pending_in = 0; ///< the reduction in whose heap it is or was
    };
    /// The part that is read when the monomial is the greatest one.
    struct Knowledge {
        std::uint32_t reducer = none; ///< best element among those checked whose leading monomial divides it
        std::uint32_t checked = 0;    ///< number of elements that were checked
        std::uint64_t mask = 0;
        std::uint32_t row_stamp = 0; ///< of the element whose multiple is stored as a row
        std::uint64_t row_begin = 0; ///< where in row_indices_
    };

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

    std::size_t words() const { return Words != 0 ? Words : layout_.words(); }

    /// A pending monomial with its first word, flipped so that it compares as unsigned: most comparisons in
    /// the heap end there, without a look at the table.
    struct Pending {
        Word key;
        Index index;
    };
    bool less(const Pending& a, const Pending& b) const {
        if (a.key != b.key) return a.key < b.key;
        const Word* ma = table_.monomial(a.index);
        const Word* mb = table_.monomial(b.index);
        const Word* flip = layout_.flip();
        for (std::size_t w = 1; w < words(); ++w) {
            if (ma[w] != mb[w]) return (ma[w] ^ flip[w]) < (mb[w] ^ flip[w]);
        }
        return false;
    }
    auto by_monomial() const {
        return [this](const Pending& a, const Pending& b) { return less(a, b); };
    }

    void begin() {
        // Cells are empty after a reduction, unless it ended by an exception.
        for (const Pending& pending : heap_) static_cast<void>(sums_.collect(entries_[pending.index].cell));
        heap_.clear();
        if (table_.size() > table_limit || row_indices_.size() > row_limit || ++generation_ == 0) {
            table_.clear();
            entries_.clear();
            knowledge_.clear();
            row_indices_.clear();
            generation_ = 1;
        }
        sums_.begin();
        sugar_ = 0;
    }

    void touch(Index index) {
        Entry& entry = entries_[index];
        if (entry.pending_in == generation_) return;
        entry.pending_in = generation_;
        heap_.push_back({*table_.monomial(index) ^ *layout_.flip(), index});
        std::ranges::push_heap(heap_, by_monomial());
    }

    /// Adds q·multiplier_·f from its term `first` on; calls record(index) for each monomial.
    template <class Record>
    void add_row(const BasisElement<Element>& f, Element q, std::size_t first, Record&& record) {
        if (!layout_.multiply(multiplier_.data(), f.field_maxima.data(), scratch_.data()))
            throw LayoutTooNarrow{};
        run_.poll();
        sums_.add_row(f, std::move(q));
        const std::uint64_t multiplier_hash = table_.hash(multiplier_.data());
        const TermList<Element>& terms = f.terms;
        for (std::size_t t = first; t < terms.size(); ++t) {
            const Word* m = terms.monomials.data() + t * words();
            const Index index = table_.product(multiplier_.data(), m, multiplier_hash + table_.hash(m));
            if (index == entries_.size()) {
                entries_.emplace_back();
                knowledge_.emplace_back();
            }
            record(index);
            touch(index);
            sums_.add_term(entries_[index].cell, t);
        }
    }
    void add_row(const BasisElement<Element>& f, Element q, std::size_t first) {
        add_row(f, std::move(q), first, [](Index) {});
    }

    /// Adds the multiple of element k that cancels `value` at the monomial `top`.
    ///
    /// The same monomials are met again and again, and the indices of their rows stay what they are: stored
    /// at the first use, they save the products and look-ups of all later ones (katsura-8 over GF(p): a
    /// factor of three).
    void cancel(Index top, const Element& value, std::uint32_t k) {
        const BasisElement<Element>& g = basis_[k];
        Element q = sums_.eliminate(value, g);
        Knowledge& known = knowledge_[top];
        if (known.row_stamp != g.stamp) {
            const std::size_t begin = row_indices_.size();
            add_row(g, std::move(q), 1, [this](Index index) { row_indices_.push_back(index); });
            knowledge_[top].row_stamp = g.stamp;
            knowledge_[top].row_begin = begin;
            return;
        }
        run_.poll();
        sums_.add_row(g, std::move(q));
        const Index* indices = row_indices_.data() + known.row_begin;
        for (std::size_t t = 1; t < g.terms.size(); ++t) {
            const Index index = *indices++;
            touch(index);
            sums_.add_term(entries_[index].cell, t);
        }
    }

    /// A reducer that does not raise the sugar comes first: on cyclic-6 over ℚ that alone is a factor of
    /// five, as the elements that are in the end redundant have the long coefficients.
    static bool preferred(const BasisElement<Element>& f, const BasisElement<Element>& g) {
        return f.excess != g.excess ? f.excess < g.excess : f.cost < g.cost;
    }

    /// The element to reduce the monomial by, or none. Elements checked before are not looked at again.
    std::uint32_t reducer_of(Index index) {
        Knowledge& entry = knowledge_[index];
        const std::size_t count = basis_.size();
        if (entry.checked == count) return entry.reducer;
        const Word* m = table_.monomial(index);
        if (entry.checked == 0) entry.mask = layout_.divisibility_mask(m);
        const std::uint64_t absent = ~entry.mask;
        const std::uint64_t* masks = basis_.masks().data();
        for (std::size_t k = entry.checked; k < count; ++k) {
            if ((masks[k] & absent) != 0 || !layout_.divides(basis_.lead(k), m) || basis_[k].redundant)
                continue;
            if (entry.reducer == none || preferred(basis_[k], basis_[entry.reducer]))
                entry.reducer = static_cast<std::uint32_t>(k);
        }
        entry.checked = static_cast<std::uint32_t>(count);
        return entry.reducer;
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
            const std::uint32_t k = reducer_of(top);
            const Word* m = table_.monomial(top);
            if (k == none) {
                result.terms.monomials.insert(result.terms.monomials.end(), m, m + words());
                sums_.emit(std::move(value));
                continue;
            }
            const BasisElement<Element>& g = basis_[k];
            layout_.divide(m, basis_.lead(k), multiplier_.data());
            if (result.terms.monomials.empty())
                sugar_ = std::max(sugar_, grading_.degree(layout_, multiplier_.data()) + g.sugar);
            cancel(top, value, k);
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
    MonomialTable<Words> table_;
    std::vector<Entry> entries_;       ///< parallel to the table
    std::vector<Knowledge> knowledge_; ///< parallel to the table
    std::vector<Index> row_indices_;   ///< of all stored rows
    std::vector<Pending> heap_;
    std::uint32_t generation_ = 0;
    RowSums<Domain> sums_;
    std::vector<Word> multiplier_;
    std::vector<Word> scratch_;
    std::uint64_t sugar_ = 0; ///< of the rows added above the leading term of the result
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
