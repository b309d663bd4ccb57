#include "eliminant/ideal/zero_dimensional.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/ideal/hilbert.hpp"
#include "eliminant/ideal/operations.hpp"
#include "groebner/monomial_ideal.hpp"
#include "ideal/ring_change.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace eliminant::ideal {

using algebra::Monomial;
using algebra::MonomialOrder;
using algebra::Polynomial;
using algebra::Ring;
using groebner::Exponents;

namespace {

void require_zero_dimensional(const Ideal& I, const char* doing, base::Run& run) {
    if (!is_zero_dimensional(I, run))
        throw DomainError(std::string(doing) + ": the ideal is not zero-dimensional");
}

/// The monomials with the exponents of m in the variables before `variable`, and any in the others, that no
/// leading monomial divides.
void collect_standard(const std::vector<Exponents>& leading, Exponents& m, std::size_t variable,
                      const Ring& ring, std::vector<Monomial>& result, base::Run& run) {
    run.poll();
    if (variable == m.size()) {
        result.emplace_back(ring, m);
        return;
    }
    // m has exponent 0 from `variable` on. Once a leading monomial divides it, larger exponents are of no
    // use.
    const auto is_divisor = [&m](const Exponents& l) { return groebner::divides(l, m); };
    for (; std::ranges::none_of(leading, is_divisor); ++m[variable])
        collect_standard(leading, m, variable + 1, ring, result, run);
    m[variable] = 0;
}

} // namespace

bool is_zero_dimensional(const Ideal& I, base::Run& run) {
    const std::size_t n = I.ring().variable_count();
    std::vector<bool> has_power(n, false);
    if (I.is_unit(run)) return true;
    for (const Exponents& m : groebner::leading_exponents(I.some_groebner_basis(run))) {
        const auto occurs = [](std::uint64_t e) { return e != 0; };
        if (std::ranges::count_if(m, occurs) != 1) continue;
        has_power[static_cast<std::size_t>(std::ranges::find_if(m, occurs) - m.begin())] = true;
    }
    return std::ranges::all_of(has_power, [](bool has) { return has; });
}

std::optional<mpz_class> vector_space_dimension(const Ideal& I, base::Run& run) {
    if (!is_zero_dimensional(I, run)) return std::nullopt;
    return degree(I, run);
}

std::vector<Monomial> standard_monomials(const Ideal& I, base::Run& run) {
    require_zero_dimensional(I, "standard monomials", run);
    std::vector<Monomial> result;
    Exponents m(I.ring().variable_count(), 0);
    const std::vector<Exponents> leading = groebner::leading_exponents(I.groebner_basis(run));
    if (!I.is_unit(run)) collect_standard(leading, m, 0, I.ring(), result, run);
    std::ranges::sort(result);
    return result;
}

Polynomial minimal_polynomial(const Ideal& I, const Polynomial& f, base::Run& run) {
    require_same_ring(I.ring(), f.ring(), "minimal polynomial modulo an ideal");
    require_zero_dimensional(I, "minimal polynomial", run);
    const Ring univariate(I.ring().field(), {"t"});
    if (I.is_unit(run)) return Polynomial::constant(univariate, 1);
    // With a variable more, a large one, the basis and t − f's normal form are a reduced basis of an ideal
    // with the same residue class ring, in which t is f; what is looked for generates its elimination ideal.
    std::vector<std::string> names = {fresh_name(I.ring(), "t")};
    names.insert(names.end(), I.ring().names().begin(), I.ring().names().end());
    const Ring extended(I.ring().field(), std::move(names), MonomialOrder::elimination({0}));
    const Polynomial t = Polynomial::variable(extended, std::size_t{0});
    const Ring graded = I.ring().with_order(MonomialOrder::degrevlex());
    std::vector<Polynomial> with_t;
    const std::vector<Polynomial>& basis = I.groebner_basis(graded.order(), run);
    for (const Polynomial& g : basis) with_t.push_back(g.in_ring(extended));
    const Polynomial image = normal_form(f.in_ring(graded), basis, run);
    with_t.push_back((t - image.in_ring(extended)).primitive_part());
    std::vector<std::size_t> others(I.ring().variable_count());
    std::iota(others.begin(), others.end(), std::size_t{1});
    const Ideal J = Ideal::from_groebner_basis(extended, extended.order(), std::move(with_t));
    const Polynomial generator = eliminate(J, others, run).generators().front();
    return generator.in_ring(univariate, std::vector<std::size_t>{0}).monic();
}

} // namespace eliminant::ideal
