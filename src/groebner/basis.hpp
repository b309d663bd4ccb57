#pragma once

#include "algebra/domain.hpp"
#include "eliminant/algebra/term_list.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace eliminant::groebner {

using algebra::MonomialLayout;
using algebra::TermList;
using Word = MonomialLayout::Word;

/// An element of a basis under construction: monic over GF(p), primitive with positive leading coefficient
/// over ℤ.
template <class Element>
struct BasisElement {
    TermList<Element> terms;
    std::vector<Word> field_maxima; ///< packed: the largest value of each field over all terms
    std::uint64_t sugar = 0;
    std::uint64_t excess = 0; ///< sugar minus the degree of the leading monomial
    std::uint64_t cost = 0;   ///< what a reduction by it costs; cheaper reducers are preferred
    std::uint32_t stamp = 0;  ///< distinguishes all term lists that the basis ever held; never 0
    bool redundant = false;   ///< a later element's leading monomial divides this one's
};

/// The elements found so far, with what the search for a reducer reads kept apart in contiguous arrays.
///
///     elements   | terms, sugar, … | …     append only, so indices stay valid
///     leads      | lm₀ words | lm₁ words | …
///     masks      | divisibility mask of lm₀ | …
template <class Element>
class Basis {
  public:
    explicit Basis(const MonomialLayout& layout) : layout_(&layout) {}

    const MonomialLayout& layout() const { return *layout_; }
    std::size_t size() const { return elements_.size(); }
    const BasisElement<Element>& operator[](std::size_t i) const { return elements_[i]; }
    const Word* lead(std::size_t i) const { return leads_.data() + i * layout_->words(); }
    const std::vector<std::uint64_t>& masks() const { return masks_; }

    /// `degree` is that of the leading monomial in the grading of the sugar.
    void append(TermList<Element> terms, std::uint64_t sugar, std::uint64_t degree, std::uint64_t cost) {
        BasisElement<Element> element{std::move(terms), {}, sugar, sugar - degree, cost, ++stamps_, false};
        const Word* lm = element.terms.monomial(0);
        leads_.insert(leads_.end(), lm, lm + layout_->words());
        masks_.push_back(layout_->divisibility_mask(lm));
        element.field_maxima = packed_field_maxima(element.terms);
        elements_.push_back(std::move(element));
    }
    void mark_redundant(std::size_t i) { elements_[i].redundant = true; }
    /// Exchanges an element's terms for others with the same leading monomial.
    void replace(std::size_t i, TermList<Element> terms, std::uint64_t cost) {
        elements_[i].terms = std::move(terms);
        elements_[i].field_maxima = packed_field_maxima(elements_[i].terms);
        elements_[i].cost = cost;
        elements_[i].stamp = ++stamps_;
    }
    TermList<Element> take_terms(std::size_t i) { return std::move(elements_[i].terms); }

    /// Repacks everything in a wider layout.
    void widen(const MonomialLayout& layout);

  private:
    std::vector<Word> packed_field_maxima(const TermList<Element>& terms) const;

    const MonomialLayout* layout_;
    std::vector<BasisElement<Element>> elements_;
    std::vector<Word> leads_;
    std::vector<std::uint64_t> masks_;
    std::uint32_t stamps_ = 0;
};

/// All terms in another layout of the same ring that is at least as wide.
template <class Element>
TermList<Element> widened(TermList<Element> terms, const MonomialLayout& layout) {
    if (terms.layout == &layout) return terms;
    TermList<Element> result(layout);
    result.monomials.resize(terms.size() * layout.words());
    for (std::size_t i = 0; i < terms.size(); ++i)
        static_cast<void>(layout.repack(*terms.layout, terms.monomial(i), result.monomial(i))); // wider: fits
    result.coefficients = std::move(terms.coefficients);
    return result;
}

template <class Element>
std::vector<Word> Basis<Element>::packed_field_maxima(const TermList<Element>& terms) const {
    std::vector<Word> maxima(layout_->words(), 0);
    const Word guard = layout_->guard();
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const Word* m = terms.monomial(i);
        for (std::size_t w = 0; w < maxima.size(); ++w) {
            // All fields of a word at once: a guard survives the difference where the field is not less.
            const Word not_less = ((m[w] | guard) - maxima[w]) & guard;
            const Word mask = not_less - (not_less >> (layout_->bits() - 1));
            maxima[w] = (m[w] & mask) | (maxima[w] & ~mask);
        }
    }
    return maxima;
}

template <class Element>
void Basis<Element>::widen(const MonomialLayout& layout) {
    layout_ = &layout;
    leads_.clear();
    masks_.clear();
    for (BasisElement<Element>& element : elements_) {
        element.terms = widened(std::move(element.terms), layout);
        element.field_maxima = packed_field_maxima(element.terms);
        const Word* lm = element.terms.monomial(0);
        leads_.insert(leads_.end(), lm, lm + layout.words());
        masks_.push_back(layout.divisibility_mask(lm));
    }
}

/// Thrown inside the engine where a monomial does not fit the fields of the working layout; the engine then
/// widens the layout and repeats the step.
struct LayoutTooNarrow {};

} // namespace eliminant::groebner
