#pragma once

#include "eliminant/base/run.hpp"

#include "multiply_heap.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace eliminant::algebra {

/// The smallest window has 2^min_window_bits cells.
constexpr unsigned min_window_bits = 7;

/// Cells for consecutive keys, with one byte for each block of 16 cells that tells whether it was touched: a
/// store costs less than finding the cells again among zeros.
template <class Sums>
class Window {
  public:
    using Cell = typename Sums::Cell;
    using Operand = typename Sums::Operand;
    static constexpr unsigned block_bits = min_window_bits - 3; // marks are read eight at a time

    /// 2^bits cells; with bits = 0, one cell, the window serves as plain heap algorithm.
    Window(unsigned bits, const Sums& sums)
        : size_(std::size_t{1} << bits), sums_(&sums),
          cells_(std::size_t{1} << std::max(bits, min_window_bits)), marks_(cells_.size() >> block_bits, 0) {}

    Cell& touch(std::size_t cell) {
        marks_[cell >> block_bits] = 1;
        return cells_[cell];
    }

    /// Adds factor·(terms of b from j on) at cells shift + key while these lie in the window; returns the
    /// first term that does not.
    template <class Key>
    std::size_t add_row(const Operand& factor, Key shift, const Key* keys, const Operand* coefficients,
                        std::size_t j, std::size_t terms, const base::Run& run) {
        do {
            if constexpr (Sums::polls) run.poll();
            sums_->add(touch(static_cast<std::size_t>(keys[j] + shift)), factor, coefficients[j]);
            ++j;
        } while (j < terms && static_cast<Key>(keys[j] + shift) < size_); // keys below the window wrap around
        return j;
    }

    /// Calls visit(cell, value) for the nonzero cells, last first, and clears the window; ends where that
    /// returns false, and is then good for nothing. `visit` may touch smaller cells.
    template <class Visit>
    bool drain(Visit&& visit) {
        for (std::size_t group = marks_.size() / 8; group-- > 0;) {
            std::uint64_t marks = 0;
            std::memcpy(&marks, marks_.data() + group * 8, 8);
            if (marks == 0) continue;
            for (std::size_t block = group * 8 + 8; block-- > group * 8;) {
                if (marks_[block] == 0) continue;
                for (std::size_t cell = (block + 1) << block_bits; cell-- > block << block_bits;) {
                    if (Sums::is_empty(cells_[cell])) continue;
                    auto value = sums_->take(cells_[cell]);
                    if (!Sums::is_zero(value) && !visit(cell, std::move(value))) return false;
                }
            }
            std::memset(marks_.data() + group * 8, 0, 8);
        }
        return true;
    }

  private:
    std::size_t size_;
    const Sums* sums_;
    std::vector<Cell> cells_;
    std::vector<unsigned char> marks_;
};

/// Which rows have work in which window, windows in decreasing sequence.
///
/// Where there are not many more windows than rows it is an array of lists, else a heap.
template <class Key>
class Agenda {
  public:
    /// Windows 0 … last, pushed in any sequence below the last one popped; about `rows` rows.
    Agenda(std::size_t rows, Key last) : heap_(0), next_(rows, none) {
        if (last <= 16 * rows + 4096) {
            current_ = static_cast<std::size_t>(last) + 1;
            lists_.assign(current_, none);
        } else {
            heap_ = ChainedHeap<Key>(rows);
        }
    }
    void push(Key window, std::uint32_t row) {
        if (lists_.empty()) {
            heap_.push(window, row);
            return;
        }
        if (row >= next_.size()) next_.resize(2 * std::size_t{row} + 1, none);
        next_[row] = std::exchange(lists_[static_cast<std::size_t>(window)], row);
    }
    /// The largest window with work and its rows; false if there is none.
    bool pop(Key& window, std::vector<std::uint32_t>& rows) {
        rows.clear();
        if (lists_.empty()) {
            if (heap_.empty()) return false;
            window = heap_.top();
            heap_.pop_all(rows);
            return true;
        }
        while (current_ != 0) {
            if (lists_[--current_] == none) continue;
            for (std::uint32_t row = lists_[current_]; row != none; row = next_[row]) rows.push_back(row);
            window = static_cast<Key>(current_);
            return true;
        }
        return false;
    }

  private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    ChainedHeap<Key> heap_;
    std::vector<std::uint32_t> lists_; ///< first row of each window; empty if the heap is used
    std::vector<std::uint32_t> next_;
    std::size_t current_ = 0;
};

} // namespace eliminant::algebra
