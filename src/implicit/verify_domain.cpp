#include "implicit/verify_domain.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/calculus.hpp"
#include "eliminant/algebra/coefficients.hpp"
#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/algebra/gcd.hpp"

#include <algorithm>
#include <numeric>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::PrimeField;
using algebra::RationalFunction;
using Element = PrimeField::Element;

namespace {

std::vector<std::size_t> indices_below(std::size_t count) {
    std::vector<std::size_t> indices(count);
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    return indices;
}

/// A generator of the ideal of the zeros of f outside those of the denominator.
Polynomial generator_of_domain(const Polynomial& f, const Polynomial& denominator, std::size_t parameters,
                               base::Run& run) {
    Polynomial result = primitive_part(squarefree_part(f, run), indices_below(parameters), run);
    return divide_exactly(result, gcd(result, denominator, run), run).primitive_part();
}

} // namespace

DomainMap domain_map(const algebra::Ring& ring, std::size_t parameter_count,
                     std::span<const CosineSine> rotations, std::span<const Polynomial> relations,
                     std::span<const RationalFunction> functions, base::Run& run) {
    DomainMap map{ring, parameter_count, {}, Polynomial::constant(ring, 1), {}};
    for (const RationalFunction& f : functions) map.denominator = lcm(map.denominator, f.denominator, run);
    mpz_class scale = map.denominator.denominator().to_mpz();
    for (const RationalFunction& f : functions) {
        map.numerators.push_back(
            multiply(f.numerator, divide_exactly(map.denominator, f.denominator, run), run));
        scale = lcm(scale, map.numerators.back().denominator().to_mpz());
    }
    for (Polynomial& f : map.numerators) f = f.scaled(mpq_class(scale));
    map.denominator = map.denominator.scaled(mpq_class(scale));

    for (const Polynomial& f : relations) map.relations.push_back(f.primitive_part());
    for (const auto& [cosine, sine] : rotations) {
        const Polynomial c = Polynomial::variable(ring, cosine);
        const Polynomial s = Polynomial::variable(ring, sine);
        map.relations.push_back(c * c + s * s - Polynomial::constant(ring, 1));
    }
    if (map.relations.size() == 1)
        map.relations.front() =
            generator_of_domain(map.relations.front(), map.denominator, parameter_count, run);
    return map;
}

std::optional<std::vector<Polynomial>> as_basis(const DomainMap& map,
                                                const std::vector<std::uint64_t>& weights) {
    if (weights.size() != map.ring.variable_count() ||
        std::ranges::find(weights, std::uint64_t{0}) != weights.end())
        return std::nullopt;
    const algebra::Ring ring = map.ring.with_order(
        algebra::MonomialOrder::weighted(weights, algebra::MonomialOrder::TieBreak::revlex));
    std::vector<Polynomial> basis;
    for (const Polynomial& f : map.relations) basis.push_back(f.in_ring(ring));
    for (std::size_t variable = 0; variable < weights.size(); ++variable)
        if (std::ranges::count_if(basis, [&](const Polynomial& f) { return f.exponent(0, variable) > 0; }) >
            1)
            return std::nullopt;
    return basis;
}

namespace {

/// f at the coordinates times a power of the denominator, reduced after each product.
class Substitution {
  public:
    Substitution(const DomainMap& map, const std::vector<Polynomial>& basis, base::Run& run)
        : basis_(basis), run_(run),
          ring_(basis.front().ring()), denominator_powers_{Polynomial::constant(ring_, 1)},
          denominator_(map.denominator.in_ring(ring_)), parameter_count_(map.parameter_count) {
        for (const Polynomial& f : map.numerators) numerators_.push_back(reduced(f.in_ring(ring_)));
    }

    Polynomial operator()(const Polynomial& f) {
        std::uint64_t degree = 0;
        for (std::size_t i = 0; i < f.size(); ++i) {
            std::uint64_t sum = 0;
            for (std::size_t j = 0; j < numerators_.size(); ++j) sum += f.exponent(i, j);
            degree = std::max(degree, sum);
        }
        return value(f, 0, degree);
    }

  private:
    Polynomial reduced(const Polynomial& f) { return normal_form(f, basis_, run_); }

