#include "modular_basis.hpp"

#include "eliminant/algebra/arithmetic.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <string>
#include <utility>

namespace eliminant::groebner {

using algebra::Integer;
using algebra::Polynomial;
using algebra::Ring;

namespace {

std::vector<std::size_t> sizes_of(const F4Trace& trace, F4Trace::Extent extent) {
    if (extent == F4Trace::Extent::elements)
        return {trace.element_sizes().begin(), trace.element_sizes().end()};
    std::vector<std::size_t> sizes;
    for (const Polynomial& f : trace.basis().elements) sizes.push_back(f.size());
    return sizes;
}

std::vector<std::uint32_t> residues_of(const std::vector<Polynomial>& basis) {
    std::vector<std::uint32_t> residues;
    for (const Polynomial& f : basis) {
        const auto& coefficients = f.residue_terms().coefficients;
        residues.insert(residues.end(), coefficients.begin(), coefficients.end());
    }
    return residues;
}

bool agrees(const F4Trace::Image& image) { return image.replay == Replay::agrees; }

std::size_t count(const std::vector<F4Trace::Image>& images, Replay outcome) {
    return static_cast<std::size_t>(std::ranges::count(images, outcome, &F4Trace::Image::replay));
}

/// Whether the images speak against the learned prime.
bool are_suspicious(const std::vector<F4Trace::Image>& images) {
    return count(images, Replay::leads_differ) > count(images, Replay::agrees) ||
           count(images, Replay::support_differs) > 0;
}

bool have_same_leads(const F4Trace& a, const F4Trace& b) {
    return std::ranges::equal(a.basis().elements, b.basis().elements, [](const auto& f, const auto& g) {
        return f.leading_monomial().exponents() == g.leading_monomial().exponents();
    });
}

/// Whether a prime taught more than another one, given the images of the same primes by both: more monomials
/// (a coefficient that is 0 modulo some primes need not be 0), else what more primes agree with.
bool is_better(const F4Trace& a, const std::vector<F4Trace::Image>& images_by_a, const F4Trace& b,
               const std::vector<F4Trace::Image>& images_by_b) {
    if (have_same_leads(a, b) && a.coefficient_count() != b.coefficient_count())
        return a.coefficient_count() > b.coefficient_count();
    return count(images_by_a, Replay::agrees) > count(images_by_b, Replay::agrees);
}

/// The polynomial with the monomials of f, whose ring differs from `ring` in the field only.
Polynomial with_coefficients(const Polynomial& f, const Ring& ring,
                             const std::vector<Integer>& coefficients) {
    algebra::IntegerTerms terms(ring.layout(f.layout().bits()));
    terms.reserve(coefficients.size());
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        if (!coefficients[i].is_zero()) terms.push_back(f.packed_monomial(i), coefficients[i]);
    }
    return Polynomial::from_terms(ring, std::move(terms));
}

} // namespace

ModularBasis::Attempt::Attempt(F4Trace learned, F4Trace::Extent lifted)
    : trace(std::move(learned)), extent(lifted), lifting(sizes_of(trace, lifted)) {
    if (extent == F4Trace::Extent::basis) lifting.add(trace.prime(), residues_of(trace.basis().elements));
}

ModularBasis::ModularBasis(const Ring& ring, std::span<const Polynomial> generators,
                           const BuchbergerOptions& options, PrimeSequence primes, base::Run& run,
                           F4Trace::Extent lifted)
    : ModularBasis(ring, generators, options, std::move(primes), run,
                   [lifted](const F4Trace&) { return lifted; }) {}

ModularBasis::ModularBasis(const Ring& ring, std::span<const Polynomial> generators,
                           const BuchbergerOptions& options, PrimeSequence primes, base::Run& run,
                           std::function<F4Trace::Extent(const F4Trace&)> lifted,
                           const SparseSeries* hilbert_numerator)
    : ring_(ring), generators_(generators.begin(), generators.end()), options_(options),
      primes_(std::move(primes)), run_(run), extent_(std::move(lifted)),
      hilbert_numerator_(hilbert_numerator) {}

ModularBasis::Attempt ModularBasis::learn() {
    for (;;) {
        ++primes_used_;
        if (auto trace =
                F4Trace::learn(ring_, generators_, primes_.next(), options_, run_, hilbert_numerator_)) {
            const F4Trace::Extent lifted = extent_(*trace);
            return {std::move(*trace), lifted};
        }
    }
}

