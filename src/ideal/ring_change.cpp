#include "ideal/ring_change.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::ideal {

using algebra::MonomialOrder;
using algebra::Polynomial;
using algebra::Ring;

namespace {

template <class T>
std::vector<T> selected(const std::vector<T>& all, std::span<const std::size_t> kept) {
    std::vector<T> result;
    for (const std::size_t i : kept) result.push_back(all[i]);
    return result;
}

/// The blocks of a product order among the kept variables, by their new indices.
std::vector<std::vector<std::size_t>> blocks_of(const std::vector<std::vector<std::size_t>>& blocks,
                                                std::span<const std::size_t> kept) {
    std::vector<std::vector<std::size_t>> result;
    for (const auto& block : blocks) {
        auto& image = result.emplace_back();
        for (const std::size_t i : block) {
            const auto found = std::ranges::find(kept, i);
            if (found != kept.end()) image.push_back(static_cast<std::size_t>(found - kept.begin()));
        }
    }
    std::erase_if(result, [](const auto& block) { return block.empty(); });
    return result;
}

MonomialOrder restricted(const MonomialOrder& order, std::span<const std::size_t> kept) {
    using Kind = MonomialOrder::Kind;
    if (kept.empty()) return MonomialOrder::degrevlex();
    switch (order.kind()) {
    case Kind::lex:
    case Kind::deglex:
    case Kind::degrevlex:
        break;
    case Kind::weighted:
        return MonomialOrder::weighted(selected(order.weights(), kept), order.tie_break());
    case Kind::elimination: {
        auto blocks = blocks_of(order.blocks(), kept);
        return blocks.empty() ? MonomialOrder::degrevlex() : MonomialOrder::blocks(std::move(blocks));
    }
    case Kind::matrix: {
        // The columns kept are as independent, and begin as positively, as they did among the others.
        std::vector<std::vector<std::int64_t>> rows;
        for (const auto& row : order.rows()) rows.push_back(selected(row, kept));
        return MonomialOrder::matrix(std::move(rows));
    }
    }
    return order;
}

} // namespace

Ring subring(const Ring& ring, std::span<const std::size_t> kept) {
    return {ring.field(), selected(ring.names(), kept), restricted(ring.order(), kept)};
}

std::vector<std::size_t> map_to_subring(const Ring& ring, std::span<const std::size_t> kept) {
    std::vector<std::size_t> map(ring.variable_count(), Polynomial::dropped);
    for (std::size_t i = 0; i < kept.size(); ++i) map[kept[i]] = i;
    return map;
}

std::vector<Polynomial> in_ring(std::span<const Polynomial> polynomials, const Ring& target) {
    std::vector<Polynomial> result;
    result.reserve(polynomials.size());
    for (const Polynomial& f : polynomials) result.push_back(f.ring() == target ? f : f.in_ring(target));
    return result;
}

std::vector<Polynomial> variables_of(const Ring& ring) {
    std::vector<Polynomial> result;
    for (std::size_t i = 0; i < ring.variable_count(); ++i) result.push_back(Polynomial::variable(ring, i));
    return result;
}

} // namespace eliminant::ideal
