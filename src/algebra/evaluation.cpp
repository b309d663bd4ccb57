#include "eliminant/algebra/evaluation.hpp"

#include "integer_power.hpp"
#include "term_maps.hpp"

#include <string>
#include <unordered_map>

namespace eliminant::algebra {

namespace {

/// Powers of one integer, each computed once.
class IntegerPowers {
  public:
    explicit IntegerPowers(Integer base) : base_(std::move(base)) {}

    bool trivial() const { return base_.is_one(); }
    const Integer& operator()(std::uint64_t exponent) {
        const auto [entry, missing] = powers_.try_emplace(exponent);
        if (missing) entry->second = checked_power(base_, exponent);
        return entry->second;
    }

  private:
    Integer base_;
    std::unordered_map<std::uint64_t, Integer> powers_;
};

/// ∏ values[i]^exponent(variables[i]) of a term. Over ℚ as numerators over the common denominator
/// ∏ denominator(values[i])^degree(variables[i]), so that terms add up without fractions.
class RationalPowerProduct {
  public:
    RationalPowerProduct(const Polynomial& f, std::span<const std::size_t> variables,
                         std::span<const mpq_class> values)
        : variables_(variables) {
        for (std::size_t i = 0; i < variables.size(); ++i) {
            numerators_.emplace_back(Integer(values[i].get_num()));
            denominators_.emplace_back(Integer(values[i].get_den()));
            degrees_.push_back(static_cast<std::uint64_t>(std::max<std::int64_t>(f.degree(variables[i]), 0)));
        }
    }

    Integer common_denominator() {
        Integer product(1);
        for (std::size_t i = 0; i < variables_.size(); ++i) {
            if (!denominators_[i].trivial()) product *= denominators_[i](degrees_[i]);
        }
        return product;
    }

    Integer times(Integer coefficient, const MonomialLayout& layout, const MonomialLayout::Word* monomial) {
        for (std::size_t i = 0; i < variables_.size(); ++i) {
            const std::uint64_t exponent = layout.exponent(monomial, variables_[i]);
            if (exponent != 0 && !numerators_[i].trivial()) coefficient *= numerators_[i](exponent);
            if (!denominators_[i].trivial()) coefficient *= denominators_[i](degrees_[i] - exponent);
        }
        return coefficient;
    }

  private:
    std::span<const std::size_t> variables_;
    std::vector<IntegerPowers> numerators_;
    std::vector<IntegerPowers> denominators_;
    std::vector<std::uint64_t> degrees_;
};

/// The same over GF(p), where nothing grows.
class ResiduePowerProduct {
  public:
    using Element = PrimeField::Element;

    ResiduePowerProduct(const PrimeField& field, std::span<const std::size_t> variables,
                        std::vector<Element> values)
        : field_(field), variables_(variables), values_(std::move(values)) {}

    Element times(Element coefficient, const MonomialLayout& layout,
                  const MonomialLayout::Word* monomial) const {
        for (std::size_t i = 0; i < variables_.size(); ++i) {
            const std::uint64_t exponent = layout.exponent(monomial, variables_[i]);
            if (exponent != 0) coefficient = field_.multiply(coefficient, field_.power(values_[i], exponent));
        }
        return coefficient;
    }

  private:
    PrimeField field_;
    std::span<const std::size_t> variables_;
    std::vector<Element> values_;
};

std::vector<PrimeField::Element> residues(const PrimeField& field, std::span<const mpq_class> values) {
    std::vector<PrimeField::Element> result;
    for (const mpq_class& value : values)
        result.push_back(field.from_fraction(Integer(value.get_num()), Integer(value.get_den())));
    return result;
}

std::vector<std::size_t> all_variables(const Ring& ring) {
    std::vector<std::size_t> variables(ring.variable_count());
    for (std::size_t v = 0; v < variables.size(); ++v) variables[v] = v;
    return variables;
}

void require_coordinates(const Ring& ring, std::size_t count) {
    if (count != ring.variable_count())
        throw DomainError("a point with " + std::to_string(count) + " coordinates for " + ring.to_string());
}

} // namespace

mpq_class evaluate(const Polynomial& f, std::span<const mpq_class> point, base::Run& run) {
    require_coordinates(f.ring(), point.size());
    const std::vector<std::size_t> variables = all_variables(f.ring());
    if (!f.ring().field().is_rationals()) {
        const PrimeField& field = f.ring().field().prime_field();
        return {evaluate(f, field, residues(field, point), run)};
    }
    RationalPowerProduct powers(f, variables, point);
    const IntegerTerms& terms = f.integer_terms();
    Integer sum;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        run.poll();
        sum += powers.times(terms.coefficients[i], *terms.layout, terms.monomial(i));
    }
    return make_rational(sum, powers.common_denominator() * f.denominator());
}

mpq_class evaluate(const Polynomial& f, std::span<const mpq_class> point) {
    base::Run run;
    return evaluate(f, point, run);
}

PrimeField::Element evaluate(const Polynomial& f, const PrimeField& field,
                             std::span<const PrimeField::Element> point, base::Run& run) {
    require_coordinates(f.ring(), point.size());
    const CoefficientField& own = f.ring().field();
    if (!own.is_rationals() && own.characteristic() != field.characteristic())
        throw DomainError("coefficients of " + own.to_string() + " have no image in another prime field");
    const std::vector<std::size_t> variables = all_variables(f.ring());
    const ResiduePowerProduct powers(field, variables, {point.begin(), point.end()});
    PrimeField::Element sum = 0;
    visit_terms(f, [&](const auto& terms, const auto& /*domain*/) {
        for (std::size_t i = 0; i < terms.size(); ++i) {
            run.poll();
            const auto c = field.from_integer(Integer(terms.coefficients[i]));
            sum = field.add(sum, powers.times(c, *terms.layout, terms.monomial(i)));
        }
    });
    if (!own.is_rationals()) return sum;
    return field.multiply(sum, field.from_fraction(Integer(1), f.denominator()));
}

Polynomial evaluate(const Polynomial& f, std::span<const std::size_t> variables,
                    std::span<const mpq_class> values, base::Run& run) {
    for (const std::size_t v : variables) require_variable(f.ring(), v);
    if (variables.size() != values.size())
        throw DomainError(std::to_string(values.size()) + " values for " + std::to_string(variables.size()) +
                          " variables");
    MonomialSplitter splitter(f.layout(), variables);
    const auto image = [&](const auto& terms, const auto& domain, auto& powers) {
        auto result = std::decay_t<decltype(terms)>(*terms.layout);
        for (std::size_t i = 0; i < terms.size(); ++i) {
            run.poll();
            splitter.split(terms.monomial(i));
            result.push_back(splitter.rest(),
                             powers.times(terms.coefficients[i], *terms.layout, terms.monomial(i)));
        }
        return sorted_terms(domain, std::move(result));
    };
    if (f.ring().field().is_rationals()) {
        RationalPowerProduct powers(f, variables, values);
        auto terms = image(f.integer_terms(), IntegerDomain{}, powers);
        return Polynomial::from_terms(f.ring(), std::move(terms),
                                      powers.common_denominator() * f.denominator());
    }
    const PrimeField& field = f.ring().field().prime_field();
    ResiduePowerProduct powers(field, variables, residues(field, values));
    return Polynomial::from_terms(f.ring(), image(f.residue_terms(), PrimeDomain{field}, powers));
}

Polynomial evaluate(const Polynomial& f, std::size_t variable, const mpq_class& value, base::Run& run) {
    return evaluate(f, std::span(&variable, 1), std::span(&value, 1), run);
}

} // namespace eliminant::algebra
