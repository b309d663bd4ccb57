#include "pair_queue.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace eliminant::groebner {

bool PairQueue::later(const MonomialLayout& layout, const CriticalPair& a, const CriticalPair& b) const {
    if (selection_ == Selection::sugar && a.sugar != b.sugar) return a.sugar > b.sugar;
    if (by_degree_ && a.degree != b.degree) return a.degree > b.degree;
    const int side = layout.compare(a.lcm.data(), b.lcm.data());
    if (side != 0) return side > 0;
    return std::pair(a.second, a.first) > std::pair(b.second, b.first); // a total order, for determinism
}

void PairQueue::add_generator(const MonomialLayout& layout, std::uint32_t number, const Word* lead) {
    CriticalPair entry;
    entry.second = number;
    entry.lcm.assign(lead, lead + layout.words());
    entry.degree = grading_.degree(layout, lead);
    entry.sugar = entry.degree;
    const auto place = std::ranges::upper_bound(
        pairs_, entry, [&](const CriticalPair& a, const CriticalPair& b) { return later(layout, a, b); });
    pairs_.insert(place, std::move(entry));
}

void PairQueue::advance_generators(const MonomialLayout& layout) {
    for (CriticalPair& pair : pairs_) {
        if (pair.first == CriticalPair::generator) pair.degree = pair.sugar = 0;
    }
    std::ranges::sort(pairs_,
                      [&](const CriticalPair& a, const CriticalPair& b) { return later(layout, a, b); });
}

std::vector<CriticalPair> PairQueue::best_batch() const {
    const auto alike = [this](const CriticalPair& pair) {
        return selection_ == Selection::sugar ? pair.sugar == best().sugar : pair.degree == best().degree;
    };
    auto begin = pairs_.end();
    while (begin != pairs_.begin() && alike(*std::prev(begin))) --begin;
    return {begin, pairs_.end()};
}

template <class Element>
std::vector<PairQueue::NewPair> PairQueue::pairs_with(const Basis<Element>& basis,
                                                      std::uint32_t added) const {
    const MonomialLayout& layout = basis.layout();
    const Word* lead = basis.lead(added);
    std::vector<NewPair> fresh;
    for (std::uint32_t i = 0; i < added; ++i) {
        run_.poll();
        if (basis[i].redundant) continue;
        NewPair entry{{i, added, 0, 0, std::vector<Word>(layout.words())},
                      layout.coprime(basis.lead(i), lead)};
        if (!layout.lcm(basis.lead(i), lead, entry.pair.lcm.data())) throw LayoutTooNarrow{};
        entry.pair.degree = grading_.degree(layout, entry.pair.lcm.data());
        // Sugar of an S-polynomial: degree of the lcm plus the larger of sugar − degree of the two.
        entry.pair.sugar = entry.pair.degree + std::max(basis[i].excess, basis[added].excess);
        fresh.push_back(std::move(entry));
    }
    return fresh;
}

/// Criteria M and F of Gebauer and Möller (1988) and the product criterion, on pairs that share their new
/// element.
///
/// M: the pair (i, k) is superfluous if lcm(j, k) divides lcm(i, k) properly for another pair (j, k), itself
/// kept or not: properness makes the argument descend. F: of pairs with equal lcm one is enough; and if one
/// of them is coprime, its S-polynomial reduces to zero and all go. The trap is to apply the product
/// criterion first: a coprime pair must still excuse others before it goes.
std::vector<CriticalPair> PairQueue::filter_new(const MonomialLayout& layout, std::vector<NewPair> fresh,
                                                Statistics& statistics) const {
    std::ranges::sort(fresh, [&](const NewPair& a, const NewPair& b) {
        run_.poll();
        const int side = layout.compare(a.pair.lcm.data(), b.pair.lcm.data());
        if (side != 0) return side < 0;
        if (a.coprime != b.coprime) return a.coprime; // stands for its class of equal lcms
        return std::pair(a.pair.sugar, a.pair.first) < std::pair(b.pair.sugar, b.pair.first);
    });
    std::vector<NewPair> kept; // ascending lcms, pairwise distinct, none divides another
    std::vector<std::uint64_t> masks;
    for (NewPair& candidate : fresh) {
        run_.poll();
        const Word* lcm = candidate.pair.lcm.data();
        const std::uint64_t mask = layout.divisibility_mask(lcm);
        bool excused = false;
        for (std::size_t k = 0; k < kept.size() && !excused; ++k) {
            if ((masks[k] & ~mask) != 0 || !layout.divides(kept[k].pair.lcm.data(), lcm)) continue;
            excused = true;
            if (layout.equal(kept[k].pair.lcm.data(), lcm))
                ++statistics.skipped_by_chain_f;
            else
                ++statistics.skipped_by_chain_m;
        }
        if (excused) continue;
        kept.push_back(std::move(candidate));
        masks.push_back(mask);
    }
    std::vector<CriticalPair> result;
    for (NewPair& entry : kept) {
        if (entry.coprime)
            ++statistics.skipped_by_product;
        else
            result.push_back(std::move(entry.pair));
    }
    return result;
}

/// Criterion B: an old pair (i, j) is superfluous if the new leading monomial divides its lcm and the lcms of
/// (i, k) and (j, k) both differ from it. With equality the three pairs could excuse one another in a circle.
template <class Element>
void PairQueue::filter_old(const Basis<Element>& basis, std::uint32_t added, Statistics& statistics) {
    const MonomialLayout& layout = basis.layout();
    const Word* lead = basis.lead(added);
    std::vector<Word> with_added(layout.words());
    const auto differs = [&](std::uint32_t i, const std::vector<Word>& lcm) {
        // lcm(i, added) divides `lcm` here, so it fits.
        return layout.lcm(basis.lead(i), lead, with_added.data()) &&
               !layout.equal(with_added.data(), lcm.data());
    };
    const std::size_t removed = std::erase_if(pairs_, [&](const CriticalPair& pair) {
        run_.poll();
        return pair.first != CriticalPair::generator && layout.divides(lead, pair.lcm.data()) &&
               differs(pair.first, pair.lcm) && differs(pair.second, pair.lcm);
    });
    statistics.skipped_by_chain_b += removed;
}

template <class Element>
void PairQueue::update(const Basis<Element>& basis, std::uint32_t added, Statistics& statistics) {
    const MonomialLayout& layout = basis.layout();
    std::vector<CriticalPair> kept = filter_new(layout, pairs_with(basis, added), statistics);
    filter_old(basis, added, statistics);
    const auto order = [&](const CriticalPair& a, const CriticalPair& b) {
        run_.poll();
        return later(layout, a, b);
    };
    std::ranges::sort(kept, order);
    const auto middle = static_cast<std::ptrdiff_t>(pairs_.size());
    pairs_.insert(pairs_.end(), std::move_iterator(kept.begin()), std::move_iterator(kept.end()));
    std::ranges::inplace_merge(pairs_, pairs_.begin() + middle, order);
}

void PairQueue::widen(const MonomialLayout& from, const MonomialLayout& to) {
    for (CriticalPair& pair : pairs_) {
        std::vector<Word> wide(to.words());
        static_cast<void>(to.repack(from, pair.lcm.data(), wide.data())); // wider: fits
        pair.lcm = std::move(wide);
    }
}

template void PairQueue::update(const Basis<std::uint32_t>&, std::uint32_t, Statistics&);
template void PairQueue::update(const Basis<algebra::Integer>&, std::uint32_t, Statistics&);

} // namespace eliminant::groebner