    /// Of a polynomial without the coordinates before `first`, with a power of the denominator for what is
    /// missing to `degree`; by Horner's scheme.
    Polynomial value(const Polynomial& f, std::size_t first, std::uint64_t degree) {
        if (first == numerators_.size())
            return reduced(multiply(constants_of(f), denominator_power(degree), run_));
        std::vector<algebra::CoefficientTerm> terms = coefficients(f, first);
        std::ranges::sort(terms, std::ranges::greater(), [](const auto& term) { return term.exponents[0]; });
        Polynomial result(ring_);
        std::uint64_t exponent = terms.empty() ? 0 : terms.front().exponents[0];
        const auto lower_to = [&](std::uint64_t target) {
            for (; exponent > target; --exponent)
                result = reduced(multiply(result, numerators_[first], run_));
        };
        for (const algebra::CoefficientTerm& term : terms) {
            lower_to(term.exponents[0]);
            result += value(term.coefficient, first + 1, degree - term.exponents[0]);
        }
        lower_to(0);
        return result;
    }

    Polynomial constants_of(const Polynomial& f) const {
        std::vector<std::size_t> places(f.ring().variable_count(), 0);
        for (std::size_t i = numerators_.size(); i < places.size(); ++i)
            places[i] = parameter_count_ + i - numerators_.size();
        return f.in_ring(ring_, places);
    }

    const Polynomial& denominator_power(std::uint64_t exponent) {
        while (denominator_powers_.size() <= exponent)
            denominator_powers_.push_back(reduced(multiply(denominator_powers_.back(), denominator_, run_)));
        return denominator_powers_[exponent];
    }

    const std::vector<Polynomial>& basis_;
    base::Run& run_;
    algebra::Ring ring_;
    std::vector<Polynomial> denominator_powers_;
    Polynomial denominator_;
    std::size_t parameter_count_;
    std::vector<Polynomial> numerators_;
};

} // namespace

bool vanishes(const DomainMap& map, const Polynomial& f, const std::vector<Polynomial>& basis,
              base::Run& run) {
    return Substitution(map, basis, run)(f).is_zero();
}

DomainModulo::DomainModulo(const DomainMap& map, const PrimeField& field)
    : map_(map), field_(field), denominator_gradient_(algebra::gradient(map.denominator)) {
    for (const Polynomial& f : map.relations) relation_gradients_.push_back(algebra::gradient(f));
    for (const Polynomial& f : map.numerators) numerator_gradients_.push_back(algebra::gradient(f));
}

namespace {

std::size_t rank_of(std::vector<std::vector<Element>> rows, const PrimeField& field) {
    std::size_t rank = 0;
    for (std::size_t column = 0; !rows.empty() && column < rows.front().size(); ++column) {
        const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                        [column](const auto& row) { return row[column] != 0; });
        if (pivot == rows.end()) continue;
        std::swap(*pivot, rows[rank]);
        const Element inverse = field.inverse(rows[rank][column]);
        for (std::size_t i = rank + 1; i < rows.size(); ++i) {
            const Element factor = field.multiply(rows[i][column], inverse);
            for (std::size_t j = column; j < rows[i].size(); ++j)
                rows[i][j] = field.subtract(rows[i][j], field.multiply(factor, rows[rank][j]));
        }
        ++rank;
    }
    return rank;
}

} // namespace

std::optional<std::size_t> DomainModulo::rank_at(std::span<const Element> point, base::Run& run) const {
    const auto value = [&](const Polynomial& f) { return evaluate(f, field_, point, run); };
    if (!std::ranges::all_of(map_.relations, [&](const Polynomial& f) { return value(f) == 0; }))
        return std::nullopt;
    const Element bottom = value(map_.denominator);
    if (bottom == 0) return std::nullopt;
    std::vector<std::vector<Element>> rows;
    for (const std::vector<Polynomial>& gradient : relation_gradients_) {
        auto& row = rows.emplace_back();
        for (std::size_t i = 0; i < map_.parameter_count; ++i) row.push_back(value(gradient[i]));
    }
    if (rank_of(rows, field_) < rows.size()) return std::nullopt;
    for (std::size_t k = 0; k < map_.numerators.size(); ++k) {
        auto& row = rows.emplace_back();
        const Element top = value(map_.numerators[k]);
        for (std::size_t i = 0; i < map_.parameter_count; ++i) // the differential of N/D, times D²
            row.push_back(field_.subtract(field_.multiply(value(numerator_gradients_[k][i]), bottom),
                                          field_.multiply(top, value(denominator_gradient_[i]))));
    }
    // On the tangent space, where the gradients of the relations are zero.
    return rank_of(std::move(rows), field_) - map_.relations.size();
}

