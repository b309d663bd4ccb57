#include "polynomial_arithmetic.hpp"

#include "eliminant/algebra/arithmetic.hpp"

#include "expansion_size.hpp"
#include "number_text.hpp"
#include "scanner.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace eliminant::algebra {

namespace {

constexpr const char* exponent_expected = "exponents below 2^63";

std::string constant_expected() {
    return "a constant of at most " + std::to_string(max_constant_bits) + " bits";
}

/// A few names for a message.
std::string list_of(const std::vector<std::string>& names) {
    constexpr std::size_t most = 10;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, names.size()); ++i) text += (i == 0 ? "" : ", ") + names[i];
    return names.size() > most ? text + ", …" : text;
}

} // namespace

std::size_t right_operand(const base::SourceText& source, std::size_t offset) {
    Scanner scanner(source, offset);
    const Token token = scanner.take(); // a superscript is operator and operand in one
    return token.kind == TokenKind::superscript ? token.begin : scanner.peek().begin;
}

PolynomialArithmetic::PolynomialArithmetic(Ring ring, const base::SourceText& source, base::Run& run)
    : ring_(std::move(ring)), source_(source), run_(run) {}

PolynomialArithmetic::Term PolynomialArithmetic::to_term(const Expression::Number& fraction) const {
    return {fraction.numerator, fraction.denominator, std::vector<std::uint64_t>(ring_.variable_count(), 0)};
}

PolynomialArithmetic::Value PolynomialArithmetic::number(const Expression::Number& number,
                                                         std::size_t offset) const {
    Term term = to_term(number);
    if (ring_.field().is_rationals()) return term;
    const PrimeField& field = ring_.field().prime_field();
    if (field.from_integer(term.denominator) == 0)
        source_.fail(offset, "a number with a denominator that is not zero in " + ring_.field().to_string());
    term.numerator = Integer(field.from_fraction(term.numerator, term.denominator));
    term.denominator = Integer(1);
    return term;
}

PolynomialArithmetic::Value PolynomialArithmetic::name(std::string_view name, std::size_t offset) const {
    const auto index = ring_.index_of(name);
    if (!index) {
        const auto& names = ring_.names();
        source_.fail(offset, names.empty()       ? "a number, as there are no variables"
                             : names.size() == 1 ? "the variable " + names.front()
                                                 : "one of the variables " + list_of(names));
    }
    Term term = to_term({Integer(1), Integer(1)});
    term.exponents[*index] = 1;
    return term;
}

PolynomialArithmetic::Value PolynomialArithmetic::call(std::string_view, const ExpressionView&,
                                                       std::size_t offset) const {
    source_.fail(offset, "a polynomial, without functions");
}

PolynomialArithmetic::Value PolynomialArithmetic::constant(const mpq_class& value) const {
    return to_term({Integer(value.get_num()), Integer(value.get_den())});
}

void PolynomialArithmetic::simplify(Value& a) const {
    auto* builder = std::get_if<PolynomialBuilder>(&a);
    if (builder != nullptr) a = builder->build();
}

Polynomial PolynomialArithmetic::polynomial(Value value) const {
    simplify(value);
    if (auto* f = std::get_if<Polynomial>(&value)) return std::move(*f);
    PolynomialBuilder builder(ring_);
    append(builder, value);
    return builder.build();
}

bool PolynomialArithmetic::is_zero(Value& a) const {
    simplify(a);
    if (const auto* term = std::get_if<Term>(&a)) return term->numerator.is_zero();
    return std::get<Polynomial>(a).is_zero();
}

bool PolynomialArithmetic::is_constant(Value& a) const {
    simplify(a);
    if (const auto* term = std::get_if<Term>(&a))
        return term->numerator.is_zero() ||
               std::ranges::all_of(term->exponents, [](auto e) { return e == 0; });
    return std::get<Polynomial>(a).is_constant();
}

