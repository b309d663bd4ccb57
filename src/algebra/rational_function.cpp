#include "eliminant/algebra/rational_function.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/gcd.hpp"
#include "eliminant/algebra/parse.hpp"
#include "eliminant/algebra/print.hpp"
#include "eliminant/base/error.hpp"

#include "polynomial_arithmetic.hpp"

#include <optional>
#include <utility>

namespace eliminant::algebra {

namespace {

/// The Environment of rational functions: a numerator that may still be a growing sum, over a denominator.
class RationalArithmetic {
  public:
    struct Value {
        PolynomialArithmetic::Value numerator;
        std::optional<Polynomial> denominator; ///< not constant; none stands for 1
    };

    RationalArithmetic(const Ring& ring, const Meaning& meaning, const base::SourceText& source,
                       base::Run& run)
        : polynomials_(ring, source, run), meaning_(meaning) {}

    Value number(const Expression::Number& number, std::size_t offset) const {
        return {polynomials_.number(number, offset), std::nullopt};
    }
    Value name(std::string_view name, std::size_t offset) const {
        return to_value(meaning_.name(name, offset));
    }
    Value call(std::string_view function, const ExpressionView& argument, std::size_t offset) const {
        if (!meaning_.call) polynomials_.call(function, argument, offset);
        return to_value(meaning_.call(function, argument, offset));
    }
    void negate(Value& a) const { polynomials_.negate(a.numerator); }
    void add(Value& a, Value b, std::size_t offset) const {
        bring_to_one_denominator(a, b, offset);
        polynomials_.add(a.numerator, std::move(b.numerator), offset);
    }
    void subtract(Value& a, Value b, std::size_t offset) const {
        bring_to_one_denominator(a, b, offset);
        polynomials_.subtract(a.numerator, std::move(b.numerator), offset);
    }
    void multiply(Value& a, Value b, std::size_t offset) const {
        polynomials_.multiply(a.numerator, std::move(b.numerator), offset);
        multiply_denominator(a, std::move(b.denominator), offset);
    }
    void divide(Value& a, Value b, std::size_t offset) const {
        invert(b, offset);
        multiply(a, std::move(b), offset);
    }
    void power(Value& a, std::int64_t exponent, std::size_t offset) const {
        if (exponent < 0) {
            invert(a, offset);
            exponent = -exponent;
        }
        polynomials_.power(a.numerator, exponent, offset);
        if (!a.denominator) return;
        PolynomialArithmetic::Value denominator = *std::move(a.denominator);
        polynomials_.power(denominator, exponent, offset);
        a.denominator.reset();
        if (exponent != 0) a.denominator = polynomials_.polynomial(std::move(denominator));
    }
    RationalFunction result(Value value) const {
        Polynomial numerator = polynomials_.polynomial(std::move(value.numerator));
        if (!value.denominator) return RationalFunction(std::move(numerator));
        return in_lowest_terms({std::move(numerator), *std::move(value.denominator)}, polynomials_.run());
    }

