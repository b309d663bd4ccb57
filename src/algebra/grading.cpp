#include "eliminant/algebra/grading.hpp"

#include "eliminant/algebra/evaluation.hpp"

#include "term_maps.hpp"

#include <algorithm>
#include <string>

namespace eliminant::algebra {

namespace {

constexpr std::uint64_t max_degree = std::uint64_t{1} << 63;

/// The weighted degree of each term, from exponents and weights whose products may exceed a word.
class Grading {
  public:
    Grading(const Ring& ring, std::span<const std::uint64_t> weights)
        : weights_(weights.begin(), weights.end()), count_(ring.variable_count()) {
        if (weights_.empty()) weights_.assign(count_, 1);
        if (weights_.size() != count_)
            throw DomainError(std::to_string(weights_.size()) + " weights for the variables of " +
                              ring.to_string());
    }

    std::uint64_t weight(std::size_t variable) const { return weights_[variable]; }

    std::uint64_t degree(const Polynomial& f, std::size_t term) const {
        base::UInt128 sum = 0;
        for (std::size_t v = 0; v < count_; ++v) {
            sum += static_cast<base::UInt128>(f.exponent(term, v)) * weights_[v];
            if (sum >= max_degree) throw OverflowError("a weighted degree exceeds 2^63 - 1");
        }
        return static_cast<std::uint64_t>(sum);
    }

  private:
    std::vector<std::uint64_t> weights_;
    std::size_t count_;
};

/// The terms for which keep(index) holds.
template <class Keep>
Polynomial selected_terms(const Polynomial& f, const Keep& keep) {
    return visit_terms(f, [&](const auto& terms, const auto& /*domain*/) {
        auto result = std::decay_t<decltype(terms)>(*terms.layout);
        for (std::size_t i = 0; i < terms.size(); ++i) {
            if (keep(i)) result.push_back(terms.monomial(i), terms.coefficients[i]);
        }
        return over_denominator_of(f, std::move(result));
    });
}

} // namespace

std::int64_t weighted_degree(const Polynomial& f, std::span<const std::uint64_t> weights) {
    const Grading grading(f.ring(), weights);
    std::int64_t degree = -1;
    for (std::size_t i = 0; i < f.size(); ++i)
        degree = std::max(degree, static_cast<std::int64_t>(grading.degree(f, i)));
    return degree;
}

bool is_homogeneous(const Polynomial& f, std::span<const std::uint64_t> weights) {
    const Grading grading(f.ring(), weights);
    for (std::size_t i = 1; i < f.size(); ++i) {
        if (grading.degree(f, i) != grading.degree(f, 0)) return false;
    }
    return true;
}

Polynomial homogeneous_part(const Polynomial& f, std::uint64_t degree,
                            std::span<const std::uint64_t> weights) {
    const Grading grading(f.ring(), weights);
    return selected_terms(f, [&](std::size_t i) { return grading.degree(f, i) == degree; });
}

Polynomial leading_form(const Polynomial& f, std::span<const std::uint64_t> weights) {
    if (f.is_zero()) return f;
    return homogeneous_part(f, static_cast<std::uint64_t>(weighted_degree(f, weights)), weights);
}

Polynomial homogenize(const Polynomial& f, std::size_t variable, std::span<const std::uint64_t> weights) {
    require_variable(f.ring(), variable);
    const Grading grading(f.ring(), weights);
    const std::uint64_t weight = grading.weight(variable);
    const std::string& name = f.ring().names()[variable];
    if (weight == 0) throw DomainError("homogenisation with '" + name + "', whose weight is 0");
    if (f.is_zero()) return f;
    const auto degree = static_cast<std::uint64_t>(weighted_degree(f, weights));
    PolynomialBuilder builder(f.ring());
    std::vector<std::uint64_t> exponents(f.ring().variable_count());
    for (std::size_t i = 0; i < f.size(); ++i) {
        const std::uint64_t missing = degree - grading.degree(f, i);
        if (missing % weight != 0) {
            throw DomainError("homogenisation with '" + name + "' of weight " + std::to_string(weight) +
                              ": a term lacks degree " + std::to_string(missing));
        }
        f.layout().decode(f.packed_monomial(i), exponents);
        exponents[variable] += missing / weight;
        if (f.ring().field().is_rationals())
            builder.add(f.integer_terms().coefficients[i], f.denominator(), exponents);
        else
            builder.add(Integer(f.residue_terms().coefficients[i]), exponents);
    }
    return builder.build();
}

Polynomial dehomogenize(const Polynomial& f, std::size_t variable) {
    base::Run run;
    return evaluate(f, variable, 1, run);
}

} // namespace eliminant::algebra
