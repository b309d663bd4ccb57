#include "eliminant/groebner/groebner_basis.hpp"

#include "algebra/fresh_name.hpp"
#include "eliminant/algebra/grading.hpp"
#include "eliminant/base/error.hpp"
#include "eliminant/groebner/f4.hpp"
#include "groebner/change_of_order.hpp"
#include "groebner/f4_hilbert.hpp"
#include "groebner/graded_order.hpp"
#include "groebner/hilbert_proof.hpp"
#include "groebner/monomial_ideal.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace eliminant::groebner {

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

std::vector<Polynomial> in_ring(std::span<const Polynomial> polynomials, const Ring& ring) {
    std::vector<Polynomial> result;
    for (const Polynomial& f : polynomials) result.push_back(f.ring() == ring ? f : f.in_ring(ring));
    return result;
}

/// F4, unless there is nothing but tails to reduce.
Algorithm suitable(const Ring& ring, std::span<const Polynomial> generators) {
    if (!ring.field().is_rationals()) return Algorithm::f4;
    return have_coprime_leads(generators) ? Algorithm::buchberger : Algorithm::f4;
}

/// In one order, by the algorithm asked for.
GroebnerBasis basis_directly(const Ring& ring, std::span<const Polynomial> generators,
                             const BasisOptions& options, base::Run& run) {
    BuchbergerOptions direct;
    direct.proof = options.proof;
    if (auto weights = weights_compared_first(ring); weights && !are_equal(*weights))
        direct.grading = std::move(*weights);
    const Algorithm algorithm =
        options.algorithm == Algorithm::automatic ? suitable(ring, generators) : options.algorithm;
    if (algorithm == Algorithm::buchberger) return buchberger(ring, generators, direct, run);
    if (options.proof == Proof::none && !ring.field().is_rationals())
        direct.linear_algebra = LinearAlgebra::probabilistic;
    return f4(ring, generators, direct, run);
}

/// In the order of `extended`, of the homogenisation by the last variable of the ideal with the graded basis.
/// Over ℚ modulo primes, for the Hilbert function then proves what was lifted: it takes 0.03 s instead of 2.5
/// for el_surf3.
GroebnerBasis basis_of_homogenization(const Ring& extended, std::span<const Polynomial> graded_basis,
                                      const BasisOptions& options, base::Run& run) {
    const std::size_t h = extended.variable_count() - 1;
    std::vector<Polynomial> homogeneous;
    for (const Polynomial& f : graded_basis) homogeneous.push_back(homogenize(f.in_ring(extended), h));
    if (options.algorithm == Algorithm::buchberger)
        return basis_directly(extended, homogeneous, options, run);
    // The homogenised elements are a basis in degrevlex with h last, and have the same leading monomials.
    std::vector<Exponents> leads = leading_exponents(graded_basis);
    for (Exponents& m : leads) m.push_back(0);
    const SparseSeries numerator = hilbert_numerator(std::move(leads), run);
    BuchbergerOptions direct;
    direct.proof = Proof::none;
    GroebnerBasis lifted = f4_with_hilbert_series(extended, homogeneous, direct, &numerator, run);
    if (!extended.field().is_rationals()) return lifted;
    if (options.proof == Proof::none) return lifted;
    if (!is_basis_of_homogenization(lifted.elements, h, graded_basis, run))
        return basis_directly(extended, homogeneous, options, run);
    lifted.proof = Proof::full;
    return lifted;
}

} // namespace

GroebnerBasis groebner_basis(const Ring& ring, std::span<const Polynomial> generators,
                             const BasisOptions& options, base::Run& run) {
    for (const Polynomial& f : generators) require_same_ring(ring, f.ring(), "Groebner basis");
    if (!is_cheaper_by_graded_basis(ring, generators)) return basis_directly(ring, generators, options, run);
    const Ring graded = ring.with_order(MonomialOrder::degrevlex());
    const GroebnerBasis basis = basis_directly(graded, in_ring(generators, graded), options, run);
    GroebnerBasis result = convert_basis(ring, basis.elements, options, run);
    result.statistics += basis.statistics;
    if (basis.proof != Proof::full) {
        result.proof = basis.proof;
        result.failure_bound += basis.failure_bound;
    }
    return result;
}

GroebnerBasis convert_basis(const Ring& target, std::span<const Polynomial> graded_basis,
                            const BasisOptions& options, base::Run& run) {
    if (weights_compared_first(target) || std::ranges::all_of(graded_basis, &Polynomial::is_homogeneous))
        return basis_directly(target, in_ring(graded_basis, target), options, run);
    if (auto changed = change_order(graded_basis, target, options.proof, run)) {
        GroebnerBasis result;
        result.elements = std::move(changed->elements);
        result.statistics.primes = changed->primes;
        result.proof = target.field().is_rationals() ? options.proof : Proof::full;
        result.algorithm = Algorithm::f4;
        return result;
    }
    const std::size_t n = target.variable_count();
    std::vector<std::string> names = target.names();
    names.push_back(fresh_name(target, "h"));
    const Ring extended(target.field(), std::move(names), with_last_resort(target.order(), n));
    GroebnerBasis result = basis_of_homogenization(extended, graded_basis, options, run);
    std::vector<std::size_t> without_h(n + 1, Polynomial::dropped);
    std::iota(without_h.begin(), without_h.end() - 1, std::size_t{0});
    for (Polynomial& f : result.elements) f = dehomogenize(f, n).in_ring(target, without_h);
    result.elements = reduced_basis(std::move(result.elements), run);
    return result;
}

} // namespace eliminant::groebner