  private:
    Value to_value(RationalFunction f) const {
        if (f.is_polynomial()) return {polynomials_.value(std::move(f.numerator)), std::nullopt};
        return {polynomials_.value(std::move(f.numerator)), std::move(f.denominator)};
    }
    void multiply_denominator(Value& a, std::optional<Polynomial> factor, std::size_t offset) const {
        if (!factor) return;
        if (!a.denominator) {
            a.denominator = std::move(factor);
            return;
        }
        PolynomialArithmetic::Value product = *std::move(a.denominator);
        polynomials_.multiply(product, *std::move(factor), offset);
        a.denominator = polynomials_.polynomial(std::move(product));
    }
    void invert(Value& a, std::size_t offset) const {
        if (polynomials_.is_zero(a.numerator)) {
            const base::SourceText& source = polynomials_.source();
            source.fail(right_operand(source, offset), "a denominator that is not zero");
        }
        if (!a.denominator &&
            polynomials_.is_constant(a.numerator)) { // stays a constant, without a denominator
            PolynomialArithmetic::Value one = polynomials_.constant(1);
            polynomials_.divide(one, std::move(a.numerator), offset);
            a.numerator = std::move(one);
            return;
        }
        Polynomial numerator = polynomials_.polynomial(std::move(a.numerator));
        a.numerator =
            a.denominator ? polynomials_.value(*std::move(a.denominator)) : polynomials_.constant(1);
        a.denominator.reset();
        if (numerator.is_constant()) {
            polynomials_.divide(a.numerator, polynomials_.value(std::move(numerator)), offset);
        } else {
            a.denominator = std::move(numerator);
        }
    }
    /// Brings a and b over the lcm of their denominators.
    void bring_to_one_denominator(Value& a, Value& b, std::size_t offset) const {
        if (a.denominator == b.denominator) return;
        const auto is_multiple_of_all = [](const Value& v, const Value& w) {
            return v.denominator && !w.denominator;
        };
        if (is_multiple_of_all(a, b))
            polynomials_.multiply(b.numerator, *a.denominator, offset);
        else if (is_multiple_of_all(b, a))
            polynomials_.multiply(a.numerator, *b.denominator, offset);
        if (!a.denominator || !b.denominator) {
            if (!a.denominator) a.denominator = b.denominator;
            return;
        }
        base::Run& run = polynomials_.run();
        const Polynomial common = gcd(*a.denominator, *b.denominator, run);
        Polynomial a_cofactor = divide_exactly(*a.denominator, common, run);
        Polynomial b_cofactor = divide_exactly(*b.denominator, common, run);
        polynomials_.multiply(a.numerator, b_cofactor, offset);
        polynomials_.multiply(b.numerator, std::move(a_cofactor), offset);
        multiply_denominator(a, std::move(b_cofactor), offset);
    }

    PolynomialArithmetic polynomials_;
    const Meaning& meaning_;
};

} // namespace

RationalFunction::RationalFunction(Polynomial f)
    : numerator(std::move(f)), denominator(Polynomial::constant(numerator.ring(), 1)) {}

RationalFunction::RationalFunction(Polynomial n, Polynomial d)
    : numerator(std::move(n)), denominator(std::move(d)) {
    require_same_ring(numerator.ring(), denominator.ring(), "quotient of polynomials");
    if (denominator.is_zero()) throw DomainError("the denominator of a rational function is zero");
    if (denominator.is_constant() && !denominator.is_one()) {
        numerator = numerator.scaled(1 / denominator.leading_coefficient());
        denominator = Polynomial::constant(numerator.ring(), 1);
    }
}

RationalFunction in_lowest_terms(const RationalFunction& f, base::Run& run) {
    if (f.is_polynomial()) return f;
    const Polynomial common = gcd(f.numerator, f.denominator, run);
    const Polynomial numerator = divide_exactly(f.numerator, common, run);
    const Polynomial denominator = divide_exactly(f.denominator, common, run);
    // What primitive_part() takes out of the denominator, with its sign.
    const mpq_class unit =
        denominator.leading_coefficient() / denominator.primitive_part().leading_coefficient();
    return {numerator.scaled(1 / unit), denominator.primitive_part()};
}

RationalFunction evaluate(const ExpressionView& expression, const Ring& ring, const Meaning& meaning,
                          base::Run& run) {
    const base::SourceText& source = expression.source();
    RationalArithmetic arithmetic(ring, meaning, source, run);
    return arithmetic.result(evaluate(expression, arithmetic));
}

RationalFunction parse_rational_function(const Ring& ring, const base::SourceText& source, base::Run& run) {
    const Vocabulary vocabulary{{},
                                [&ring](std::string_view name) { return ring.index_of(name).has_value(); }};
    const Expression expression = parse_expression(source, vocabulary, run);
    const PolynomialArithmetic names(ring, expression.source(), run);
    const Meaning meaning{[&names](std::string_view name, std::size_t offset) {
                              return RationalFunction(names.polynomial(names.name(name, offset)));
                          },
                          {}};
    return evaluate(expression.view(), ring, meaning, run);
}

RationalFunction parse_rational_function(const Ring& ring, const base::SourceText& source) {
    base::Run run;
    return parse_rational_function(ring, source, run);
}

std::string to_string(const RationalFunction& f) {
    if (f.is_polynomial()) return to_string(f.numerator);
    std::string text = "(";
    return text.append(to_string(f.numerator)).append(")/(").append(to_string(f.denominator)).append(")");
}

} // namespace eliminant::algebra
