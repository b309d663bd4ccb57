#pragma once

#include "eliminant/base/run.hpp"

#include "multiply_kernels.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace eliminant::algebra {

/// How an exact division ended.
enum class DivisionOutcome {
    exact,
    inexact,  ///< the divisor does not divide
    overflow, ///< the accumulators are too narrow for what the quotient turned out to be
};

/// Emits the terms of a/b, largest first, as long as b divides.
///
/// The windows of multiply_by_window, running over a − q·b while q is found: in each window the dividend's
/// terms and the products of known quotient terms are added up, then every nonzero cell from the top gives a
/// quotient term, whose products that fall in the same window are subtracted at once and the rest left to the
/// agenda. Windows of one cell make it the quotient heap of Monagan and Pearce (Sparse polynomial division
/// using a heap, J. Symbolic Comput. 46 (2011)).
///
/// `find_term(key, value, q)` sets q to the quotient's coefficient for a remaining term value·key of the
/// dividend.
template <class Key, class Sums, class FindTerm>
DivisionOutcome divide_by_window(const KeyedTerms<Key, typename Sums::Element>& a,
                                 const KeyedTerms<Key, typename Sums::Operand>& b, unsigned window_bits,
                                 const Sums& sums, base::Run& run, FindTerm&& find_term) {
    constexpr std::uint32_t dividend = 0; // the row of a; row i ≥ 1 is the i-th quotient term
    struct Row {
        Key shift; ///< its products have the keys of b plus this
        typename Sums::Operand factor;
        std::size_t cursor; ///< first term of b, or of a, not used yet
    };
    Window<Sums> window(window_bits, sums);
    Agenda<Key> agenda(1 + a.size() / b.size(), a.keys[0] >> window_bits);
    std::vector<Row> rows{{Key{}, {}, 0}};
    agenda.push(a.keys[0] >> window_bits, dividend);
    std::vector<std::uint32_t> active;
    Key index{};
    DivisionOutcome outcome = DivisionOutcome::exact;
    while (agenda.pop(index, active)) {
        const Key low = index << window_bits;
        const auto subtract_products = [&](std::uint32_t i) {
            run.poll();
            Row& row = rows[i];
            if (row.cursor < b.size() && static_cast<Key>(row.shift + b.keys[row.cursor]) >= low)
                row.cursor = window.add_row(row.factor, row.shift - low, b.keys.data(), b.coefficients.data(),
                                            row.cursor, b.size(), run);
            if (row.cursor < b.size()) agenda.push((row.shift + b.keys[row.cursor]) >> window_bits, i);
        };
        for (const std::uint32_t i : active) {
            if (i != dividend) {
                subtract_products(i);
                continue;
            }
            std::size_t& next = rows[dividend].cursor;
            for (; next < a.size() && a.keys[next] >= low; ++next)
                sums.add_value(window.touch(static_cast<std::size_t>(a.keys[next] - low)),
                               a.coefficients[next]);
            if (next < a.size()) agenda.push(a.keys[next] >> window_bits, dividend);
        }
        const auto resolve = [&](std::size_t cell, typename Sums::Element&& value) {
            const Key key = low + cell;
            typename Sums::Element q{};
            outcome = key < b.keys[0] ? DivisionOutcome::inexact : find_term(key, value, q);
            if (outcome != DivisionOutcome::exact) return false;
            rows.push_back({key - b.keys[0], sums.negative(q), 1});
            subtract_products(static_cast<std::uint32_t>(rows.size() - 1));
            return true;
        };
        if (!window.drain(resolve)) break;
    }
    return outcome;
}

} // namespace eliminant::algebra
