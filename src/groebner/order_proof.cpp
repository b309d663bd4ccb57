#include "groebner/order_proof.hpp"

#include "eliminant/algebra/arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace eliminant::groebner {

using algebra::Integer;
using algebra::Monomial;
using algebra::Polynomial;
using algebra::PolynomialBuilder;
using algebra::Ring;

namespace {

/// log₂ of the Euclidean norm of a column of (z − M)·diag(δ) for |z| = 1, rounded up: the entries are
/// the numerators, and at most the numerator plus δ on the diagonal.
double column_bits(const RationalQuotient::Vector& column, std::size_t diagonal) {
    const auto bits = [&](std::size_t c) {
        const std::size_t own = column.numerators[c].bit_length();
        return c == diagonal ? std::max(own, column.denominator.bit_length()) + 1 : own;
    };
    std::size_t largest = 0;
    for (std::size_t c = 0; c < column.numerators.size(); ++c) largest = std::max(largest, bits(c));
    double sum = 0; // of squares, in units of the largest
    for (std::size_t c = 0; c < column.numerators.size(); ++c)
        if (bits(c) != 0) sum += std::exp2(2 * (static_cast<double>(bits(c)) - static_cast<double>(largest)));
    return static_cast<double>(largest) + 0.5 * std::log2(sum) + 0.001;
}

double sum_bits(const std::vector<Integer>& numerators) {
    std::size_t largest = 0;
    for (const Integer& n : numerators) largest = std::max(largest, n.bit_length());
    return static_cast<double>(largest) + std::log2(static_cast<double>(numerators.size())) + 0.001;
}

Polynomial univariate(const Ring& ring, const std::vector<Integer>& coefficients) {
    PolynomialBuilder builder(ring);
    for (std::uint64_t i = 0; i < coefficients.size(); ++i)
        if (!coefficients[i].is_zero()) builder.add(coefficients[i], std::span(&i, 1));
    return builder.build();
}

/// The normal forms of monomials, each from that of a divisor.
class NormalForms {
  public:
    NormalForms(RationalQuotient& quotient, std::span<const std::size_t> variables)
        : quotient_(quotient), variables_(variables) {}

    /// m has a quotient by a variable that was asked for before, or is 1.
    const RationalQuotient::Vector& of(const Monomial& m) {
        if (m.is_one()) return known_.try_emplace(m.exponents(), quotient_.unit(0)).first->second;
        std::vector<std::uint64_t> exponents = m.exponents();
        for (std::size_t i = 0;; ++i) {
            if (exponents.at(i) == 0) continue;
            --exponents[i];
            if (const auto below = known_.find(exponents); below != known_.end())
                return known_
                    .try_emplace(m.exponents(), quotient_.times_variable(variables_[i], below->second))
                    .first->second;
            ++exponents[i];
        }
    }

  private:
    RationalQuotient& quotient_;
    std::span<const std::size_t> variables_;
    std::map<std::vector<std::uint64_t>, RationalQuotient::Vector> known_;
};

} // namespace

bool is_in_ideal(const LiftedBasis& candidate, RationalQuotient& quotient,
                 std::span<const std::size_t> variables, base::Run& run) {
    NormalForms normal_forms(quotient, variables);
    std::vector<const RationalQuotient::Vector*> standard;
    for (const Monomial& m : candidate.standard) {
        standard.push_back(&normal_forms.of(m));
        run.report([&] {
            return base::Progress{"proof of the new basis", standard.size(), candidate.standard.size()};
        });
    }
    for (std::size_t i = 0; i < candidate.leads.size(); ++i) {
        // lead − Σ (numerator/denominator)·standard, times the denominators of everything.
        const LiftedBasis::Vector& tail = candidate.tails[i];
        const RationalQuotient::Vector& lead = normal_forms.of(candidate.leads[i]);
        Integer common = lead.denominator;
        for (std::size_t s = 0; s < standard.size(); ++s)
            if (!tail.numerators[s].is_zero()) common = lcm(common, standard[s]->denominator);
        std::vector<Integer> sum(quotient.size());
        const auto add = [&](const RationalQuotient::Vector& v, Integer factor) {
            run.poll();
            Integer scale = common;
            scale.divide_exactly(v.denominator);
            factor *= scale;
            for (std::size_t c = 0; c < sum.size(); ++c)
                if (!v.numerators[c].is_zero()) sum[c].add_product(factor, v.numerators[c]);
        };
        add(lead, -tail.denominator);
        for (std::size_t s = 0; s < standard.size(); ++s)
            if (!tail.numerators[s].is_zero()) add(*standard[s], tail.numerators[s]);
        if (!std::ranges::all_of(sum, &Integer::is_zero)) return false;
    }
    return true;
}