std::vector<Element> DomainModulo::image(std::span<const Element> point, base::Run& run) const {
    const Element inverse = field_.inverse(evaluate(map_.denominator, field_, point, run));
    std::vector<Element> coordinates;
    for (const Polynomial& f : map_.numerators)
        coordinates.push_back(field_.multiply(evaluate(f, field_, point, run), inverse));
    return coordinates;
}

std::size_t monomial_count(std::size_t variables, std::uint64_t degree, std::size_t limit) {
    std::size_t count = 1;
    for (std::size_t i = 1; i <= variables; ++i) {
        if (degree >= limit || count >= limit) return limit;
        count = count * (degree + i) / i; // a binomial coefficient in each step
    }
    return std::min(count, limit);
}

IndependentPoints::IndependentPoints(const PrimeField& field, std::size_t coordinates, std::uint64_t degree)
    : field_(field) {
    std::vector<std::uint32_t> exponents(coordinates, 0);
    std::uint64_t sum = 0;
    for (;;) { // all exponent vectors, the first exponent running fastest
        exponents_.push_back(exponents);
        std::size_t i = 0;
        while (i < coordinates && sum == degree) {
            sum -= exponents[i];
            exponents[i++] = 0;
        }
        if (i == coordinates) return;
        ++exponents[i];
        ++sum;
    }
}

bool IndependentPoints::add(std::span<const Element> point) {
    std::vector<std::uint64_t> row;
    std::vector<std::vector<Element>> powers(point.size(), {1});
    for (const std::vector<std::uint32_t>& exponents : exponents_) {
        Element value = 1;
        for (std::size_t i = 0; i < point.size(); ++i) {
            while (powers[i].size() <= exponents[i])
                powers[i].push_back(field_.multiply(powers[i].back(), point[i]));
            value = field_.multiply(value, powers[i][exponents[i]]);
        }
        row.push_back(value);
    }
    constexpr std::size_t summands = 14; // products below 2^60, and a residue, in 64 bits
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        const std::uint64_t factor = field_.negate(field_.reduce(row[pivots_[k]]));
        for (std::size_t j = pivots_[k]; j < row.size(); ++j) row[j] += factor * rows_[k][j];
        if (k % summands == summands - 1)
            for (std::uint64_t& value : row) value = field_.reduce(value);
    }
    std::vector<Element> residues;
    for (const std::uint64_t value : row) residues.push_back(field_.reduce(value));
    const auto pivot = std::ranges::find_if(residues, [](Element value) { return value != 0; });
    if (pivot == residues.end()) return false;
    const Element inverse = field_.inverse(*pivot);
    pivots_.push_back(static_cast<std::size_t>(pivot - residues.begin()));
    for (Element& value : residues) value = field_.multiply(value, inverse);
    rows_.push_back(std::move(residues));
    return true;
}

std::string refutation(const DomainMap& map, const DomainClaim& claim,
                       std::optional<std::uint64_t> lower_degree, base::Run& run) {
    if (claim.prime >= DomainModulo::prime_bound || !algebra::is_prime(claim.prime))
        return "the domain is looked at modulo a number that is too large, or no prime";
    const PrimeField field(claim.prime);
    const DomainModulo domain(map, field);
    const std::size_t needed =
        lower_degree ? monomial_count(map.numerators.size(), *lower_degree, claim.points.size() + 1) : 1;
    if (claim.points.size() != needed) return "the points of the domain are more, or fewer, than needed";
    std::optional<IndependentPoints> independent;
    if (lower_degree) independent.emplace(field, map.numerators.size(), *lower_degree);
    for (const std::vector<std::uint32_t>& point : claim.points) {
        run.poll();
        if (point.size() != map.ring.variable_count() ||
            std::ranges::any_of(point, [&](Element value) { return value >= claim.prime; }))
            return "a point of the domain is none of this space";
        if (domain.rank_at(point, run) != std::optional<std::size_t>(claim.rank))
            return "a point is no smooth one of the domain with the rank claimed";
        if (independent && !independent->add(domain.image(point, run)))
            return "a polynomial of lower degree is zero at the images of all points";
    }
    return {};
}

} // namespace eliminant::implicit
