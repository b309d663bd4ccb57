#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace eliminant::algebra {

/// A priority queue of rows, largest key first, in which rows of equal key hang on one node where they meet.
///
/// The rows of a product are its factors' terms, each with one product waiting; chaining shrinks the heap
/// where many products coincide (Monagan and Pearce, Polynomial division using dynamic arrays, heaps, and
/// packed exponent vectors, 2007).
template <class Key>
class ChainedHeap {
  public:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// For about so many rows.
    explicit ChainedHeap(std::size_t rows) : next_(rows, none) { nodes_.reserve(rows); }

    bool empty() const { return nodes_.empty(); }
    const Key& top() const { return nodes_.front().key; }

    void push(Key key, std::uint32_t row) {
        if (row >= next_.size()) next_.resize(2 * std::size_t{row} + 1, none);
        std::size_t hole = nodes_.size();
        while (hole != 0) { // look for an equal key before anything moves
            const std::size_t parent = (hole - 1) / 2;
            if (!(nodes_[parent].key < key)) {
                if (nodes_[parent].key == key) {
                    next_[row] = std::exchange(nodes_[parent].row, row);
                    return;
                }
                break;
            }
            hole = parent;
        }
        next_[row] = none;
        nodes_.push_back({key, row});
        std::size_t from = nodes_.size() - 1;
        while (from != hole) {
            const std::size_t parent = (from - 1) / 2;
            nodes_[from] = std::move(nodes_[parent]);
            from = parent;
        }
        nodes_[hole] = {std::move(key), row};
    }

    /// Appends all rows with the largest key to `rows`.
    void pop_all(std::vector<std::uint32_t>& rows) {
        const Key key = top();
        do {
            for (std::uint32_t row = nodes_.front().row; row != none; row = next_[row]) rows.push_back(row);
            remove_top();
        } while (!empty() && top() == key);
    }

  private:
    struct Node {
        Key key;
        std::uint32_t row; ///< first of a chain through next_
    };

    void remove_top() {
        Node last = std::move(nodes_.back());
        nodes_.pop_back();
        const std::size_t size = nodes_.size();
        if (size == 0) return;
        std::size_t hole = 0;
        for (std::size_t child = 1; child < size;
             child = 2 * hole + 1) { // down to a leaf: cheaper than comparing
            if (child + 1 < size && nodes_[child].key < nodes_[child + 1].key) ++child;
            nodes_[hole] = std::move(nodes_[child]);
            hole = child;
        }
        while (hole != 0) {
            const std::size_t parent = (hole - 1) / 2;
            if (!(nodes_[parent].key < last.key)) break;
            nodes_[hole] = std::move(nodes_[parent]);
            hole = parent;
        }
        nodes_[hole] = std::move(last);
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> next_;
};

} // namespace eliminant::algebra