ShapeProof::ShapeProof(RationalQuotient& quotient, std::size_t y, std::span<const std::size_t> others,
                       base::Run& run)
    : denominator_(1) {
    for (std::uint32_t b = 0; b < quotient.size(); ++b) {
        run.poll();
        const RationalQuotient::Vector column = quotient.product(y, b);
        bits_ += column_bits(column, b);
        denominator_ *= column.denominator;
    }
    form_bits_ = 31 + std::log2(static_cast<double>(quotient.size()));
    const RationalQuotient::Vector one = quotient.unit(0);
    for (const std::size_t j : others) {
        const RationalQuotient::Vector x = quotient.times_variable(j, one);
        variable_denominators_.push_back(x.denominator);
        variable_bits_.push_back(sum_bits(x.numerators));
    }
}

std::optional<double> ShapeProof::modulus_bits_needed(const LiftedBasis& candidate) const {
    // The bound, or the size of the candidate times the factor that makes it integral, whichever is larger,
    // and a bit for their sum.
    double needed = 0;
    const auto require = [&](const LiftedBasis::Vector& v, const Integer& factor, double bound_bits) {
        Integer cofactor;
        if (!factor.try_divide(v.denominator, cofactor)) return false;
        std::size_t largest = 0;
        for (const Integer& n : v.numerators) largest = std::max(largest, n.bit_length());
        needed = std::max({needed, bound_bits + 1, static_cast<double>(largest + cofactor.bit_length()) + 1});
        return true;
    };
    if (!require(candidate.tails.front(), denominator_, bits_)) return std::nullopt;
    if (variable_bits_.empty()) return needed; // the power of y is all there is
    if (!require(candidate.numerators.front(), denominator_, bits_ + form_bits_)) return std::nullopt;
    for (std::size_t j = 0; j < variable_bits_.size(); ++j)
        if (!require(candidate.numerators[j + 1], denominator_ * variable_denominators_[j],
                     bits_ + form_bits_ + variable_bits_[j]))
            return std::nullopt;
    return needed;
}

bool ShapeProof::follows(const LiftedBasis& candidate, base::Run& run) {
    const Ring ring(algebra::CoefficientField::rationals(), {"y"});
    std::vector<Integer> chi;
    for (const Integer& c : candidate.tails.front().numerators) chi.push_back(-c);
    chi.push_back(candidate.tails.front().denominator);
    const Polynomial modulus = univariate(ring, chi);
    for (std::size_t j = 1; j < candidate.leads.size(); ++j) {
        const LiftedBasis::Vector& q = candidate.tails[j];
        const LiftedBasis::Vector& n = candidate.numerators.front();
        const LiftedBasis::Vector& n_j = candidate.numerators[j];
        const auto scaled = [&](const std::vector<Integer>& f, const Integer& factor) {
            return univariate(ring, f).scaled(mpq_class(factor.to_mpz()));
        };
        const Polynomial left =
            multiply(univariate(ring, q.numerators), scaled(n.numerators, n_j.denominator), run);
        const Polynomial right = scaled(n_j.numerators, n.denominator * q.denominator);
        if (!try_divide(left - right, modulus, run)) return false;
    }
    return true;
}

} // namespace eliminant::groebner
