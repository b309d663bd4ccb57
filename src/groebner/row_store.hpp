#pragma once

#include "basis.hpp"
#include "monomial_table.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// What is known of the monomials met so far: for each the element to reduce it by, and the monomials of that
/// element's multiple as a row of indices into the table.
///
/// The same monomials are met again and again, and their rows stay what they are: stored at the first use,
/// they save the products and look-ups of all later ones (cyclic-7 over GF(p), one reduction at a time: 0.15
/// s instead of 0.30).
///
///     table        monomial ↔ index
///     knowledge_   per index: reducer, elements checked, mask, its row
///     chunks_      | indices of (m/lm g)·g, leading one first | … |      they grow without being moved
template <class Element, std::size_t Words>
class RowStore {
  public:
    using Index = typename MonomialTable<Words>::Index;
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    explicit RowStore(const Basis<Element>& basis)
        : basis_(basis), layout_(basis.layout()), table_(layout_.words()), multiplier_(layout_.words()),
          bound_(layout_.words()), one_(layout_.words(), 0) {}

    std::size_t size() const { return table_.size(); }
    std::size_t words() const { return Words != 0 ? Words : layout_.words(); }
    const Word* monomial(Index i) const { return table_.monomial(i); }
    Index index_of(const Word* m) {
        const Index index = table_.product(m, one_.data(), table_.hash(m));
        knowledge_.resize(table_.size());
        return index;
    }

    /// Appends the indices of multiplier·f. Throws LayoutTooNarrow if a product does not fit.
    void product(const Word* multiplier, const BasisElement<Element>& f, std::vector<Index>& indices) {
        if (!layout_.multiply(multiplier, f.field_maxima.data(), bound_.data())) throw LayoutTooNarrow{};
        const std::size_t begin = indices.size();
        indices.resize(begin + f.terms.size());
        enter_product(multiplier, f.terms, indices.data() + begin);
    }

    /// The element to reduce a monomial by, or none. Elements checked before are not looked at again.
    std::uint32_t reducer_of(Index index) {
        Knowledge& known = knowledge_[index];
        const std::size_t count = basis_.size();
        if (known.checked == count) return known.reducer;
        const Word* m = table_.monomial(index);
        if (known.checked == 0) known.mask = layout_.divisibility_mask(m);
        const std::uint64_t absent = ~known.mask;
        const std::uint64_t* masks = basis_.masks().data();
        for (std::size_t k = known.checked; k < count; ++k) {
            if ((masks[k] & absent) != 0 || !layout_.divides(basis_.lead(k), m) || basis_[k].redundant)
                continue;
            if (known.reducer == none || preferred(basis_[k], basis_[known.reducer]))
                known.reducer = static_cast<std::uint32_t>(k);
        }
        known.checked = static_cast<std::uint32_t>(count);
        return known.reducer;
    }

    /// The indices of the multiple of element k whose leading monomial is `top`; valid until the next call.
    /// Throws LayoutTooNarrow if a product does not fit.
    std::span<const Index> row(Index top, std::uint32_t k) {
        const BasisElement<Element>& g = basis_[k];
        if (knowledge_[top].row_stamp != g.stamp) {
            layout_.divide(table_.monomial(top), basis_.lead(k), multiplier_.data());
            if (!layout_.multiply(multiplier_.data(), g.field_maxima.data(), bound_.data()))
                throw LayoutTooNarrow{};
            Index* room = allocate(g.terms.size());
            enter_product(multiplier_.data(), g.terms, room);
            knowledge_[top].row_stamp = g.stamp;
            knowledge_[top].row = room;
        }
        return {knowledge_[top].row, g.terms.size()};
    }

    /// Whether it has outgrown some hundred megabytes. It may be cleared whenever no index is held.
    bool is_large() const { return table_.size() > monomial_limit || rows_size_ > index_limit; }
    void clear() {
        table_.clear();
        knowledge_.clear();
        forget_rows();
    }
    /// Number of indices in the rows stored.
    std::size_t rows_size() const { return rows_size_; }
    /// Frees the rows. Indices and what is known of reducers stay.
    void forget_rows() {
        for (Knowledge& known : knowledge_) known.row_stamp = 0;
        chunks_.clear();
        room_ = {};
        rows_size_ = 0;
    }

  private:
    static constexpr std::size_t monomial_limit = std::size_t{1} << 22;
    static constexpr std::size_t index_limit = std::size_t{1} << 26;
    static constexpr std::size_t chunk_size = std::size_t{1} << 16;

    struct Knowledge {
        std::uint32_t reducer = none; ///< best element among those checked whose leading monomial divides it
        std::uint32_t checked = 0;    ///< number of elements that were checked
        std::uint64_t mask = 0;
        std::uint32_t row_stamp = 0; ///< of the element whose multiple is stored as a row
        const Index* row = nullptr;  ///< in chunks_
    };

    void enter_product(const Word* multiplier, const TermList<Element>& terms, Index* indices) {
        const std::uint64_t multiplier_hash = table_.hash(multiplier);
        for (std::size_t t = 0; t < terms.size(); ++t) {
            const Word* m = terms.monomials.data() + t * words();
            indices[t] = table_.product(multiplier, m, multiplier_hash + table_.hash(m));
        }
        knowledge_.resize(table_.size());
    }

    Index* allocate(std::size_t size) {
        if (room_.size() < size) {
            const std::size_t chunk = std::max(size, chunk_size);
            room_ = {chunks_.emplace_back(std::make_unique_for_overwrite<Index[]>(chunk)).get(), chunk};
        }
        Index* result = room_.data();
        room_ = room_.subspan(size);
        rows_size_ += size;
        return result;
    }

    /// A reducer that does not raise the sugar comes first: on cyclic-6 over ℚ that alone is a factor of
    /// five, as the elements that are in the end redundant have the long coefficients.
    static bool preferred(const BasisElement<Element>& f, const BasisElement<Element>& g) {
        return f.excess != g.excess ? f.excess < g.excess : f.cost < g.cost;
    }

    const Basis<Element>& basis_;
    const MonomialLayout& layout_;
    MonomialTable<Words> table_;
    std::vector<Knowledge> knowledge_; ///< parallel to the table
    std::vector<std::unique_ptr<Index[]>> chunks_;
    std::span<Index> room_; ///< at the end of the last chunk
    std::size_t rows_size_ = 0;
    std::vector<Word> multiplier_;
    std::vector<Word> bound_;
    std::vector<Word> one_;
};

} // namespace eliminant::groebner
