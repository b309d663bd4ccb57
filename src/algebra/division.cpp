#include "eliminant/algebra/arithmetic.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::algebra {

Division divide(const Polynomial& f, std::span<const Polynomial> divisors, base::Run& run) {
    const Ring& ring = f.ring();
    for (const Polynomial& g : divisors) {
        require_same_ring(ring, g.ring(), "division of polynomials");
        if (g.is_zero()) throw DomainError("division by the zero polynomial");
    }
    Division result{std::vector<Polynomial>(divisors.size(), Polynomial(ring)), Polynomial(ring)};
    Polynomial rest = f;
    while (!rest.is_zero()) {
        run.poll();
        const Monomial leading = rest.leading_monomial();
        const auto divides = [&leading](const Polynomial& g) { return g.leading_monomial().divides(leading); };
        const auto divisor = std::ranges::find_if(divisors, divides);
        if (divisor == divisors.end()) {
            result.remainder += rest.leading_term();
            rest = rest.tail();
            continue;
        }
        const Polynomial step = Polynomial::term(leading / divisor->leading_monomial(),
                                                 rest.leading_coefficient() / divisor->leading_coefficient());
        result.quotients[static_cast<std::size_t>(divisor - divisors.begin())] += step;
        rest -= multiply(step, *divisor, run);
    }
    return result;
}

Polynomial normal_form(const Polynomial& f, std::span<const Polynomial> divisors, base::Run& run) {
    return divide(f, divisors, run).remainder;
}

std::optional<Polynomial> try_divide(const Polynomial& a, const Polynomial& b, base::Run& run) {
    Division division = divide(a, {&b, 1}, run);
    if (!division.remainder.is_zero()) return std::nullopt;
    return std::move(division.quotients.front());
}

std::optional<Polynomial> try_divide(const Polynomial& a, const Polynomial& b) {
    base::Run run;
    return try_divide(a, b, run);
}

Polynomial divide_exactly(const Polynomial& a, const Polynomial& b, base::Run& run) {
    auto quotient = try_divide(a, b, run);
    if (!quotient) throw DomainError("exact division of polynomials: the divisor does not divide");
    return *std::move(quotient);
}

Polynomial divide_exactly(const Polynomial& a, const Polynomial& b) {
    base::Run run;
    return divide_exactly(a, b, run);
}

Polynomial s_polynomial(const Polynomial& f, const Polynomial& g) {
    const Monomial common = lcm(f.leading_monomial(), g.leading_monomial());
    return f.times_term(common / f.leading_monomial(), 1 / f.leading_coefficient()) -
           g.times_term(common / g.leading_monomial(), 1 / g.leading_coefficient());
}

} // namespace eliminant::algebra