void PolynomialArithmetic::append(PolynomialBuilder& sum, const Value& value) const {
    if (const auto* term = std::get_if<Term>(&value)) {
        sum.add(term->numerator, term->denominator, term->exponents);
        return;
    }
    if (const auto* builder = std::get_if<PolynomialBuilder>(&value)) {
        append(sum, PolynomialBuilder(*builder).build());
        return;
    }
    const auto& f = std::get<Polynomial>(value);
    std::vector<std::uint64_t> exponents(ring_.variable_count());
    for (std::size_t i = 0; i < f.size(); ++i) {
        f.layout().decode(f.packed_monomial(i), exponents);
        if (ring_.field().is_rationals())
            sum.add(f.integer_terms().coefficients[i], f.denominator(), exponents);
        else
            sum.add(Integer(f.residue_terms().coefficients[i]), exponents);
    }
}

void PolynomialArithmetic::add(Value& a, Value b, std::size_t offset) const {
    run_.poll();
    simplify(b);
    try {
        if (!std::holds_alternative<PolynomialBuilder>(a)) {
            PolynomialBuilder sum(ring_);
            append(sum, a);
            a = std::move(sum);
        }
        append(std::get<PolynomialBuilder>(a), b);
    } catch (const base::OverflowError&) {
        source_.fail(offset, exponent_expected);
    }
}

void PolynomialArithmetic::subtract(Value& a, Value b, std::size_t offset) const {
    negate(b);
    add(a, std::move(b), offset);
}

void PolynomialArithmetic::negate(Value& a) const {
    simplify(a);
    if (auto* f = std::get_if<Polynomial>(&a)) {
        *f = -*f;
        return;
    }
    Integer& numerator = std::get<Term>(a).numerator;
    if (ring_.field().is_rationals())
        numerator.negate();
    else
        numerator = Integer(ring_.field().prime_field().from_integer(-numerator));
}

void PolynomialArithmetic::multiply_term(Term& a, const Term& b, std::size_t offset) const {
    if (ring_.field().is_rationals()) {
        const auto too_large = [](const Integer& x, const Integer& y) {
            return !x.is_one() && !y.is_one() && x.bit_length() + y.bit_length() > max_constant_bits;
        };
        if (too_large(a.numerator, b.numerator) || too_large(a.denominator, b.denominator))
            source_.fail(offset, constant_expected());
        auto product = multiply_fractions({a.numerator, a.denominator}, {b.numerator, b.denominator});
        a.numerator = std::move(product.numerator);
        a.denominator = std::move(product.denominator);
    } else {
        a.numerator = Integer(ring_.field().prime_field().from_integer(a.numerator * b.numerator));
    }
    for (std::size_t i = 0; i < a.exponents.size(); ++i) {
        a.exponents[i] += b.exponents[i]; // both below 2^63
        if (a.exponents[i] >> 63 != 0) source_.fail(offset, exponent_expected);
    }
}

Polynomial PolynomialArithmetic::product(const Polynomial& a, const Polynomial& b, std::size_t offset) const {
    if (expansion_bytes(a, b) > max_expansion_bytes)
        source_.fail(offset, expansion_expected, "a larger product");
    try {
        return algebra::multiply(a, b, run_);
    } catch (const base::OverflowError&) {
        source_.fail(offset, exponent_expected);
    }
}

void PolynomialArithmetic::multiply(Value& a, Value b, std::size_t offset) const {
    run_.poll();
    simplify(a);
    simplify(b);
    auto* term = std::get_if<Term>(&a);
    const auto* factor = std::get_if<Term>(&b);
    if (term != nullptr && factor != nullptr)
        multiply_term(*term, *factor, offset);
    else
        a = product(polynomial(std::move(a)), polynomial(std::move(b)), offset);
}

