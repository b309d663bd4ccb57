#include "eliminant/groebner/buchberger.hpp"

#include "computation.hpp"

namespace eliminant::groebner {

using algebra::Polynomial;
using algebra::Ring;

namespace {

GroebnerBasis over_rationals(const Ring& ring, std::span<const Polynomial> generators,
                             const BuchbergerOptions& options, base::Run& run) {
    const bool by_degree = !options.grading.empty();
    Computation first(algebra::IntegerDomain{}, ring, generators, options, run, by_degree);
    first.use_shadow();
    GroebnerBasis found = first.run();
    if (options.proof == Proof::none || found.proof == Proof::full) return found;
    std::vector<Polynomial> both = std::move(found.elements);
    both.insert(both.end(), generators.begin(), generators.end());
    GroebnerBasis proved = Computation(algebra::IntegerDomain{}, ring, both, options, run, by_degree).run();
    proved.statistics += found.statistics;
    return proved;
}

} // namespace

Statistics& Statistics::operator+=(const Statistics& other) {
    pairs_treated += other.pairs_treated;
    skipped_by_product += other.skipped_by_product;
    skipped_by_chain_m += other.skipped_by_chain_m;
    skipped_by_chain_f += other.skipped_by_chain_f;
    skipped_by_chain_b += other.skipped_by_chain_b;
    zero_reductions += other.zero_reductions;
    reduction_steps += other.reduction_steps;
    zero_modulo_prime += other.zero_modulo_prime;
    basis_elements_made += other.basis_elements_made;
    primes += other.primes;
    matrices.insert(matrices.end(), other.matrices.begin(), other.matrices.end());
    return *this;
}

const MatrixStatistics* Statistics::largest_matrix() const {
    const auto area = [](const MatrixStatistics& matrix) { return matrix.rows * matrix.columns; };
    const auto largest = std::ranges::max_element(matrices, {}, area);
    return largest == matrices.end() ? nullptr : &*largest;
}

double MatrixStatistics::density() const {
    if (rows == 0 || columns == 0) return 0;
    return static_cast<double>(entries) / (static_cast<double>(rows) * static_cast<double>(columns));
}

GroebnerBasis buchberger(const Ring& ring, std::span<const Polynomial> generators,
                         const BuchbergerOptions& options, base::Run& run) {
    check_grading(ring, options);
    if (ring.field().is_rationals()) return over_rationals(ring, generators, options, run);
    return Computation(algebra::PrimeDomain{ring.field().prime_field()}, ring, generators, options, run,
                       !options.grading.empty())
        .run();
}

} // namespace eliminant::groebner
