#include "eliminant/groebner/buchberger.hpp"

#include "eliminant/algebra/arithmetic.hpp"

#include <utility>

namespace eliminant::groebner {

using algebra::Polynomial;

GroebnerBasis buchberger(const algebra::Ring& ring, std::span<const Polynomial> generators,
                         const BuchbergerOptions& options, base::Run& run) {
    GroebnerBasis result;
    std::vector<Polynomial>& basis = result.elements;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    const auto insert = [&](const Polynomial& f) {
        for (std::size_t i = 0; i < basis.size(); ++i) pairs.emplace_back(i, basis.size());
        basis.push_back(f.primitive_part());
        return options.stop_at && options.stop_at(basis.back());
    };
    for (const Polynomial& f : generators) {
        algebra::require_same_ring(ring, f.ring(), "Groebner basis");
        if (!f.is_zero() && insert(f)) {
            result.complete = false;
            return result;
        }
    }
    while (!pairs.empty()) {
        std::size_t best = 0;
        const auto lcm_of = [&](std::size_t k) {
            return lcm(basis[pairs[k].first].leading_monomial(), basis[pairs[k].second].leading_monomial());
        };
        for (std::size_t k = 1; k < pairs.size(); ++k) {
            if (lcm_of(k) < lcm_of(best)) best = k;
        }
        const auto [i, j] = pairs[best];
        pairs.erase(pairs.begin() + static_cast<std::ptrdiff_t>(best));
        if (gcd(basis[i].leading_monomial(), basis[j].leading_monomial()).is_one()) continue;
        ++result.statistics.pairs_treated;
        const Polynomial r = normal_form(algebra::s_polynomial(basis[i], basis[j]), basis, run);
        if (!r.is_zero() && insert(r)) {
            result.complete = false;
            return result;
        }
    }
    basis = reduced_basis(std::move(basis), run);
    return result;
}

} // namespace eliminant::groebner
