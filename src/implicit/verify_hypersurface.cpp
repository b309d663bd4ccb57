#include "implicit/verify_hypersurface.hpp"

#include "eliminant/algebra/coefficients.hpp"

#include <utility>

namespace eliminant::implicit {

std::optional<Claims> prove_hypersurface(const RationalMap& map, const algebra::Polynomial& f,
                                         base::Run& run) {
    const std::size_t n = map.components.size() - map.constants.size();
    auto rank = rank_claim(map, n - 1, run);
    if (!rank) return std::nullopt;
    auto section = irreducible_section(f, n, run);
    if (!section) return std::nullopt;
    VanishingClaim vanishing = vanishing_claim(map, f);
    if (!vanishes(map, f, vanishing, run)) return std::nullopt;
    Claims claims;
    claims.theorem = Theorem::hypersurface;
    claims.codimension = 1;
    claims.degrees = {algebra::degree_in_first(f, n)};
    claims.vanishing.push_back(std::move(vanishing));
    claims.rank = std::move(*rank);
    claims.irreducible = std::move(section);
    return claims;
}

} // namespace eliminant::implicit
