#pragma once

#include "eliminant/algebra/expression.hpp"
#include "eliminant/algebra/polynomial.hpp"

#include <functional>
#include <string>
#include <string_view>

namespace eliminant::algebra {

/// numerator/denominator, both of one ring, the denominator not zero.
///
/// Not necessarily in lowest terms. A constant denominator is 1.
struct RationalFunction {
    Polynomial numerator;
    Polynomial denominator;

    /// f/1.
    explicit RationalFunction(Polynomial f);
    /// Throws DomainError for a zero denominator, RingMismatchError.
    RationalFunction(Polynomial n, Polynomial d);

    bool is_polynomial() const { return denominator.is_one(); }
};

/// What the names and the functions of a formula stand for. A callback that knows no meaning throws, usually
/// by SourceText::fail(offset, …) on the source of the expression.
struct Meaning {
    std::function<RationalFunction(std::string_view name, std::size_t offset)> name;
    /// May be empty for formulas without functions.
    std::function<RationalFunction(std::string_view function, ExpressionView argument, std::size_t offset)>
        call = {};
};

/// Numerator and denominator coprime, the denominator a primitive part (Polynomial::primitive_part). Unique.
RationalFunction in_lowest_terms(const RationalFunction& f, base::Run& run);

/// The value of a formula in the fraction field of `ring`, in lowest terms.
/// \throws ParseError at a division by zero, an exponent or a constant that is too large; Stopped; what the
/// callbacks throw
RationalFunction evaluate(const ExpressionView& expression, const Ring& ring, const Meaning& meaning,
                          base::Run& run);

/// `f` or `(n)/(d)`, as they are; reads back as the same rational function.
std::string to_string(const RationalFunction& f);

} // namespace eliminant::algebra

namespace eliminant {
using algebra::in_lowest_terms;
using algebra::RationalFunction;
} // namespace eliminant
