#pragma once

#include "eliminant/algebra/term_list.hpp"

#include "domain.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace eliminant::algebra {

/// Copy in another layout of the same ring; nullopt if a field does not fit.
template <class Element>
std::optional<TermList<Element>> repacked(const TermList<Element>& terms, const MonomialLayout& layout) {
    TermList<Element> result(layout);
    result.monomials.resize(terms.size() * layout.words());
    for (std::size_t i = 0; i < terms.size(); ++i) {
        if (!layout.repack(*terms.layout, terms.monomial(i), result.monomial(i))) return std::nullopt;
    }
    result.coefficients = terms.coefficients;
    return result;
}

/// a·ca + b·cb by merging; both in one layout.
template <class Domain>
TermList<typename Domain::Element>
linear_combination(const Domain& domain, const TermList<typename Domain::Element>& a,
                   const typename Domain::Element& ca, const TermList<typename Domain::Element>& b,
                   const typename Domain::Element& cb) {
    using Element = typename Domain::Element;
    const MonomialLayout& layout = *a.layout;
    const bool scale_a = !Domain::is_one(ca);
    const bool scale_b = !Domain::is_one(cb);
    TermList<Element> result(layout);
    result.reserve(a.size() + b.size());
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() || j < b.size()) {
        const int side = i == a.size()   ? -1
                         : j == b.size() ? 1
                                         : layout.compare(a.monomial(i), b.monomial(j));
        if (side > 0) {
            result.push_back(a.monomial(i),
                             scale_a ? domain.multiply(a.coefficients[i], ca) : a.coefficients[i]);
            ++i;
        } else if (side < 0) {
            result.push_back(b.monomial(j),
                             scale_b ? domain.multiply(b.coefficients[j], cb) : b.coefficients[j]);
            ++j;
        } else {
            Element sum = scale_a ? domain.multiply(a.coefficients[i], ca) : a.coefficients[i];
            domain.add_product(sum, b.coefficients[j], cb);
            if (!Domain::is_zero(sum)) result.push_back(a.monomial(i), std::move(sum));
            ++i;
            ++j;
        }
    }
    return result;
}

/// Sorts arbitrary terms into decreasing order, adds up equal monomials and drops zeros.
template <class Domain>
TermList<typename Domain::Element> sorted_terms(const Domain& domain,
                                                TermList<typename Domain::Element> terms) {
    using Element = typename Domain::Element;
    const MonomialLayout& layout = *terms.layout;
    bool strictly_decreasing = true;
    for (std::size_t i = 1; i < terms.size() && strictly_decreasing; ++i)
        strictly_decreasing = layout.compare(terms.monomial(i - 1), terms.monomial(i)) > 0;
    const auto has_zero = [&] { return std::ranges::any_of(terms.coefficients, &Domain::is_zero); };
    if (strictly_decreasing && !has_zero()) return terms;

    std::vector<std::size_t> permutation(terms.size());
    if (layout.words() == 1) { // sort keys beside their indices: no indirection in the comparison
        std::vector<std::pair<MonomialLayout::Word, std::size_t>> keyed(terms.size());
        for (std::size_t i = 0; i < terms.size(); ++i) keyed[i] = {~(*terms.monomial(i) ^ *layout.flip()), i};
        std::ranges::sort(keyed);
        std::ranges::transform(keyed, permutation.begin(), [](const auto& entry) { return entry.second; });
    } else {
        std::iota(permutation.begin(), permutation.end(), std::size_t{0});
        std::ranges::sort(permutation, [&](std::size_t i, std::size_t j) {
            return layout.compare(terms.monomial(i), terms.monomial(j)) > 0;
        });
    }
    TermList<Element> result(layout);
    result.reserve(terms.size());
    for (std::size_t k = 0; k < permutation.size();) {
        const std::size_t first = permutation[k];
        Element sum = std::move(terms.coefficients[first]);
        for (++k;
             k < permutation.size() && layout.equal(terms.monomial(first), terms.monomial(permutation[k]));
             ++k)
            domain.add_to(sum, terms.coefficients[permutation[k]]);
        if (!Domain::is_zero(sum)) result.push_back(terms.monomial(first), std::move(sum));
    }
    return result;
}

/// gcd of the coefficients, positive unless there are none; stops at 1.
inline Integer content_of(const IntegerTerms& terms) {
    Integer g;
    for (const Integer& c : terms.coefficients) {
        g = gcd(g, c);
        if (g.is_one()) break;
    }
    return g;
}

} // namespace eliminant::algebra
