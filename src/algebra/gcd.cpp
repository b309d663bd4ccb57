#include "eliminant/algebra/gcd.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/coefficients.hpp"

#include "gcd_remainders.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::algebra {

Polynomial gcd(const Polynomial& f, const Polynomial& g, base::Run& run) {
    require_same_ring(f.ring(), g.ring(), "greatest common divisor of polynomials");
    if (f.is_zero()) return g.primitive_part();
    if (g.is_zero()) return f.primitive_part();
    return gcd_by_remainders(f.primitive_part(), g.primitive_part(), run);
}

Polynomial gcd(const Polynomial& f, const Polynomial& g) {
    base::Run run;
    return gcd(f, g, run);
}

Polynomial gcd(std::span<const Polynomial> polynomials, base::Run& run) {
    if (polynomials.empty()) throw DomainError("the greatest common divisor of no polynomials");
    // Small ones first: the gcd only shrinks, and its first value bounds the work of all others.
    std::vector<const Polynomial*> sequence;
    for (const Polynomial& f : polynomials) {
        require_same_ring(polynomials.front().ring(), f.ring(), "greatest common divisor of polynomials");
        if (!f.is_zero()) sequence.push_back(&f);
    }
    std::ranges::stable_sort(sequence, {}, [](const Polynomial* f) { return f->size(); });
    Polynomial common(polynomials.front().ring());
    for (const Polynomial* f : sequence) {
        common = gcd(common, *f, run);
        if (common.is_constant()) break;
    }
    return common;
}

Polynomial lcm(const Polynomial& f, const Polynomial& g, base::Run& run) {
    const Polynomial common = gcd(f, g, run);
    if (f.is_zero() || g.is_zero()) return Polynomial(f.ring());
    return multiply(divide_exactly(f, common, run), g, run).primitive_part();
}

Polynomial lcm(const Polynomial& f, const Polynomial& g) {
    base::Run run;
    return lcm(f, g, run);
}

bool coprime(const Polynomial& f, const Polynomial& g, base::Run& run) {
    const Polynomial common = gcd(f, g, run);
    return !common.is_zero() && common.is_constant();
}

Polynomial content(const Polynomial& f, std::span<const std::size_t> variables, base::Run& run) {
    if (f.is_zero()) return f;
    std::vector<Polynomial> parts;
    for (CoefficientTerm& term : coefficients(f, variables)) parts.push_back(std::move(term.coefficient));
    return gcd(parts, run);
}

Polynomial primitive_part(const Polynomial& f, std::span<const std::size_t> variables, base::Run& run) {
    if (f.is_zero()) return f;
    return divide_exactly(f, content(f, variables, run), run).primitive_part();
}

} // namespace eliminant::algebra
