#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/error.hpp"

#include "term_arithmetic.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace eliminant::algebra {

/// Throws DomainError unless the ring has that variable.
inline void require_variable(const Ring& ring, std::size_t variable) {
    if (variable >= ring.variable_count())
        throw DomainError(ring.to_string() + " has no variable of index " + std::to_string(variable));
}

/// Calls visit(terms, domain) with the term list of f and the arithmetic of its coefficients.
template <class Visit>
decltype(auto) visit_terms(const Polynomial& f, Visit&& visit) {
    const CoefficientField& field = f.ring().field();
    if (field.is_rationals()) return std::forward<Visit>(visit)(f.integer_terms(), IntegerDomain{});
    return std::forward<Visit>(visit)(f.residue_terms(), PrimeDomain{field.prime_field()});
}

/// The polynomial of sorted terms that stand over the denominator of f.
inline Polynomial over_denominator_of(const Polynomial& f, IntegerTerms terms) {
    return Polynomial::from_terms(f.ring(), std::move(terms), f.denominator());
}
inline Polynomial over_denominator_of(const Polynomial& f, ResidueTerms terms) {
    return Polynomial::from_terms(f.ring(), std::move(terms));
}

/// Splits packed monomials of one layout into the part in some variables and the rest.
class MonomialSplitter {
  public:
    using Word = MonomialLayout::Word;

    MonomialSplitter(const MonomialLayout& layout, std::span<const std::size_t> variables)
        : layout_(&layout), variables_(variables.begin(), variables.end()),
          exponents_(layout.variable_count(), 0), packed_(layout.words()), rest_(layout.words()) {}

    /// Reads a monomial; the results below are of it.
    void split(const Word* monomial) {
        for (const std::size_t v : variables_) exponents_[v] = layout_->exponent(monomial, v);
        // A factor of a monomial that is packed in this layout fits in it as well.
        static_cast<void>(layout_->encode(exponents_, packed_.data()));
        layout_->divide(monomial, packed_.data(), rest_.data());
    }
    std::uint64_t exponent(std::size_t variable) const { return exponents_[variable]; }
    /// The monomial with the exponents of the chosen variables set to 0.
    const Word* rest() const { return rest_.data(); }

  private:
    const MonomialLayout* layout_;
    std::vector<std::size_t> variables_;
    std::vector<std::uint64_t> exponents_;
    std::vector<Word> packed_;
    std::vector<Word> rest_;
};

/// The least exponent of each variable over the terms of a nonzero polynomial: its largest monomial factor.
inline std::vector<std::uint64_t> monomial_content(const Polynomial& f) {
    std::vector<std::uint64_t> least(f.ring().variable_count());
    for (std::size_t v = 0; v < least.size(); ++v) least[v] = f.exponent(0, v);
    for (std::size_t i = 1; i < f.size(); ++i) {
        for (std::size_t v = 0; v < least.size(); ++v) {
            if (least[v] != 0) least[v] = std::min(least[v], f.exponent(i, v));
        }
    }
    return least;
}

/// f with exponents[i] mapped by change(variable, exponent), which is injective on the exponents of f.
template <class Change>
Polynomial with_exponents(const Polynomial& f, const Change& change) {
    PolynomialBuilder builder(f.ring());
    std::vector<std::uint64_t> exponents(f.ring().variable_count());
    for (std::size_t i = 0; i < f.size(); ++i) {
        f.layout().decode(f.packed_monomial(i), exponents);
        for (std::size_t v = 0; v < exponents.size(); ++v) exponents[v] = change(v, exponents[v]);
        if (f.ring().field().is_rationals())
            builder.add(f.integer_terms().coefficients[i], f.denominator(), exponents);
        else
            builder.add(Integer(f.residue_terms().coefficients[i]), exponents);
    }
    return builder.build();
}

/// f divided by a monomial that divides all its terms.
inline Polynomial divided_by_monomial(const Polynomial& f, std::span<const std::uint64_t> exponents) {
    if (std::ranges::all_of(exponents, [](std::uint64_t e) { return e == 0; })) return f;
    std::vector<MonomialLayout::Word> divisor(f.layout().words());
    static_cast<void>(
        f.layout().encode(exponents, divisor.data())); // a factor of terms in this layout fits in it
    return visit_terms(f, [&](const auto& terms, const auto& /*domain*/) {
        auto result = terms;
        for (std::size_t i = 0; i < terms.size(); ++i)
            terms.layout->divide(terms.monomial(i), divisor.data(), result.monomial(i));
        return over_denominator_of(f, std::move(result));
    });
}

} // namespace eliminant::algebra
