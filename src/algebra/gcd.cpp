#include "eliminant/algebra/gcd.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/coefficients.hpp"

#include "gcd_degrees.hpp"
#include "gcd_modular.hpp"
#include "gcd_remainders.hpp"
#include "random.hpp"
#include "term_maps.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace eliminant::algebra {

namespace {

Polynomial one(const Ring& ring) { return Polynomial::constant(ring, 1); }

/// Whether f and g are nonzero multiples of each other.
bool associated(const Polynomial& f, const Polynomial& g) {
    return f.size() == g.size() && f.leading_monomial() == g.leading_monomial() &&
           f.primitive_part() == g.primitive_part();
}

/// For each variable the gcd of all its exponents in f and g; 0 where it does not occur.
std::vector<std::uint64_t> strides(const Polynomial& f, const Polynomial& g) {
    std::vector<std::uint64_t> result(f.ring().variable_count(), 0);
    for (const Polynomial* h : {&f, &g}) {
        for (std::size_t i = 0; i < h->size(); ++i) {
            for (std::size_t v = 0; v < result.size(); ++v) {
                if (result[v] != 1) result[v] = std::gcd(result[v], h->exponent(i, v));
            }
        }
    }
    return result;
}

/// gcd of f and g that are 0 degrees apart from it in some variables: that of all their coefficients with
/// respect to these. It has fewer variables to care for, and most lists of coefficients are soon seen to be
/// coprime.
Polynomial gcd_of_coefficients(const Polynomial& f, const Polynomial& g,
                               std::span<const std::size_t> variables, base::Run& run) {
    std::vector<Polynomial> parts;
    for (const Polynomial* h : {&f, &g}) {
        for (CoefficientTerm& term : coefficients(*h, variables))
            parts.push_back(std::move(term.coefficient));
    }
    return gcd(parts, run);
}

/// gcd of normalised polynomials that no variable divides.
Polynomial gcd_without_monomials(const Polynomial& f, const Polynomial& g, base::Run& run) {
    if (f.is_constant() || g.is_constant()) return one(f.ring());
    if (associated(f, g)) return f;
    Random random(run.seed());
    const auto bounds = gcd_degree_bounds(f, g, random, run);
    if (std::ranges::all_of(bounds, [](std::uint64_t bound) { return bound == 0; })) return one(f.ring());

    std::vector<std::size_t> absent; // from the gcd, but not from f and g
    bool whole_f = true;
    bool whole_g = true;
    for (std::size_t v = 0; v < bounds.size(); ++v) {
        const auto degree_f = static_cast<std::uint64_t>(f.degree(v));
        const auto degree_g = static_cast<std::uint64_t>(g.degree(v));
        if (bounds[v] == 0 && (degree_f > 0 || degree_g > 0)) absent.push_back(v);
        whole_f = whole_f && bounds[v] == degree_f;
        whole_g = whole_g && bounds[v] == degree_g;
    }
    if (!absent.empty()) return gcd_of_coefficients(f, g, absent, run);
    if (whole_f && try_divide(g, f, run)) return f;
    if (whole_g && try_divide(f, g, run)) return g;
    if (auto h = gcd_by_images(f, g, bounds, random, run)) return *std::move(h);
    return gcd_by_remainders(f, g, run);
}

} // namespace

Polynomial gcd(const Polynomial& f, const Polynomial& g, base::Run& run) {
    require_same_ring(f.ring(), g.ring(), "greatest common divisor of polynomials");
    run.poll();
    if (f.is_zero()) return g.primitive_part();
    if (g.is_zero()) return f.primitive_part();
    if (f.is_constant() || g.is_constant()) return one(f.ring());

    const std::vector<std::uint64_t> monomial_f = monomial_content(f);
    const std::vector<std::uint64_t> monomial_g = monomial_content(g);
    std::vector<std::uint64_t> common(monomial_f.size());
    std::ranges::transform(monomial_f, monomial_g, common.begin(),
                           [](auto a, auto b) { return std::min(a, b); });
    Polynomial a = divided_by_monomial(f.primitive_part(), monomial_f);
    Polynomial b = divided_by_monomial(g.primitive_part(), monomial_g);

    // gcd(a(x^d), b(x^d)) = gcd(a, b)(x^d): remainder sequences in x^d contain powers of x^d only.
    const std::vector<std::uint64_t> stride = strides(a, b);
    const bool deflate = std::ranges::any_of(stride, [](std::uint64_t d) { return d > 1; });
    if (deflate) {
        const auto lower = [&stride](std::size_t v, std::uint64_t e) { return e == 0 ? 0 : e / stride[v]; };
        a = with_exponents(a, lower).primitive_part();
        b = with_exponents(b, lower).primitive_part();
    }
    Polynomial h = gcd_without_monomials(a, b, run);
    if (!deflate && std::ranges::all_of(common, [](std::uint64_t e) { return e == 0; })) return h;
    return with_exponents(h, [&](std::size_t v,
                                 std::uint64_t e) { return common[v] + (stride[v] > 1 ? e * stride[v] : e); })
        .primitive_part();
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
