#include "eliminant/ideal/dimension.hpp"

#include "groebner/graded_order.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace eliminant::ideal {

namespace {

/// A set of variables, a bit each.
class VariableSet {
  public:
    explicit VariableSet(std::size_t variable_count) : words_((variable_count + 63) / 64, 0) {}

    void insert(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
    void erase(std::size_t i) { words_[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }
    bool contains(std::size_t i) const { return ((words_[i / 64] >> (i % 64)) & 1) != 0; }
    std::size_t size() const {
        std::size_t count = 0;
        for (const std::uint64_t word : words_) count += static_cast<std::size_t>(std::popcount(word));
        return count;
    }
    bool meets(const VariableSet& other) const {
        for (std::size_t w = 0; w < words_.size(); ++w) {
            if ((words_[w] & other.words_[w]) != 0) return true;
        }
        return false;
    }
    bool is_subset_of(const VariableSet& other) const {
        for (std::size_t w = 0; w < words_.size(); ++w) {
            if ((words_[w] & ~other.words_[w]) != 0) return false;
        }
        return true;
    }
    VariableSet& operator|=(const VariableSet& other) {
        for (std::size_t w = 0; w < words_.size(); ++w) words_[w] |= other.words_[w];
        return *this;
    }
    VariableSet& operator-=(const VariableSet& other) {
        for (std::size_t w = 0; w < words_.size(); ++w) words_[w] &= ~other.words_[w];
        return *this;
    }

  private:
    std::vector<std::uint64_t> words_;
};

/// Minimum hitting set by branch and bound.
///
/// A smallest set not yet hit must be hit by one of its variables: these are the branches, and each branch
/// may forbid the variables of the branches before it. Sets not yet hit that are pairwise disjoint need a
/// variable each: the bound.
class HittingSet {
  public:
    HittingSet(std::vector<VariableSet> sets, std::size_t variable_count, base::Run& run)
        : variable_count_(variable_count), run_(run), best_(variable_count) {
        // Who hits a set hits every set that contains it.
        std::ranges::stable_sort(sets, {}, &VariableSet::size);
        for (VariableSet& set : sets) {
            run.poll();
            const auto is_inside = [&set](const VariableSet& smaller) { return smaller.is_subset_of(set); };
            if (std::ranges::none_of(sets_, is_inside)) sets_.push_back(std::move(set));
        }
        for (std::size_t i = 0; i < variable_count; ++i) best_.insert(i);
        best_size_ = variable_count;
    }

    VariableSet minimum() && {
        const VariableSet nothing(variable_count_);
        search(nothing, 0, nothing);
        return std::move(best_);
    }

  private:
    void search(VariableSet chosen, std::size_t chosen_size, VariableSet forbidden) {
        run_.poll();
        // All sets ascend by size, so the greedy packing meets small sets first.
        const VariableSet* smallest = nullptr;
        std::size_t smallest_size = variable_count_ + 1;
        std::size_t packed = 0;
        VariableSet covered(variable_count_);
        for (const VariableSet& set : sets_) {
            if (set.meets(chosen)) continue;
            VariableSet allowed = set;
            allowed -= forbidden;
            const std::size_t size = allowed.size();
            if (size == 0) return; // this set cannot be hit any more
            if (size < smallest_size) {
                smallest = &set;
                smallest_size = size;
            }
            if (!allowed.meets(covered)) {
                covered |= allowed;
                ++packed;
            }
        }
        if (smallest == nullptr) {
            if (chosen_size < best_size_) {
                best_ = std::move(chosen);
                best_size_ = chosen_size;
            }
            return;
        }
        for (std::size_t i = 0; i < variable_count_; ++i) {
            if (chosen_size + packed >= best_size_) return;
            if (!smallest->contains(i) || forbidden.contains(i)) continue;
            chosen.insert(i);
            search(chosen, chosen_size + 1, forbidden);
            chosen.erase(i);
            forbidden.insert(i);
        }
    }

    std::size_t variable_count_;
    base::Run& run_;
    std::vector<VariableSet> sets_;
    VariableSet best_;
    std::size_t best_size_ = 0;
};

/// The variables outside a minimum hitting set of the supports of the leading monomials.
std::vector<std::size_t> independent_set(const Ideal& I, base::Run& run) {
    const std::size_t n = I.ring().variable_count();
    std::vector<VariableSet> supports;
    // A fixed order, so that the set does not depend on which bases happen to be known.
    for (const algebra::Polynomial& f : I.groebner_basis(groebner::cheap_order(I.ring()), run)) {
        VariableSet& support = supports.emplace_back(n);
        for (std::size_t i = 0; i < n; ++i) {
            if (f.exponent(0, i) != 0) support.insert(i);
        }
    }
    const VariableSet hit = HittingSet(std::move(supports), n, run).minimum();
    std::vector<std::size_t> independent;
    for (std::size_t i = 0; i < n; ++i) {
        if (!hit.contains(i)) independent.push_back(i);
    }
    return independent;
}

} // namespace

std::int64_t dimension(const Ideal& I, base::Run& run) {
    return I.is_unit(run) ? -1 : static_cast<std::int64_t>(independent_set(I, run).size());
}

std::int64_t codimension(const Ideal& I, base::Run& run) {
    return static_cast<std::int64_t>(I.ring().variable_count()) - dimension(I, run);
}

std::vector<std::size_t> maximal_independent_set(const Ideal& I, base::Run& run) {
    if (I.is_unit(run)) throw DomainError("no variables are independent modulo the unit ideal");
    return independent_set(I, run);
}

} // namespace eliminant::ideal