/// Replays modulo more primes; the number grows in proportion to those there are. Threads share the rows of
/// a matrix, so it takes many of them before there are packs that one thread alone would not have made.
void ModularBasis::add_batch() {
    const std::size_t known = attempt_->lifting.prime_count();
    const std::size_t packs = std::max<std::size_t>(1 + known / (8 * lane_count), run_.threads() / 8);
    std::vector<std::uint32_t> primes(packs * lane_count);
    for (std::uint32_t& p : primes) p = primes_.next();
    primes_used_ += primes.size();
    Images images = attempt_->trace.replay(primes, run_, attempt_->extent);
    if (are_suspicious(images)) {
        Attempt other = learn();
        Images others = other.trace.replay(primes, run_, other.extent);
        if (is_better(other.trace, others, attempt_->trace, images)) {
            attempt_ = std::move(other);
            witness_.reset();
            images = std::move(others);
        }
    }
    for (F4Trace::Image& image : images) {
        if (!agrees(image)) continue;
        if (witness_) attempt_->lifting.add(witness_->prime, std::move(witness_->coefficients));
        witness_ = std::move(image);
    }
}

bool ModularBasis::agrees_with_witness() {
    return witness_ && attempt_->lifting.agrees(witness_->prime, witness_->coefficients, run_);
}

/// By the image of the witness, which is that of the lifted basis.
bool ModularBasis::generators_reduce_to_zero() const {
    const Ring image_ring = ring_.with_field(algebra::CoefficientField::prime(witness_->prime));
    const std::vector<Polynomial> basis = image_of_basis(*witness_, image_ring);
    std::atomic<bool> all_vanish{true};
    base::parallel_for(run_, generators_.size(), [&](std::size_t i, std::size_t) {
        if (!all_vanish.load(std::memory_order_relaxed)) return;
        const Polynomial f = generators_[i].primitive_part().in_ring(image_ring);
        if (!normal_form(f, basis, run_).is_zero()) all_vanish.store(false, std::memory_order_relaxed);
    });
    return all_vanish.load();
}

/// The number of the lifted vector that belongs to an element of the basis.
std::size_t ModularBasis::vector_of(std::size_t element) const {
    if (extent() == F4Trace::Extent::basis) return element;
    // Among all elements those of the basis come last, descending.
    const auto numbers = attempt_->trace.element_numbers();
    return numbers[numbers.size() - 1 - element];
}

std::vector<Polynomial> ModularBasis::image_of_basis(const F4Trace::Image& image,
                                                     const Ring& image_ring) const {
    const std::vector<Polynomial>& learned = attempt_->trace.basis().elements;
    std::vector<std::size_t> begins = {0};
    for (const std::size_t size : sizes_of(attempt_->trace, extent())) begins.push_back(begins.back() + size);
    std::vector<Polynomial> result;
    for (std::size_t k = 0; k < learned.size(); ++k) {
        run_.poll();
        const Polynomial& f = learned[k];
        const std::uint32_t* coefficients = image.coefficients.data() + begins[vector_of(k)];
        algebra::ResidueTerms terms(image_ring.layout(f.layout().bits()));
        terms.reserve(f.size());
        for (std::size_t i = 0; i < f.size(); ++i) {
            if (coefficients[i] != 0) terms.push_back(f.packed_monomial(i), coefficients[i]);
        }
        result.push_back(Polynomial::from_terms(image_ring, std::move(terms)));
    }
    return result;
}

std::vector<Polynomial> ModularBasis::polynomials() const {
    const std::vector<Polynomial>& learned = attempt_->trace.basis().elements;
    const auto& vectors = attempt_->lifting.vectors();
    std::vector<Polynomial> result(learned.size(), Polynomial(ring_));
    base::parallel_for(run_, learned.size(), [&](std::size_t i, std::size_t) {
        result[i] = with_coefficients(learned[i], ring_, vectors[vector_of(i)].numerators);
    });
    return result;
}

std::vector<Polynomial> ModularBasis::find() {
    if (!attempt_) begin();
    for (;;) {
        add_batch();
        run_.report([this] {
            return base::Progress{"lifting", attempt_->lifting.prime_count(), 0,
                                  std::to_string(attempt_->lifting.entry_count()) + " coefficients"};
        });
        if (!attempt_->lifting.lift(run_) || !agrees_with_witness()) continue;
        if (generators_reduce_to_zero()) return polynomials();
        begin(); // modulo the learned prime a generator was superfluous that is not
    }
}

void ModularBasis::begin() {
    attempt_ = learn();
    witness_.reset();
}

} // namespace eliminant::groebner
