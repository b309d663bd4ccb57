#include "ideal/basis_computation.hpp"

#include "eliminant/algebra/grading.hpp"
#include "eliminant/groebner/buchberger.hpp"
#include "ideal/ring_change.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace eliminant::ideal {

using algebra::MonomialOrder;
using algebra::Polynomial;
using algebra::Ring;

namespace {

using Weights = std::vector<std::uint64_t>;

bool are_equal(const Weights& weights) {
    return std::ranges::adjacent_find(weights, std::not_equal_to<>()) == weights.end();
}

/// The order that compares by `order` in the first n variables, and in one more where these agree.
///
/// In a product order the last variable may as well join the last block, as it does: of polynomials that are
/// homogeneous it is only these that the order has to compare.
MonomialOrder with_last_resort(const MonomialOrder& order, std::size_t n) {
    switch (order.kind()) {
    case MonomialOrder::Kind::lex:
    case MonomialOrder::Kind::elimination:
        return order;
    case MonomialOrder::Kind::weighted:
        if (order.tie_break() == MonomialOrder::TieBreak::lex) {
            Weights weights = order.weights();
            weights.push_back(0);
            return MonomialOrder::weighted(std::move(weights), MonomialOrder::TieBreak::lex);
        }
        break;
    case MonomialOrder::Kind::matrix: {
        auto rows = order.rows();
        for (auto& row : rows) row.push_back(0);
        rows.emplace_back(n + 1, 0).back() = 1;
        return MonomialOrder::matrix(std::move(rows));
    }
    case MonomialOrder::Kind::deglex:
    case MonomialOrder::Kind::degrevlex:
        break;
    }
    throw DomainError("an order that compares degrees first needs no homogenisation");
}

} // namespace

std::optional<Weights> weights_compared_first(const Ring& ring) {
    const auto keys = ring.order().keys(ring.variable_count());
    if (keys.empty() || keys.front().reversed) return std::nullopt;
    if (!std::ranges::all_of(keys.front().weights, [](std::uint64_t w) { return w > 0; }))
        return std::nullopt;
    return keys.front().weights;
}

MonomialOrder cheap_order(const Ring& ring) {
    return weights_compared_first(ring) ? ring.order() : MonomialOrder::degrevlex();
}

std::vector<Polynomial> basis_directly(const Ring& target, std::span<const Polynomial> generators,
                                       base::Run& run) {
    groebner::BuchbergerOptions options;
    if (auto weights = weights_compared_first(target); weights && !are_equal(*weights))
        options.grading = std::move(*weights);
    return groebner::buchberger(target, in_ring(generators, target), options, run).elements;
}

std::vector<Polynomial> basis_by_homogenization(const Ring& target, std::span<const Polynomial> graded_basis,
                                                base::Run& run) {
    const std::size_t n = target.variable_count();
    std::vector<std::string> names = target.names();
    names.push_back(fresh_name(target, "h"));
    const Ring extended(target.field(), std::move(names), with_last_resort(target.order(), n));
    std::vector<Polynomial> homogeneous;
    for (const Polynomial& f : graded_basis) homogeneous.push_back(homogenize(f.in_ring(extended), n));
    std::vector<std::size_t> without_h(n + 1, Polynomial::dropped);
    std::iota(without_h.begin(), without_h.end() - 1, std::size_t{0});
    std::vector<Polynomial> basis;
    for (const Polynomial& f : groebner::buchberger(extended, homogeneous, {}, run).elements)
        basis.push_back(dehomogenize(f, n).in_ring(target, without_h));
    return groebner::reduced_basis(std::move(basis), run);
}

} // namespace eliminant::ideal
