#pragma once

#include "eliminant/base/run.hpp"

#include "multiply_heap.hpp"
#include "multiply_window.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// An operand as the kernels read it: decreasing keys, coefficients beside them.
template <class Key, class Operand>
struct KeyedTerms {
    std::vector<Key> keys;
    std::span<const Operand> coefficients;
    std::size_t size() const { return keys.size(); }
};

/// Emits the terms of a·b, largest first, as emit(key, coefficient).
///
/// S. Johnson, Sparse polynomial arithmetic, SIGSAM Bulletin 8 (1974): one waiting product for each term of a
/// in a heap, which grows only as the leading products reach the next row. Memory O(#a) beside operands and
/// result; time O(#a·#b·log #a), less where products coincide.
template <class Key, class Sums, class Emit>
void multiply_by_heap(const KeyedTerms<Key, typename Sums::Operand>& a,
                      const KeyedTerms<Key, typename Sums::Operand>& b, const Sums& sums, base::Run& run,
                      Emit&& emit) {
    ChainedHeap<Key> heap(a.size());
    std::vector<std::uint32_t> cursor(a.size(), 0);
    std::vector<std::uint32_t> rows;
    heap.push(a.keys[0] + b.keys[0], 0);
    while (!heap.empty()) {
        run.poll();
        const Key key = heap.top();
        rows.clear();
        heap.pop_all(rows);
        typename Sums::Cell sum{};
        for (const std::uint32_t row : rows) {
            if constexpr (Sums::polls) run.poll();
            sums.add(sum, a.coefficients[row], b.coefficients[cursor[row]]);
        }
        auto value = sums.take(sum);
        if (!Sums::is_zero(value)) emit(key, std::move(value));
        for (const std::uint32_t row : rows) {
            if (cursor[row] == 0 && row + 1 < a.size()) heap.push(a.keys[row + 1] + b.keys[0], row + 1);
            if (++cursor[row] < b.size()) heap.push(a.keys[row] + b.keys[cursor[row]], row);
        }
    }
}

/// The same by accumulation in a window of 2^window_bits consecutive keys that slides down the key line.
///
///     row i of a:    kᵢ + keys of b      ········|·· ·  ···|···· · ·|· ··
///     windows                            w+2     |   w+1   |   w    |
///
/// In each window every row adds its products there by plain indexing, then the cells that were touched are
/// emitted and cleared. Rows wait in an agenda for the window of their next product, so windows without
/// products cost nothing. Time O(#a·(#b + windows that b spans) + cells of the windows visited / 128).
template <class Key, class Sums, class Emit>
void multiply_by_window(const KeyedTerms<Key, typename Sums::Operand>& a,
                        const KeyedTerms<Key, typename Sums::Operand>& b, unsigned window_bits,
                        const Sums& sums, base::Run& run, Emit&& emit) {
    Window<Sums> window(window_bits, sums);
    Agenda<Key> agenda(a.size(), (a.keys[0] + b.keys[0]) >> window_bits);
    std::vector<std::uint32_t> cursor(a.size(), 0);
    for (std::size_t i = 0; i < a.size(); ++i)
        agenda.push((a.keys[i] + b.keys[0]) >> window_bits, static_cast<std::uint32_t>(i));
    std::vector<std::uint32_t> rows;
    Key index{};
    while (agenda.pop(index, rows)) {
        const Key low = index << window_bits;
        for (const std::uint32_t row : rows) {
            run.poll();
            const std::size_t end = window.add_row(a.coefficients[row], a.keys[row] - low, b.keys.data(),
                                                   b.coefficients.data(), cursor[row], b.size(), run);
            cursor[row] = static_cast<std::uint32_t>(end);
            if (end < b.size()) agenda.push((a.keys[row] + b.keys[end]) >> window_bits, row);
        }
        window.drain([&](std::size_t cell, auto&& value) {
            emit(low + cell, std::forward<decltype(value)>(value));
            return true;
        });
    }
}

} // namespace eliminant::algebra
