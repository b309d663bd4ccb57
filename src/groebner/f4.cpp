#include "eliminant/groebner/f4.hpp"

#include "basis_proof.hpp"
#include "f4_computation.hpp"
#include "f4_hilbert.hpp"
#include "modular_basis.hpp"
#include "trace_proof.hpp"

#include "eliminant/algebra/arithmetic.hpp"

#include <algorithm>
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

bool are_homogeneous(std::span<const Polynomial> generators) {
    return std::ranges::all_of(generators, &Polynomial::is_homogeneous);
}

/// Whether the basis found is proved to be the one of the generators' ideal I. Three statements: it has all
/// leading monomials of I, it lies in I, it is a Groebner basis of an ideal that contains I. The first two
/// are enough, as are the last two, and the last one for homogeneous generators: see f4().
bool is_proved(ModularBasis& images, std::span<const Polynomial> found,
               std::span<const Polynomial> generators, const BuchbergerOptions& options, base::Run& run) {
    const bool lifted_all = images.extent() == F4Trace::Extent::elements;
    if (!lifted_all || !has_all_leading_monomials(images.trace(), generators, run)) {
        const bool is_basis_of_more = is_proved_groebner(found, options, images.primes(), run) &&
                                      std::ranges::all_of(generators, [&](const Polynomial& f) {
                                          return normal_form(f.primitive_part(), found, run).is_zero();
                                      });
        if (!is_basis_of_more) return false;
    }
    return !lifted_all ||
           lies_in_ideal_of_generators(images.trace(), images.take_elements(), images.primes(), run);
}

GroebnerBasis over_rationals(const Ring& ring, std::span<const Polynomial> generators,
                             BuchbergerOptions options, base::Run& run,
                             const SparseSeries* hilbert_numerator) {
    options.linear_algebra = LinearAlgebra::exact; // it is learned once, and proofs rest on it
    for (const Polynomial& f : generators) algebra::require_same_ring(ring, f.ring(), "Groebner basis");
    const bool wants_proof = options.proof != Proof::none;
    const auto lifted = [&](const F4Trace& trace) {
        if (!wants_proof) return F4Trace::Extent::basis;
        // With a series given, the trace need not have all leading monomials modulo its prime.
        const bool has_all =
            hilbert_numerator == nullptr && has_all_leading_monomials(trace, generators, run);
        const bool can_do_without = are_homogeneous(generators) && !has_all;
        return can_do_without ? F4Trace::Extent::basis : F4Trace::Extent::elements;
    };
    ModularBasis images(ring, generators, options, PrimeSequence(seed_for(generators, run.seed())), run,
                        lifted, hilbert_numerator);
    GroebnerBasis result;
    result.elements = images.find();
    result.statistics = images.trace().basis().statistics;
    result.statistics.primes = images.primes_used();
    if (!wants_proof) {
        result.proof = Proof::none;
        return result;
    }
    if (is_proved(images, result.elements, generators, options, run)) return result;
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
