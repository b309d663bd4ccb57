#include "field/formula.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/expression.hpp"
#include "eliminant/algebra/gcd.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace eliminant::field {

namespace {

using algebra::Expression;
using algebra::ExpressionView;
using algebra::Polynomial;
using algebra::Ring;

/// Appends `part` to the parts of `whole`, which becomes of that kind, without nesting one in another.
void append(Formula& whole, Formula part, Formula::Kind kind) {
    if (whole.kind != kind || (kind == Formula::Kind::sum && whole.factor != 1)) {
        Formula outer;
        outer.kind = kind;
        outer.parts.push_back(std::move(whole));
        whole = std::move(outer);
    }
    if (part.kind == kind && (kind == Formula::Kind::product || part.factor == 1)) {
        whole.factor *= part.factor;
        std::ranges::move(part.parts, std::back_inserter(whole.parts));
    } else {
        whole.parts.push_back(std::move(part));
    }
}

/// A divisor or exponent that is harmless only after expansion: there is no structure worth keeping.
struct NoStructure {};

/// Builds a Formula where algebra::evaluate() would compute.
class Structure {
  public:
    using Value = Formula;

    explicit Structure(const Ring& ring) : ring_(ring) {}

    Formula number(const Expression::Number& number, std::size_t /*offset*/) const {
        return constant(mpq_class(number.numerator.to_mpz(), number.denominator.to_mpz()));
    }
    Formula name(std::string_view name, std::size_t /*offset*/) const {
        return to_formula(Polynomial::variable(ring_, name));
    }
    static Formula call(std::string_view /*function*/, const ExpressionView& argument, std::size_t offset) {
        argument.source().fail(offset, "a polynomial");
    }
    static void negate(Formula& a) { a.factor = -a.factor; }
    static void add(Formula& a, Formula b, std::size_t /*offset*/) {
        append(a, std::move(b), Formula::Kind::sum);
    }
    static void subtract(Formula& a, Formula b, std::size_t offset) {
        negate(b);
        add(a, std::move(b), offset);
    }
    static void multiply(Formula& a, Formula b, std::size_t /*offset*/) {
        if (a.is_constant()) std::swap(a, b);
        if (b.is_constant())
            a.factor *= value_of(b);
        else
            append(a, std::move(b), Formula::Kind::product);
    }
    static void divide(Formula& a, const Formula& b, std::size_t /*offset*/) {
        if (!b.is_constant() || value_of(b) == 0) throw NoStructure();
        a.factor /= value_of(b);
    }
    void power(Formula& a, std::int64_t exponent, std::size_t /*offset*/) const {
        if (exponent == 1) return;
        if (exponent <= 0) throw NoStructure();
        const auto size = static_cast<std::uint64_t>(exponent);
        if (a.is_constant()) {
            a = to_formula(algebra::pow(Polynomial::constant(ring_, value_of(a)), size));
            return;
        }
        Formula result;
        result.kind = Formula::Kind::power;
        result.exponent = size;
        result.parts.push_back(std::move(a));
        a = std::move(result);
    }

  private:
    Formula constant(const mpq_class& value) const { return to_formula(Polynomial::constant(ring_, value)); }
    static mpq_class value_of(const Formula& constant) {
        const Polynomial& c = *constant.polynomial;
        return c.is_zero() ? mpq_class(0) : mpq_class(constant.factor * c.leading_coefficient());
    }

    Ring ring_;
};

Formula formula_of_side(const Ring& ring, const base::SourceText& source, base::Run& run) {
    const Expression expression = algebra::parse_expression(source, {}, run);
    Structure structure(ring);
    return algebra::evaluate(expression.view(), structure);
}

/// f = content · primitive part with respect to coordinate i, where the content is free of it.
void split_content(std::vector<Polynomial>& factors, Polynomial& f, std::size_t i, base::Run& run) {
    if (f.degree(i) <= 0) return;
    const std::size_t variables[] = {i};
    const Polynomial content = algebra::content(f, variables, run);
    if (content.is_constant()) return;
    factors.push_back(content);
    f = algebra::primitive_part(f, variables, run);
}

} // namespace

Formula to_formula(Polynomial f) {
    Formula result;
    result.polynomial = std::move(f);
    return result;
}

Formula formula_of_text(const Polynomial& expanded, const base::SourceText& source, base::Run& run) {
    const Ring& ring = expanded.ring();
    const std::size_t equals = source.text().find('=');
    try {
        if (equals == std::string_view::npos) return formula_of_side(ring, source, run);
        Formula left = formula_of_side(ring, source.section(0, equals), run);
        Structure::subtract(left, formula_of_side(ring, source.section(equals + 1, source.size()), run), 0);
        return left;
    } catch (const NoStructure&) {
        return to_formula(expanded);
    }
}

Formula obvious_factors(const Polynomial& f, base::Run& run) {
    std::vector<Polynomial> contents;
    Polynomial rest = f.primitive_part();
    for (std::size_t i = 0; i < f.ring().variable_count(); ++i) split_content(contents, rest, i, run);
    if (!rest.is_constant()) contents.push_back(rest);
    Formula result;
    result.kind = Formula::Kind::product;
    mpq_class leading = 1;
    for (const Polynomial& content : contents)
        for (const algebra::Factor& factor : algebra::squarefree_decomposition(content, run).factors) {
            Formula part = to_formula(factor.base);
            leading *= algebra::pow(factor.base.leading_term(), factor.multiplicity).leading_coefficient();
            if (factor.multiplicity > 1) {
                Formula power;
                power.kind = Formula::Kind::power;
                power.exponent = factor.multiplicity;
                power.parts.push_back(std::move(part));
                part = std::move(power);
            }
            result.parts.push_back(std::move(part));
        }
    if (result.parts.empty()) return to_formula(f);
    result.factor = f.leading_coefficient() / leading;
    return result;
}

} // namespace eliminant::field
