#include "graded_order.hpp"

#include <algorithm>

namespace eliminant::groebner {

using algebra::Polynomial;

bool have_coprime_leads(std::span<const Polynomial> polynomials) {
    std::vector<bool> seen(polynomials.empty() ? 0 : polynomials.front().ring().variable_count(), false);
    for (const Polynomial& f : polynomials) {
        if (f.is_zero()) continue;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            if (f.exponent(0, i) == 0) continue;
            if (seen[i]) return false;
            seen[i] = true;
        }
    }
    return true;
}

std::optional<std::vector<std::uint64_t>> weights_compared_first(const algebra::Ring& ring) {
    const auto keys = ring.order().keys(ring.variable_count());
    if (keys.empty() || keys.front().reversed) return std::nullopt;
    if (!std::ranges::all_of(keys.front().weights, [](std::uint64_t w) { return w > 0; }))
        return std::nullopt;
    return keys.front().weights;
}

algebra::MonomialOrder cheap_order(const algebra::Ring& ring) {
    return weights_compared_first(ring) ? ring.order() : algebra::MonomialOrder::degrevlex();
}

bool is_cheaper_by_graded_basis(const algebra::Ring& ring, std::span<const Polynomial> generators) {
    return !weights_compared_first(ring) && !have_coprime_leads(generators) &&
           !std::ranges::all_of(generators, &Polynomial::is_homogeneous);
}

} // namespace eliminant::groebner
