#include "groebner/order_lifting.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace eliminant::groebner {

using algebra::MonomialOrder;
using algebra::Polynomial;
using algebra::PolynomialBuilder;
using algebra::PrimeField;
using algebra::Ring;

namespace {

/// How the standard monomials, ascending, of one image compare with those of another: greater for the better
/// ones, which come first where the two begin to differ, or go on when the others end.
std::strong_ordering compare_standard(const ConvertedBasis& a, const ConvertedBasis& b) {
    const auto [x, y] = std::ranges::mismatch(a.standard, b.standard);
    if (x == a.standard.end() || y == b.standard.end()) return a.standard.size() <=> b.standard.size();
    return *y <=> *x;
}

} // namespace

ConvertedBasis convert(QuotientAlgebra& algebra, const Ring& target, std::span<const std::size_t> variables,
                       bool try_shape, base::Run& run) {
    if (try_shape)
        if (auto basis = fglm_in_shape_position(algebra, target, variables, run)) return *std::move(basis);
    return fglm(algebra, target, variables, run);
}

OrderLifting::OrderLifting(const Staircase& staircase, std::span<const Polynomial> basis, const Ring& target,
                           std::vector<std::size_t> variables, base::Run& run)
    : staircase_(staircase), basis_(basis), target_(target), variables_(std::move(variables)), run_(run),
      last_prime_(PrimeField::max_characteristic),
      try_shape_(target.order().kind() == MonomialOrder::Kind::lex || target.variable_count() == 1) {}

ChangedOrder OrderLifting::compute(Proof proof) {
    // Each round of primes grows with the number of those before, as the cost of a lifting that fails does.
    for (std::size_t wanted = 2;; wanted += std::max<std::size_t>(run_.threads(), wanted / 4)) {
        while (!lifting_ || lifting_->prime_count() < wanted) {
            const std::size_t have = lifting_ ? lifting_->prime_count() : 0;
            for (const Image& image : next_images(wanted - have)) add(image);
        }
        run_.report([&] { return base::Progress{"change of order, primes", lifting_->prime_count(), 0}; });
        if (lift_and_check() && (proof == Proof::none || is_proved())) break;
    }
    return {polynomials(), lifting_->prime_count()};
}

std::vector<OrderLifting::Image> OrderLifting::next_images(std::size_t count) {
    std::vector<Image> images(count);
    for (Image& image : images) {
        do last_prime_ = algebra::previous_prime(last_prime_);
        while (!QuotientAlgebra::has_good_reduction(basis_, PrimeField(last_prime_)));
        image.prime = static_cast<std::uint32_t>(last_prime_);
    }
    base::parallel_for(run_, count, [&](std::size_t i, std::size_t) {
        QuotientAlgebra algebra(staircase_, basis_, PrimeField(images[i].prime), run_);
        images[i].basis = convert(algebra, target_, variables_, try_shape_, run_);
    });
    return images;
}

void OrderLifting::add(const Image& image) {
    const auto comparison =
        lifting_ ? compare_standard(image.basis, pattern_) : std::strong_ordering::greater;
    if (comparison > 0) begin(image.basis);
    if (comparison < 0) return; // an unlucky prime
    // A prime modulo which the random form happened to have a shorter recurrence gives no numerators.
    if (image.basis.numerators.size() != pattern_.numerators.size()) return;
    lifting_->add(image.prime, residues(image.basis));
}

void OrderLifting::begin(const ConvertedBasis& basis) {
    pattern_ = basis;
    // Once the first image is not in shape position, to try again with each prime would only cost.
    try_shape_ = is_shape();
    std::vector<std::size_t> sizes(basis.tails.size() + basis.numerators.size(), basis.standard.size());
    lifting_.emplace(sizes);
}

std::vector<std::uint32_t> OrderLifting::residues(const ConvertedBasis& basis) const {
    std::vector<std::uint32_t> result;
    result.reserve(lifting_->entry_count());
    for (const auto* vectors : {&basis.tails, &basis.numerators})
        for (const auto& v : *vectors) result.insert(result.end(), v.begin(), v.end());
    return result;
}

/// Whether vectors are found that agree with all primes, one of which had no part in finding them.
bool OrderLifting::lift_and_check() {
    if (!lifting_->lift(run_)) return false;
    Image extra;
    do extra = std::move(next_images(1).front());
    while (compare_standard(extra.basis, pattern_) < 0 ||
           extra.basis.numerators.size() != pattern_.numerators.size());
    const bool same_pattern = compare_standard(extra.basis, pattern_) == 0;
    bool agrees = same_pattern && lifting_->agrees(extra.prime, residues(extra.basis), run_);
    for (std::size_t i = 0; i < lifting_->prime_count() && agrees; ++i)
        agrees = lifting_->agrees_with_added(i, run_);
    add(extra);
    return agrees;
}

LiftedBasis OrderLifting::candidate() const {
    const std::span vectors(lifting_->vectors());
    const std::size_t tails = pattern_.leads.size();
    return {pattern_.standard, pattern_.leads, vectors.first(tails), vectors.subspan(tails)};
}

bool OrderLifting::is_proved() {
    if (is_shape()) return is_proved_in_shape_position();
    RationalQuotient quotient(staircase_, basis_, run_);
    return is_in_ideal(candidate(), quotient, variables_, run_);
}

bool OrderLifting::is_proved_in_shape_position() {
    if (!ShapeProof::follows(candidate(), run_)) return false;
    RationalQuotient quotient(staircase_, basis_, run_);
    // The numerators come in the sequence of the leads: from the last of the other variables to the first.
    std::vector<std::size_t> others(variables_.rbegin() + 1, variables_.rend());
    const ShapeProof proof(quotient, variables_.back(), others, run_);
    const std::optional<double> needed = proof.modulus_bits_needed(candidate());
    if (!needed) return false;
    double bits = 0;
    for (const std::uint32_t p : lifting_->primes()) bits += std::log2(p);
    while (bits < *needed * (1 + 1e-9)) {
        const auto missing = static_cast<std::size_t>((*needed - bits) / 31) + 1;
        run_.report([&] {
            return base::Progress{"change of order, primes of the proof", lifting_->prime_count(),
                                  lifting_->prime_count() + missing};
        });
        for (const Image& image : next_images(std::min(missing, std::size_t{8} * run_.threads()))) {
            if (compare_standard(image.basis, pattern_) != 0 ||
                image.basis.numerators.size() != pattern_.numerators.size())
                continue;
            const bool agrees = lifting_->agrees(image.prime, residues(image.basis), run_);
            lifting_->add(image.prime, residues(image.basis));
            if (!agrees) return false;
            bits += std::log2(image.prime);
        }
    }
    return true;
}

std::vector<Polynomial> OrderLifting::polynomials() const {
    std::vector<Polynomial> result;
    const LiftedBasis basis = candidate();
    for (std::size_t i = 0; i < basis.leads.size(); ++i) {
        const LiftedBasis::Vector& tail = basis.tails[i];
        PolynomialBuilder builder(target_);
        builder.add(tail.denominator, basis.leads[i].exponents());
        for (std::size_t s = 0; s < basis.standard.size(); ++s)
            if (!tail.numerators[s].is_zero())
                builder.add(-tail.numerators[s], basis.standard[s].exponents());
        result.push_back(builder.build().primitive_part());
    }
    return result;
}

} // namespace eliminant::groebner
