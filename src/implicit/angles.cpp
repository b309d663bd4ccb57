#include "implicit/angles.hpp"

#include "eliminant/algebra/parse.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace eliminant::implicit {

using algebra::Expression;
using algebra::ExpressionView;
using algebra::Polynomial;
using algebra::RationalFunction;

namespace {

constexpr const char* what_fits = "an integer multiple of one parameter";

/// The one name in an argument; an argument with another name, a function or a constant does not fit.
std::string only_name(ExpressionView argument, std::size_t call_offset,
                      const std::function<bool(std::string_view)>& is_parameter) {
    std::string found;
    for (const Expression::Node& node : argument.nodes()) {
        if (node.kind == Expression::Kind::call) argument.source().fail(node.offset, what_fits);
        if (node.kind != Expression::Kind::name) continue;
        const std::string_view name = argument.name(node);
        if (!is_parameter(name) || (!found.empty() && name != found))
            argument.source().fail(node.offset, what_fits);
        found = name;
    }
    if (found.empty()) argument.source().fail(call_offset, what_fits, "a number as the argument");
    return found;
}

} // namespace

Angle read_angle(ExpressionView argument, std::size_t call_offset,
                 const std::function<bool(std::string_view)>& is_parameter, base::Run& run) {
    const std::string name = only_name(argument, call_offset, is_parameter);
    const algebra::Ring ring(algebra::CoefficientField::rationals(), {name});
    const Polynomial t = Polynomial::variable(ring, std::size_t{0});
    const RationalFunction value =
        evaluate(argument, ring, {[&t](std::string_view, std::size_t) { return RationalFunction(t); }}, run);
    const Polynomial& f = value.numerator;
    const bool fits = value.denominator.is_constant() && f.size() == 1 && f.exponent(0, 0) == 1;
    const mpq_class factor =
        fits ? f.leading_coefficient() / value.denominator.leading_coefficient() : mpq_class(0);
    if (!fits || factor.get_den() != 1)
        argument.source().fail(call_offset, what_fits, "another argument of the function");
    if (mpz_sizeinbase(factor.get_num_mpz_t(), 2) > 62)
        argument.source().fail(call_offset, "a multiple below 2^62", factor.get_str());
    return {name, factor.get_num().get_si()};
}

CosineAndSine multiple_angle(const Polynomial& c, const Polynomial& s, std::int64_t multiple,
                             base::Run& run) {
    // T₀ = 1, T₁ = c and U₋₁ = 0, U₀ = 1; both continue by P_{k+1} = 2c·P_k − P_{k−1}.
    const Polynomial one = Polynomial::constant(c.ring(), 1);
    const Polynomial twice_c = c.scaled(2);
    const auto step = [&](Polynomial& before, Polynomial& current) {
        before = twice_c * current - before;
        std::swap(before, current);
    };
    Polynomial first_before = c; // T₋₁ = T₁
    Polynomial T = one;
    Polynomial second_before = -one; // U₋₂ = −U₀
    Polynomial U(c.ring());          // U₋₁
    for (std::int64_t k = 0; k < multiple; ++k) {
        run.poll();
        step(first_before, T);
        step(second_before, U);
    }
    return {T, s * U};
}

} // namespace eliminant::implicit
