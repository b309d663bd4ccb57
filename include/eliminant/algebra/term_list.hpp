#pragma once

#include "eliminant/algebra/integer.hpp"
#include "eliminant/algebra/monomial_layout.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace eliminant::algebra {

/// The terms of a polynomial in two parallel arrays, strictly decreasing in the order of `layout`, without
/// zero coefficients. Element is Integer (over ℚ, up to a common denominator) or a residue of GF(p).
///
///     monomials     | m₀ word 0 | m₀ word 1 | m₁ word 0 | m₁ word 1 | …      layout->words() words a
///     monomial coefficients  | c₀ | c₁ | …
///
/// It does not own the layout; whoever holds a TermList holds the ring that does.
template <class Element>
struct TermList {
    const MonomialLayout* layout = nullptr;
    std::vector<MonomialLayout::Word> monomials;
    std::vector<Element> coefficients;

    explicit TermList(const MonomialLayout& l) : layout(&l) {}

    std::size_t size() const { return coefficients.size(); }
    bool empty() const { return coefficients.empty(); }
    const MonomialLayout::Word* monomial(std::size_t i) const {
        return monomials.data() + i * layout->words();
    }
    MonomialLayout::Word* monomial(std::size_t i) { return monomials.data() + i * layout->words(); }

    void reserve(std::size_t terms) {
        monomials.reserve(terms * layout->words());
        coefficients.reserve(terms);
    }
    void push_back(const MonomialLayout::Word* m, Element c) {
        monomials.insert(monomials.end(), m, m + layout->words());
        coefficients.push_back(std::move(c));
    }
    /// Keeps the first `terms` terms.
    void truncate(std::size_t terms) {
        monomials.resize(terms * layout->words());
        coefficients.resize(terms);
    }
    void clear() { truncate(0); }

    /// Largest value of each field over all terms (0 for no terms).
    std::vector<std::uint64_t> field_maxima() const {
        std::vector<std::uint64_t> maxima(layout->field_count(), 0);
        for (std::size_t i = 0; i < size(); ++i) layout->update_maxima(monomial(i), maxima);
        return maxima;
    }
};

using IntegerTerms = TermList<Integer>;
using ResidueTerms = TermList<std::uint32_t>;

} // namespace eliminant::algebra
