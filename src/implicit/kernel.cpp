#include "implicit/kernel.hpp"

#include "eliminant/base/error.hpp"
#include "implicit/remaindering.hpp"

#include <algorithm>
#include <list>
#include <utility>

namespace eliminant::implicit {

using algebra::Polynomial;

namespace {

/// The elements of the ideal of the graph, over the field of `ring`, in the kept variables: a reduced basis,
/// or the first one.
std::vector<Polynomial> kept_elements(const GradedMap& map, const algebra::Ring& ring, bool first_only,
                                      groebner::Statistics& statistics, base::Run& run) {
    std::vector<Polynomial> generators;
    for (const Polynomial& f : map.generators) generators.push_back(f.in_ring(ring));
    groebner::BuchbergerOptions options;
    options.grading = map.weights;
    const auto is_kept = [&map](const Polynomial& f) { return map.is_kept(f); };
    if (first_only) options.stop_at = is_kept;
    groebner::GroebnerBasis basis = buchberger(ring, generators, options, run);
    statistics += basis.statistics;
    if (!basis.complete) return {std::move(basis.elements.back())};
    std::erase_if(basis.elements, [&](const Polynomial& f) { return !is_kept(f); });
    return std::move(basis.elements);
}

bool proves(const mpz_class& modulus, const GradedMap& map, const std::vector<Polynomial>& elements) {
    return std::ranges::all_of(
        elements, [&](const Polynomial& f) { return 2 * vanishing_bound(map, f).to_mpz() < modulus; });
}

} // namespace

Kernel kernel_by_primes(const GradedMap& map, Codimension codimension, base::Run& run) {
    const bool first_only = codimension == Codimension::one_at_most;
    Kernel kernel;
    if (first_only) {
        // A generator Xᵢ − fᵢ^h without eliminated variables is irreducible, being linear in Xᵢ, so it
        // generates a principal prime. Modulo p it could be met before elements of lower degree.
        const auto kept =
            std::ranges::find_if(map.generators, [&](const Polynomial& f) { return map.is_kept(f); });
        if (kept != map.generators.end()) {
            kernel.generators.push_back(kept->primitive_part());
            return kernel;
        }
    }
    std::list<Remaindering> attempts;
    std::uint64_t p = algebra::PrimeField::max_characteristic + 1;
    for (;;) {
        p = algebra::previous_prime(p);
        ++kernel.primes_used;
        run.report([&] {
            return Progress{"elimination modulo primes", kernel.primes_used, 0, "prime " + std::to_string(p)};
        });
        const algebra::Ring ring = map.ring.with_field(algebra::CoefficientField::prime(p));
        std::vector<Polynomial> images = kept_elements(map, ring, first_only, kernel.statistics, run);
        if (images.empty()) return kernel; // N(p) = 0, so N = 0
        for (Polynomial& f : images) f = f.monic();
        auto attempt =
            std::ranges::find_if(attempts, [&](const Remaindering& a) { return a.accepts(images); });
        if (attempt == attempts.end()) attempt = attempts.emplace(attempts.end(), map.ring);
        attempt->add(images, run);
        auto elements = attempt->reconstruct(run);
        if (elements && proves(attempt->modulus(), map, *elements)) {
            kernel.generators = std::move(*elements);
            return kernel;
        }
    }
}

Kernel kernel_over_rationals(const GradedMap& map, base::Run& run) {
    Kernel kernel;
    kernel.generators = kept_elements(map, map.ring, false, kernel.statistics, run);
    return kernel;
}

} // namespace eliminant::implicit
