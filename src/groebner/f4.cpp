#include "eliminant/groebner/f4.hpp"

#include "f4_computation.hpp"
#include "modular_basis.hpp"

#include <utility>

namespace eliminant::groebner {

using algebra::Polynomial;
using algebra::Ring;

namespace {

/// Mixes the coefficients of the input into the seed: whoever makes an input with the first primes of its own
/// sequence in mind changes the sequence.
std::uint64_t seed_for(std::span<const Polynomial> generators, std::uint64_t seed) {
    constexpr std::uint64_t modulus = 2147483647;
    algebra::Random mixer(seed);
    for (const Polynomial& f : generators) {
        for (const algebra::Integer& c : f.integer_terms().coefficients)
            mixer = algebra::Random(mixer() ^ c.residue(modulus));
    }
    return mixer();
}

GroebnerBasis over_rationals(const Ring& ring, std::span<const Polynomial> generators,
                             const BuchbergerOptions& options, base::Run& run) {
    for (const Polynomial& f : generators) algebra::require_same_ring(ring, f.ring(), "Groebner basis");
    ModularBasis images(ring, generators, options, PrimeSequence(seed_for(generators, run.seed())), run);
    GroebnerBasis result;
    result.elements = images.find();
    result.statistics = images.trace().basis().statistics;
    result.statistics.primes = images.primes_used();
    result.proof = Proof::none;
    if (options.proof == Proof::none) return result;
    std::vector<Polynomial> both = std::move(result.elements);
    both.insert(both.end(), generators.begin(), generators.end());
    GroebnerBasis proved =
        Computation(algebra::IntegerDomain{}, ring, both, options, run, !options.grading.empty()).run();
    proved.statistics += result.statistics;
    return proved;
}

} // namespace

GroebnerBasis f4(const Ring& ring, std::span<const Polynomial> generators, const BuchbergerOptions& options,
                 base::Run& run) {
    check_grading(ring, options);
    GroebnerBasis result;
    if (ring.field().is_rationals()) {
        if (options.stop_at || options.degree_bound)
            throw DomainError("F4 over QQ: the computation must not be stopped early");
        result = over_rationals(ring, generators, options, run);
    } else {
        result = F4Computation(ring, generators, options, run, nullptr).run();
    }
    result.algorithm = Algorithm::f4;
    return result;
}

} // namespace eliminant::groebner
