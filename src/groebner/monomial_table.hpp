#pragma once

#include "eliminant/algebra/monomial_layout.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eliminant::groebner {

/// The monomials that reductions have met, each stored once and named by its index: open addressing over a
/// flat array. It outlives a single reduction, so what was learnt of a monomial (its reducer) is looked up,
/// not searched.
///
///     slots_      | index + 1 or 0 | …          a power of two of them, at most half full
///     monomials_  | m₀ words | m₁ words | …
///     hashes_     | h₀ | h₁ | …
///
/// The hash Σ wordᵢ·oddᵢ mod 2^64 is additive, as products of monomials are sums of words: the hash of a
/// product is the sum of the hashes. Words is the number of words of a monomial, 0 for any number known at
/// run time.
template <std::size_t Words>
class MonomialTable {
  public:
    using Word = algebra::MonomialLayout::Word;
    using Index = std::uint32_t;

    explicit MonomialTable(std::size_t words) : words_(words), slots_(std::size_t{1} << initial_bits, 0) {
        std::uint64_t state = 0x9e3779b97f4a7c15U; // fixed: results do not depend on it, so no seed is needed
        for (std::size_t w = 0; w < words; ++w) {
            state = state * 6364136223846793005U + 1442695040888963407U;
            multipliers_.push_back((state ^ (state >> 29)) | 1);
        }
    }

    std::size_t words() const { return Words != 0 ? Words : words_; }
    std::size_t size() const { return hashes_.size(); }
    const Word* monomial(Index i) const { return monomials_.data() + i * words(); }

    std::uint64_t hash(const Word* m) const {
        std::uint64_t h = 0;
        for (std::size_t w = 0; w < words(); ++w) h += m[w] * multipliers_[w];
        return h;
    }

    /// Index of the product a·b whose hash is given; entered if new (then index == size() before the call).
    Index product(const Word* a, const Word* b, std::uint64_t product_hash) {
        std::size_t slot = product_hash >> shift_;
        while (true) {
            const Index found = slots_[slot];
            if (found == 0) break;
            if (hashes_[found - 1] == product_hash && is_product(monomial(found - 1), a, b)) return found - 1;
            slot = (slot + 1) & (slots_.size() - 1);
        }
        const auto index = static_cast<Index>(size());
        slots_[slot] = index + 1;
        hashes_.push_back(product_hash);
        for (std::size_t w = 0; w < words(); ++w) monomials_.push_back(a[w] + b[w]);
        if (2 * size() > slots_.size()) grow();
        return index;
    }

    /// Forgets all monomials.
    void clear() {
        slots_.assign(std::size_t{1} << initial_bits, 0);
        shift_ = 64 - initial_bits;
        monomials_.clear();
        hashes_.clear();
    }

  private:
    static constexpr unsigned initial_bits = 12;

    bool is_product(const Word* m, const Word* a, const Word* b) const {
        for (std::size_t w = 0; w < words(); ++w) {
            if (m[w] != a[w] + b[w]) return false;
        }
        return true;
    }
    void grow() {
        slots_.assign(2 * slots_.size(), 0);
        --shift_;
        for (std::size_t i = 0; i < size(); ++i) {
            std::size_t slot = hashes_[i] >> shift_;
            while (slots_[slot] != 0) slot = (slot + 1) & (slots_.size() - 1);
            slots_[slot] = static_cast<Index>(i + 1);
        }
    }

    std::size_t words_;
    unsigned shift_ = 64 - initial_bits;
    std::vector<Index> slots_;
    std::vector<Word> monomials_;
    std::vector<std::uint64_t> hashes_;
    std::vector<std::uint64_t> multipliers_;
};

} // namespace eliminant::groebner
