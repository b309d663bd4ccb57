#pragma once

#include "reducer.hpp"

#include "eliminant/groebner/buchberger.hpp"

#include <cstdint>
#include <vector>

namespace eliminant::groebner {

/// A pair of basis elements whose S-polynomial waits, or a generator that waits for its first reduction.
struct CriticalPair {
    static constexpr std::uint32_t generator = ~std::uint32_t{0};

    std::uint32_t first = generator; ///< element, or `generator`
    std::uint32_t second = 0;        ///< element, or the number of the generator
    std::uint64_t sugar = 0;
    std::uint64_t degree = 0; ///< of the lcm in the grading
    std::vector<Word> lcm;    ///< of the two leading monomials; the leading monomial of a generator
};

/// The pairs that remain to be treated, best last, and the criteria that keep them few.
class PairQueue {
  public:
    /// \param by_degree whether selection normal goes by the degree of the lcm first
    /// \param grading kept as a reference
    /// \param run kept as a reference, and polled: an element can have a hundred thousand pairs
    PairQueue(Selection selection, bool by_degree, const Grading& grading, const base::Run& run)
        : selection_(selection), by_degree_(by_degree), grading_(grading), run_(run) {}

    bool empty() const { return pairs_.empty(); }
    std::size_t size() const { return pairs_.size(); }
    const CriticalPair& best() const { return pairs_.back(); }
    void remove_best(std::size_t count = 1) { pairs_.resize(pairs_.size() - count); }
    /// The best pair and all others of the same sugar (selection sugar) or degree (selection normal), best
    /// last.
    std::vector<CriticalPair> best_batch() const;

    void add_generator(const MonomialLayout& layout, std::uint32_t number, const Word* lead);
    /// The generators added come first, all together, whatever their degrees.
    void advance_generators(const MonomialLayout& layout);

    /// Accounts for the element `added`, the last of the basis: forms its pairs with the elements that are
    /// not redundant, and discards pairs, old and new, that the criteria make superfluous. Throws
    /// LayoutTooNarrow (and has changed nothing) where an lcm does not fit. After Stopped the queue is of no
    /// more use.
    template <class Element>
    void update(const Basis<Element>& basis, std::uint32_t added, Statistics& statistics);

    void widen(const MonomialLayout& from, const MonomialLayout& to);

  private:
    struct NewPair {
        CriticalPair pair;
        bool coprime;
    };

    template <class Element>
    std::vector<NewPair> pairs_with(const Basis<Element>& basis, std::uint32_t added) const;
    std::vector<CriticalPair> filter_new(const MonomialLayout& layout, std::vector<NewPair> fresh,
                                         Statistics& statistics) const;
    template <class Element>
    void filter_old(const Basis<Element>& basis, std::uint32_t added, Statistics& statistics);
    /// Whether a is to be treated after b.
    bool later(const MonomialLayout& layout, const CriticalPair& a, const CriticalPair& b) const;

    Selection selection_;
    bool by_degree_;
    const Grading& grading_;
    const base::Run& run_;
    std::vector<CriticalPair> pairs_; ///< sorted, the one to be treated next is the last
};

} // namespace eliminant::groebner
