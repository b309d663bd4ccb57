#include "eliminant/algebra/coefficients.hpp"

#include "term_maps.hpp"

#include <algorithm>
#include <numeric>

namespace eliminant::algebra {

namespace {

void require_distinct_variables(const Ring& ring, std::span<const std::size_t> variables) {
    std::vector<bool> seen(ring.variable_count(), false);
    for (const std::size_t v : variables) {
        require_variable(ring, v);
        if (seen[v]) throw DomainError("the variable '" + ring.names()[v] + "' is named twice");
        seen[v] = true;
    }
}

} // namespace

std::vector<CoefficientTerm> coefficients(const Polynomial& f, std::span<const std::size_t> variables) {
    require_distinct_variables(f.ring(), variables);
    const std::size_t n = variables.size();
    std::vector<std::uint64_t> exponents(f.size() * n); // one row a term
    for (std::size_t i = 0; i < f.size(); ++i) {
        for (std::size_t k = 0; k < n; ++k) exponents[i * n + k] = f.exponent(i, variables[k]);
    }
    const auto row = [&](std::size_t i) {
        return std::span<const std::uint64_t>(exponents).subspan(i * n, n);
    };
    std::vector<std::size_t> sequence(f.size());
    std::iota(sequence.begin(), sequence.end(), std::size_t{0});
    // Stable: terms of one coefficient stay in the order of f, which is that of the coefficient, for an order
    // is compatible with division by the common monomial in the chosen variables.
    std::ranges::stable_sort(sequence, [&](std::size_t i, std::size_t j) {
        return std::ranges::lexicographical_compare(row(j), row(i));
    });

    std::vector<CoefficientTerm> result;
    visit_terms(f, [&](const auto& terms, const auto& /*domain*/) {
        MonomialSplitter splitter(*terms.layout, variables);
        for (std::size_t first = 0; first < sequence.size();) {
            auto group = std::decay_t<decltype(terms)>(*terms.layout);
            const auto key = row(sequence[first]);
            for (; first < sequence.size() && std::ranges::equal(row(sequence[first]), key); ++first) {
                splitter.split(terms.monomial(sequence[first]));
                group.push_back(splitter.rest(), terms.coefficients[sequence[first]]);
            }
            result.push_back({{key.begin(), key.end()}, over_denominator_of(f, std::move(group))});
        }
    });
    return result;
}

std::vector<CoefficientTerm> coefficients(const Polynomial& f, std::size_t variable) {
    return coefficients(f, std::span(&variable, 1));
}

Polynomial coefficient(const Polynomial& f, std::size_t variable, std::uint64_t exponent) {
    require_variable(f.ring(), variable);
    return visit_terms(f, [&](const auto& terms, const auto& /*domain*/) {
        MonomialSplitter splitter(*terms.layout, std::span(&variable, 1));
        auto result = std::decay_t<decltype(terms)>(*terms.layout);
        for (std::size_t i = 0; i < terms.size(); ++i) {
            if (terms.layout->exponent(terms.monomial(i), variable) != exponent) continue;
            splitter.split(terms.monomial(i));
            result.push_back(splitter.rest(), terms.coefficients[i]);
        }
        return over_denominator_of(f, std::move(result));
    });
}

Polynomial leading_coefficient(const Polynomial& f, std::size_t variable) {
    require_variable(f.ring(), variable);
    return f.is_zero() ? f : coefficient(f, variable, static_cast<std::uint64_t>(f.degree(variable)));
}

Polynomial from_coefficients(const Ring& ring, std::span<const std::size_t> variables,
                             std::span<const CoefficientTerm> terms) {
    require_distinct_variables(ring, variables);
    PolynomialBuilder builder(ring);
    std::vector<std::uint64_t> exponents(ring.variable_count());
    for (const CoefficientTerm& term : terms) {
        const Polynomial& c = term.coefficient;
        require_same_ring(ring, c.ring(), "a polynomial from its coefficients");
        if (term.exponents.size() != variables.size())
            throw DomainError("a polynomial from its coefficients: one exponent a variable is expected");
        for (std::size_t i = 0; i < c.size(); ++i) {
            c.layout().decode(c.packed_monomial(i), exponents);
            for (std::size_t k = 0; k < variables.size(); ++k) {
                if (__builtin_add_overflow(exponents[variables[k]], term.exponents[k],
                                           &exponents[variables[k]]))
                    throw OverflowError("an exponent exceeds 2^63 - 1");
            }
            if (ring.field().is_rationals())
                builder.add(c.integer_terms().coefficients[i], c.denominator(), exponents);
            else
                builder.add(Integer(c.residue_terms().coefficients[i]), exponents);
        }
    }
    return builder.build();
}

std::uint64_t degree_in_first(const Polynomial& f, std::size_t count) {
    std::uint64_t degree = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
        std::uint64_t sum = 0;
        for (std::size_t variable = 0; variable < count; ++variable) sum += f.exponent(i, variable);
        degree = std::max(degree, sum);
    }
    return degree;
}

std::vector<bool> occurring_variables(const Polynomial& f) {
    std::vector<bool> occurs(f.ring().variable_count(), false);
    for (std::size_t i = 0; i < f.size(); ++i) {
        for (std::size_t v = 0; v < occurs.size(); ++v) occurs[v] = occurs[v] || f.exponent(i, v) != 0;
    }
    return occurs;
}

} // namespace eliminant::algebra
