#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// Which critical pair is treated next.
enum class Selection {
    normal, ///< least lcm in the ring's order (Buchberger 1985); by degree first where a grading is given
    sugar,  ///< least sugar, then least lcm (Giovini, Mora, Niesi, Robbiano, Traverso 1991)
};

/// What F4 did with one batch of pairs.
struct MatrixStatistics {
    std::uint64_t degree = 0;          ///< largest sugar of its pairs and generators
    std::uint64_t pairs = 0;           ///< treated together
    std::uint64_t rows = 0;            ///< those to be reduced and those they are reduced by
    std::uint64_t columns = 0;         ///< monomials
    std::uint64_t entries = 0;         ///< that are not 0
    std::uint64_t new_elements = 0;    ///< rows that were left
    std::uint64_t zero_reductions = 0; ///< pairs that gave none

    /// Share of the entries that are not 0.
    double density() const;
};

/// What a basis computation did, and what each criterion saved.
struct Statistics {
    std::uint64_t pairs_treated = 0;      ///< S-polynomials formed and reduced
    std::uint64_t skipped_by_product = 0; ///< coprime leading monomials
    std::uint64_t skipped_by_chain_m = 0; ///< Gebauer–Möller M: an lcm of a new pair properly divides it
    std::uint64_t skipped_by_chain_f = 0; ///< Gebauer–Möller F: another new pair has the same lcm
    std::uint64_t skipped_by_chain_b = 0; ///< Gebauer–Möller B: old pairs made superfluous by the new element
    std::uint64_t zero_reductions = 0;    ///< treated pairs that reduced to zero
    std::uint64_t reduction_steps = 0;    ///< subtractions of a multiple of a basis element
    std::uint64_t zero_modulo_prime = 0;   ///< pairs passed over in the first pass over ℚ
    std::uint64_t basis_elements_made = 0; ///< elements that entered the basis, redundant ones included

    std::uint64_t primes = 0;               ///< F4 over ℚ: primes of which images were made
    std::vector<MatrixStatistics> matrices; ///< F4, in sequence; over ℚ modulo the prime that was learned

    /// The matrix with the largest area, null if there was none.
    const MatrixStatistics* largest_matrix() const;
    Statistics& operator+=(const Statistics& other);
};

/// What computes a basis.
enum class Algorithm {
    automatic,  ///< whatever suits the input
    buchberger, ///< one pair after the other: buchberger()
    f4,         ///< many pairs as the rows of a matrix: f4()
};

/// How far a basis is proved.
enum class Proof {
    full, ///< by the theorems named at buchberger() and f4()
    /// Over GF(p), LinearAlgebra::probabilistic: all elements are in the ideal, and the probability that they
    /// are not all is at most GroebnerBasis::failure_bound.
    bounded,
    /// By buchberger(): S-polynomials that vanish modulo one word-size prime were taken for zero. All
    /// elements are in the ideal, but whether they are all is not proved. By f4(): it passed the test named
    /// there. No bound of the probability of an error is known.
    none,
};

/// How F4 finds what the rows of a matrix add to the basis.
enum class LinearAlgebra {
    exact, ///< reduces every row
    /// Reduces random combinations of blocks of rows until several vanish, as a combination of rows of which
    /// some still has something to add does with probability 1/p only (as in Monagan and Pearce, PASCO 2015).
    /// Most rows reduce to zero, so this saves most of the work: katsura-10 takes 0.2 s instead of 0.6.
    /// Fields of fewer than 2^16 elements are treated exactly.
    probabilistic,
};

/// How a basis is computed; a complete basis does not depend on it.
struct BuchbergerOptions {
    Selection selection = Selection::sugar;
    Proof proof = Proof::full;
    LinearAlgebra linear_algebra = LinearAlgebra::exact; ///< F4 only
    /// Degrees of the variables for sugar and for degree-by-degree treatment (positive); all 1 when empty.
    /// With input that is homogeneous for them, the computation proceeds degree by degree and the basis
    /// elements of a degree are complete when the next one begins.
    std::vector<std::uint64_t> grading;
    /// Pairs whose degree (in `grading`) exceeds it are not treated: for homogeneous input the result is then
    /// the basis up to that degree.
    std::optional<std::uint64_t> degree_bound;
    /// Asked for each new element; true ends the computation with that element last in an incomplete basis.
    std::function<bool(const algebra::Polynomial&)> stop_at;
};

/// A Groebner basis, or what is known of one.
struct GroebnerBasis {
    /// If complete: the reduced basis, ascending by leading monomial; over ℚ primitive integer polynomials
    /// with positive leading coefficient, over GF(p) monic. Otherwise elements of the ideal, among them all
    /// found in the degrees that were finished; the last one is the one at which the computation was stopped.
    std::vector<algebra::Polynomial> elements;
    bool complete = true;
    Proof proof = Proof::full;
    /// With Proof::bounded: a bound of the probability that elements are missing, over the random choices
    /// (which start from Run::seed()); 0 with Proof::full.
    double failure_bound = 0;
    Algorithm algorithm = Algorithm::buchberger; ///< what it was computed by; never `automatic`
    Statistics statistics;
};

/// The reduced Groebner basis of the ideal of the generators in the order of their ring, by Buchberger's
/// algorithm. {1} for the unit ideal, empty for the zero ideal. All generators are of `ring`
/// (RingMismatchError).
///
/// Over ℚ the arithmetic is fraction-free on primitive integer polynomials. Most S-polynomials reduce to
/// zero, and over ℚ they take most of the time (95% on chandra-9), so the basis is found in two passes: the
/// first passes over those that vanish modulo a prime; the second is the plain algorithm on the elements
/// found together with the input, which generate the same ideal, and so proves the result, or corrects it.
/// Polls `run`.
GroebnerBasis buchberger(const algebra::Ring& ring, std::span<const algebra::Polynomial> generators,
                         const BuchbergerOptions& options, base::Run& run);

/// The reduced basis of the ideal that a Groebner basis generates: minimal, inter-reduced, normalised,
/// ascending.
std::vector<algebra::Polynomial> reduced_basis(std::vector<algebra::Polynomial> basis, base::Run& run);

/// Whether every S-polynomial of the elements reduces to zero by them (Buchberger's criterion). It uses no
/// pair criteria and shares no code with the algorithm; quadratic in the number of elements.
bool is_groebner(std::span<const algebra::Polynomial> elements, base::Run& run);

/// Whether the elements are the reduced Groebner basis of what they generate, in the normalisation of
/// GroebnerBasis.
bool is_reduced_groebner(std::span<const algebra::Polynomial> elements, base::Run& run);

} // namespace eliminant::groebner

namespace eliminant {
using groebner::Algorithm;
using groebner::buchberger;
using groebner::BuchbergerOptions;
using groebner::GroebnerBasis;
using groebner::is_groebner;
using groebner::is_reduced_groebner;
using groebner::reduced_basis;
} // namespace eliminant
