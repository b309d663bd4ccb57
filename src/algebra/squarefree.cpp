#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/calculus.hpp"
#include "eliminant/algebra/coefficients.hpp"
#include "eliminant/algebra/gcd.hpp"

#include "integer_power.hpp"
#include "term_maps.hpp"

#include <map>
#include <optional>
#include <utility>

namespace eliminant::algebra {

namespace {

/// Squarefree factors by multiplicity.
using Parts = std::map<std::uint64_t, Polynomial>;

void multiply_into(Parts& parts, std::uint64_t multiplicity, const Polynomial& factor, base::Run& run) {
    const auto [entry, is_new] = parts.try_emplace(multiplicity, factor);
    if (!is_new) entry->second = multiply(entry->second, factor, run);
}

/// Yun's algorithm for f primitive with respect to the variable, in characteristic 0 or above the degree of f
/// in it.
///
/// Every irreducible factor q of f contains the variable and q' ≠ 0, so q does not divide q'. Therefore
/// f = ∏ fᵢⁱ gives  w = f/gcd(f, f') = ∏ fᵢ  and  y = f'/gcd(f, f') = Σ i·fᵢ'·w/fᵢ,  and fᵢ divides y − i·w'
/// while the others do not.
void decompose_by_derivative(const Polynomial& f, std::size_t variable, Parts& parts, base::Run& run) {
    const Polynomial slope = derivative(f, variable);
    const Polynomial common = gcd(f, slope, run);
    Polynomial w = divide_exactly(f, common, run);
    Polynomial z = divide_exactly(slope, common, run) - derivative(w, variable);
    std::uint64_t multiplicity = 1;
    for (; !z.is_zero(); ++multiplicity) {
        const Polynomial factor = gcd(w, z, run);
        if (!factor.is_constant()) {
            multiply_into(parts, multiplicity, factor, run);
            w = divide_exactly(w, factor, run);
            z = divide_exactly(z, factor, run);
        }
        z -= derivative(w, variable);
    }
    if (!w.is_constant()) multiply_into(parts, multiplicity, w.primitive_part(), run);
}

/// g with g^p = f for f all of whose exponents are divisible by p; coefficients of GF(p) are their own p-th
/// roots.
Polynomial frobenius_root(const Polynomial& f) {
    const std::uint64_t p = f.ring().field().characteristic();
    return with_exponents(f, [p](std::size_t /*variable*/, std::uint64_t e) { return e / p; });
}

/// The decomposition in characteristic p, multiplicities times `scale`.
///
/// Let f = ∏ q^e over irreducible q. GF(p) is perfect, so some ∂q ≠ 0, and q does not divide it. Then
/// c = gcd(f, all ∂f) contains q exactly e − 1 times if p does not divide e, and e times if it does. So
/// w = f/c is the product of the q with p ∤ e, from which the loop peels them off by multiplicity, and what
/// is left of c is ∏ q^e over p | e, a p-th power.
void decompose_by_gradient(Polynomial f, std::uint64_t scale, Parts& parts, base::Run& run) {
    while (!f.is_constant()) {
        Polynomial c = f;
        for (std::size_t v = 0; v < f.ring().variable_count() && !c.is_constant(); ++v) {
            const Polynomial slope = derivative(f, v);
            if (!slope.is_zero()) c = gcd(c, slope, run);
        }
        Polynomial w = divide_exactly(f, c, run);
        for (std::uint64_t multiplicity = 1; !w.is_constant(); ++multiplicity) {
            const Polynomial rest = gcd(w, c, run);
            const Polynomial factor = divide_exactly(w, rest, run);
            if (!factor.is_constant())
                multiply_into(parts, scale * multiplicity, factor.primitive_part(), run);
            c = divide_exactly(c, rest, run);
            w = rest;
        }
        f = frobenius_root(c);
        scale *= f.ring().field().characteristic();
    }
}

/// A variable of least positive degree; nothing for a constant.
std::optional<std::size_t> lowest_variable(const Polynomial& f) {
    std::optional<std::size_t> best;
    for (std::size_t v = 0; v < f.ring().variable_count(); ++v) {
        if (f.degree(v) > 0 && (!best || f.degree(v) < f.degree(*best))) best = v;
    }
    return best;
}

bool derivatives_tell(const Polynomial& f) {
    const std::uint32_t p = f.ring().field().characteristic();
    if (p == 0) return true;
    for (std::size_t v = 0; v < f.ring().variable_count(); ++v) {
        if (f.degree(v) >= static_cast<std::int64_t>(p)) return false;
    }
    return true;
}

Parts decompose(Polynomial f, base::Run& run) {
    Parts parts;
    // Powers of variables are read off: peeling x^1000000 by multiplicities would take as many steps.
    const std::vector<std::uint64_t> powers = monomial_content(f);
    f = divided_by_monomial(f, powers);
    for (std::size_t v = 0; v < powers.size(); ++v) {
        if (powers[v] != 0) multiply_into(parts, powers[v], Polynomial::variable(f.ring(), v), run);
    }
    if (!derivatives_tell(f)) {
        decompose_by_gradient(std::move(f), 1, parts, run);
        return parts;
    }
    // The content with respect to a variable holds the factors free of it: other variables decide about
    // those.
    while (const auto variable = lowest_variable(f)) {
        const Polynomial rest = content(f, std::span(&*variable, 1), run);
        decompose_by_derivative(divide_exactly(f, rest, run), *variable, parts, run);
        f = rest;
    }
    return parts;
}

} // namespace

Factorization squarefree_decomposition(const Polynomial& f, base::Run& run) {
    if (f.is_zero()) return {0, {}};
    Factorization result{f.leading_coefficient(), {}};
    // Leading coefficients of the bases are 1 over GF(p).
    for (auto& [multiplicity, base] : decompose(f.primitive_part(), run)) {
        if (f.ring().field().is_rationals())
            result.unit /=
                checked_power(Integer(base.leading_coefficient().get_num()), multiplicity).to_mpz();
        result.factors.push_back({base, multiplicity});
    }
    return result;
}

Polynomial squarefree_part(const Polynomial& f, base::Run& run) {
    if (f.is_zero()) return f;
    Polynomial product = Polynomial::constant(f.ring(), 1);
    if (!derivatives_tell(f)) {
        for (const auto& [multiplicity, base] : decompose(f.primitive_part(), run))
            product = multiply(product, base, run);
        return product.primitive_part();
    }
    // As in decompose(), without telling multiplicities apart.
    Polynomial rest = f.primitive_part();
    while (const auto variable = lowest_variable(rest)) {
        const Polynomial free = content(rest, std::span(&*variable, 1), run);
        const Polynomial primitive = divide_exactly(rest, free, run);
        const Polynomial repeated = gcd(primitive, derivative(primitive, *variable), run);
        product = multiply(product, divide_exactly(primitive, repeated, run), run);
        rest = free;
    }
    return product.primitive_part();
}

} // namespace eliminant::algebra
