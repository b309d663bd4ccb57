#include "eliminant/groebner/f4.hpp"

#include "f4_computation.hpp"
#include "f4_hilbert.hpp"
#include "modular_basis.hpp"
#include "trace_proof.hpp"

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

/// The plain algorithm on the elements found together with the input, which generate the ideal if the basis
/// is right, and contain it in any case; so it proves the result, or corrects it.
GroebnerBasis proved_by_reductions(const Ring& ring, GroebnerBasis found,
                                   std::span<const Polynomial> generators, const BuchbergerOptions& options,
                                   base::Run& run) {
    std::vector<Polynomial> both = std::move(found.elements);
    both.insert(both.end(), generators.begin(), generators.end());
    GroebnerBasis proved =
        Computation(algebra::IntegerDomain{}, ring, both, options, run, !options.grading.empty()).run();
    proved.statistics += found.statistics;
    return proved;
}

GroebnerBasis over_rationals(const Ring& ring, std::span<const Polynomial> generators,
                             BuchbergerOptions options, base::Run& run,
                             const SparseSeries* hilbert_numerator) {
    options.linear_algebra = LinearAlgebra::exact; // it is learned once, and proofs rest on it
    for (const Polynomial& f : generators) algebra::require_same_ring(ring, f.ring(), "Groebner basis");
    const bool wants_proof = options.proof != Proof::none;
    ModularBasis images(ring, generators, options, PrimeSequence(seed_for(generators, run.seed())), run,
                        wants_proof ? F4Trace::Extent::elements : F4Trace::Extent::basis, hilbert_numerator);
    GroebnerBasis result;
    result.elements = images.find();
    result.statistics = images.trace().basis().statistics;
    result.statistics.primes = images.primes_used();
    if (!wants_proof) {
        result.proof = Proof::none;
        return result;
    }
    if (has_all_leading_monomials(images.trace(), generators, run) &&
        lies_in_ideal_of_generators(images.trace(), images.take_elements(), images.primes(), run))
        return result;
    return proved_by_reductions(ring, std::move(result), generators, options, run);
}

} // namespace

GroebnerBasis f4(const Ring& ring, std::span<const Polynomial> generators, const BuchbergerOptions& options,
                 base::Run& run) {
    return f4_with_hilbert_series(ring, generators, options, nullptr, run);
}

GroebnerBasis f4_with_hilbert_series(const Ring& ring, std::span<const Polynomial> generators,
                                     const BuchbergerOptions& options, const SparseSeries* hilbert_numerator,
                                     base::Run& run) {
    check_grading(ring, options);
    GroebnerBasis result;
    if (ring.field().is_rationals()) {
        if (options.stop_at || options.degree_bound)
            throw DomainError("F4 over QQ: the computation must not be stopped early");
        result = over_rationals(ring, generators, options, run, hilbert_numerator);
    } else {
        result = F4Computation(ring, generators, options, run, nullptr, hilbert_numerator).run();
    }
    result.algorithm = Algorithm::f4;
    return result;
}

} // namespace eliminant::groebner
