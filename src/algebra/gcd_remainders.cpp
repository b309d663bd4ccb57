#include "gcd_remainders.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/coefficients.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace eliminant::algebra {

namespace {

Polynomial content_by_remainders(const Polynomial& f, std::size_t variable, base::Run& run) {
    std::optional<Polynomial> common;
    for (const CoefficientTerm& term : coefficients(f, variable)) {
        common =
            common ? gcd_by_remainders(*common, term.coefficient, run) : term.coefficient.primitive_part();
        if (common->is_constant()) break;
    }
    return *std::move(common);
}

/// A pseudo-remainder of f by g in one variable: lc^k·f − q·g for some k, of smaller degree than g. Each step
/// multiplies by no more of the leading coefficient than the cancellation needs.
Polynomial pseudo_remainder(Polynomial f, const Polynomial& g, std::size_t variable, base::Run& run) {
    const Polynomial lead = leading_coefficient(g, variable);
    const Polynomial x = Polynomial::variable(f.ring(), variable);
    while (!f.is_zero() && f.degree(variable) >= g.degree(variable)) {
        run.poll();
        const auto shift = static_cast<std::uint64_t>(f.degree(variable) - g.degree(variable));
        const Polynomial step = multiply(leading_coefficient(f, variable), pow(x, shift, run), run);
        f = (multiply(lead, f, run) - multiply(step, g, run)).primitive_part();
    }
    return f;
}

/// The variable of least positive degree, whose sequence is the shortest; nothing if both are constants.
std::optional<std::size_t> main_variable(const Polynomial& f, const Polynomial& g) {
    std::optional<std::size_t> best;
    std::int64_t least = 0;
    for (std::size_t v = 0; v < f.ring().variable_count(); ++v) {
        const std::int64_t degree = std::max(f.degree(v), g.degree(v));
        if (degree <= 0 || (best && degree >= least)) continue;
        best = v;
        least = degree;
    }
    return best;
}

} // namespace

Polynomial gcd_by_remainders(const Polynomial& f, const Polynomial& g, base::Run& run) {
    run.poll();
    const auto variable = main_variable(f, g);
    if (!variable) return Polynomial::constant(f.ring(), 1);
    const Polynomial content_f = content_by_remainders(f, *variable, run);
    const Polynomial content_g = content_by_remainders(g, *variable, run);
    const Polynomial content = gcd_by_remainders(content_f, content_g, run);
    Polynomial a = divide_exactly(f, content_f, run);
    Polynomial b = divide_exactly(g, content_g, run);
    if (a.degree(*variable) < b.degree(*variable)) std::swap(a, b);
    while (b.degree(*variable) > 0) {
        Polynomial r = pseudo_remainder(std::move(a), b, *variable, run);
        if (!r.is_zero()) r = divide_exactly(r, content_by_remainders(r, *variable, run), run);
        a = std::exchange(b, std::move(r));
    }
    // b is 0 and a the gcd of the primitive parts, or b is free of the variable, and they are coprime.
    return b.is_zero() ? multiply(content, a, run).primitive_part() : content;
}

} // namespace eliminant::algebra