void PolynomialArithmetic::divide(Value& a, Value b, std::size_t offset) const {
    if (!is_constant(b))
        source_.fail(right_operand(source_, offset), "a constant: a polynomial is divided by constants only");
    if (is_zero(b)) source_.fail(right_operand(source_, offset), "a denominator that is not zero");
    const mpq_class divisor = polynomial(std::move(b)).leading_coefficient();
    multiply(a, number({Integer(divisor.get_den()), Integer(divisor.get_num())}, offset), offset);
}

void PolynomialArithmetic::power_term(Term& a, std::uint64_t exponent, std::size_t offset) const {
    if (ring_.field().is_rationals()) {
        for (Integer* part : {&a.numerator, &a.denominator}) {
            if (part->bit_length() <= 1) { // 0, 1, −1
                if (part->sign() < 0 && exponent % 2 == 0) *part = Integer(1);
                if (exponent == 0) *part = Integer(1);
                continue;
            }
            if (exponent > max_constant_bits || (part->bit_length() - 1) * exponent > max_constant_bits)
                source_.fail(offset, constant_expected());
            *part = pow(*part, exponent);
        }
    } else {
        const PrimeField& field = ring_.field().prime_field();
        a.numerator = Integer(field.power(field.from_integer(a.numerator), exponent));
    }
    for (std::uint64_t& e : a.exponents) {
        if (__builtin_mul_overflow(e, exponent, &e) || e >> 63 != 0) source_.fail(offset, exponent_expected);
    }
}

Polynomial PolynomialArithmetic::power_polynomial(const Polynomial& f, std::uint64_t exponent,
                                                  std::size_t offset) const {
    if (expansion_bytes(f, exponent) > max_expansion_bytes)
        source_.fail(offset, expansion_expected, "a larger power");
    try {
        return pow(f, exponent, run_);
    } catch (const base::OverflowError&) {
        source_.fail(offset, exponent_expected);
    }
}

void PolynomialArithmetic::power(Value& a, std::int64_t exponent, std::size_t offset) const {
    run_.poll();
    simplify(a);
    if (auto* f = std::get_if<Polynomial>(&a); f != nullptr && f->size() <= 1) {
        const mpq_class c = f->is_zero() ? mpq_class(0) : f->leading_coefficient();
        Term term{Integer(c.get_num()), Integer(c.get_den()),
                  std::vector<std::uint64_t>(ring_.variable_count(), 0)};
        if (!f->is_zero()) f->layout().decode(f->packed_monomial(0), term.exponents);
        a = std::move(term);
    }
    if (exponent < 0) {
        if (!is_constant(a)) source_.fail(right_operand(source_, offset), "an exponent that is not negative");
        Value one = constant(1);
        divide(one, std::move(a), offset);
        a = std::move(one);
        exponent = -exponent;
    }
    const auto e = static_cast<std::uint64_t>(exponent);
    if (auto* term = std::get_if<Term>(&a))
        power_term(*term, e, offset);
    else
        a = power_polynomial(std::get<Polynomial>(a), e, offset);
}

namespace {

/// ℚ without variables, saying what was expected where a name stands.
struct ConstantArithmetic : PolynomialArithmetic {
    ConstantArithmetic(const base::SourceText& source, std::string_view wanted, base::Run& run)
        : PolynomialArithmetic(Ring(CoefficientField::rationals(), {}), source, run), expected(wanted) {}
    [[noreturn]] Value name(std::string_view, std::size_t offset) const { source().fail(offset, expected); }
    [[noreturn]] Value call(std::string_view, const ExpressionView&, std::size_t offset) const {
        source().fail(offset, expected);
    }
    std::string expected;
};

} // namespace

mpq_class evaluate_constant(const ExpressionView& expression, std::string_view expected, base::Run& run) {
    ConstantArithmetic arithmetic(expression.source(), expected, run);
    const Polynomial value = arithmetic.polynomial(evaluate(expression, arithmetic));
    return value.is_zero() ? mpq_class(0) : value.leading_coefficient();
}

} // namespace eliminant::algebra
