#pragma once

#include "eliminant/algebra/expression.hpp"
#include "eliminant/algebra/polynomial.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

namespace eliminant::algebra {

/// The Environment (expression.hpp) of polynomials: names are variables of a ring, division is by constants.
///
/// A value stays a single term while it is one, and a sum is collected unsorted, so that a long sum costs one
/// sort and a monomial no polynomial arithmetic at all.
class PolynomialArithmetic {
  public:
    struct Term {
        Integer numerator; ///< over GF(p) a residue, over 1
        Integer denominator;
        std::vector<std::uint64_t> exponents;
    };
    using Value = std::variant<Term, PolynomialBuilder, Polynomial>;

    /// The two references outlive it.
    PolynomialArithmetic(Ring ring, const base::SourceText& source, base::Run& run);

    Value number(const Expression::Number& number, std::size_t offset) const;
    Value name(std::string_view name, std::size_t offset) const;
    [[noreturn]] Value call(std::string_view function, const ExpressionView& argument,
                            std::size_t offset) const;
    void negate(Value& a) const;
    void add(Value& a, Value b, std::size_t offset) const;
    void subtract(Value& a, Value b, std::size_t offset) const;
    void multiply(Value& a, Value b, std::size_t offset) const;
    void divide(Value& a, Value b, std::size_t offset) const;
    void power(Value& a, std::int64_t exponent, std::size_t offset) const;

    /// Adds a value to a sum.
    void append(PolynomialBuilder& sum, const Value& value) const;
    Value constant(const mpq_class& value) const;
    Value value(Polynomial f) const { return f; }
    Polynomial polynomial(Value value) const;
    bool is_zero(Value& a) const;
    /// Whether it is a constant; a collected sum is simplified for it.
    bool is_constant(Value& a) const;

    const Ring& ring() const { return ring_; }
    const base::SourceText& source() const { return source_; }
    base::Run& run() const { return run_; }

  private:
    Term to_term(const Expression::Number& fraction) const;
    void simplify(Value& a) const;
    void multiply_term(Term& a, const Term& b, std::size_t offset) const;
    void power_term(Term& a, std::uint64_t exponent, std::size_t offset) const;
    Polynomial power_polynomial(const Polynomial& f, std::uint64_t exponent, std::size_t offset) const;
    Polynomial product(const Polynomial& a, const Polynomial& b, std::size_t offset) const;

    Ring ring_;
    const base::SourceText& source_;
    base::Run& run_;
};

/// Where the right operand of the operator at `offset` begins: what an error about a divisor or an exponent
/// points to.
std::size_t right_operand(const base::SourceText& source, std::size_t offset);

/// The value of a formula without names; throws ParseError with `expected` at a name.
mpq_class evaluate_constant(const ExpressionView& expression, std::string_view expected, base::Run& run);

} // namespace eliminant::algebra
