#include "implicit/verify_hypersurface.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::implicit {

using algebra::Polynomial;

std::optional<HypersurfaceProof> prove_hypersurface(const RationalMap& map, const Polynomial& f,
                                                    base::Run& run) {
    const std::size_t n = map.components.size() - map.constants.size();
    auto rank = point_of_rank(map, n - 1, run);
    if (!rank) return std::nullopt;
    auto section = irreducible_section(f, n, run);
    if (!section) return std::nullopt;
    HypersurfaceProof proof{vanishing_bounds(map, f), {}, std::move(*rank), std::move(*section)};
    proof.primes = vanishing_primes(map, proof.bounds.height);
    std::vector<char> vanishes(proof.primes.size(), 0);
    base::parallel_for(run, vanishes.size(), [&](std::size_t i, std::size_t) {
        const algebra::PrimeField field(proof.primes[i]);
        vanishes[i] = vanishes_modulo(map, f, proof.bounds, field, run) ? 1 : 0;
    });
    if (std::ranges::find(vanishes, 0) != vanishes.end()) return std::nullopt;
    return proof;
}

} // namespace eliminant::implicit
