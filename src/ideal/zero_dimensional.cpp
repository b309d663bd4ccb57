#include "eliminant/ideal/zero_dimensional.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/ideal/hilbert.hpp"
#include "ideal/monomial_ideal.hpp"
#include "ideal/ring_change.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::ideal {

using algebra::Monomial;
using algebra::Polynomial;
using algebra::Ring;

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
    const auto is_divisor = [&m](const Exponents& l) { return divides(l, m); };
    for (; std::ranges::none_of(leading, is_divisor); ++m[variable])
        collect_standard(leading, m, variable + 1, ring, result, run);
    m[variable] = 0;
}

/// Vectors in echelon form, each with the linear combination of the vectors given that it is.
class Echelon {
  public:
    /// If `vector` depends on those added before, the combination that gives 0; otherwise adds it.
    std::optional<Polynomial> add(Polynomial vector, Polynomial combination) {
        // Rows descend by leading monomial; one pass clears all leading monomials in the way.
        auto row = rows_.begin();
        for (; row != rows_.end() && !vector.is_zero(); ++row) {
            const auto order = row->vector.leading_monomial() <=> vector.leading_monomial();
            if (order > 0) continue;
            if (order < 0) break;
            const mpq_class factor = vector.leading_coefficient() / row->vector.leading_coefficient();
            vector -= row->vector.scaled(factor);
            combination -= row->combination.scaled(factor);
        }
        if (vector.is_zero()) return combination;
        rows_.insert(row, {std::move(vector), std::move(combination)});
        return std::nullopt;
    }

  private:
    struct Row {
        Polynomial vector;
        Polynomial combination;
    };
    std::vector<Row> rows_;
};

} // namespace

bool is_zero_dimensional(const Ideal& I, base::Run& run) {
    const std::size_t n = I.ring().variable_count();
    std::vector<bool> has_power(n, false);
    if (I.is_unit(run)) return true;
    for (const Exponents& m : leading_exponents(I.some_groebner_basis(run))) {
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
    const std::vector<Exponents> leading = leading_exponents(I.groebner_basis(run));
    if (!I.is_unit(run)) collect_standard(leading, m, 0, I.ring(), result, run);
    std::ranges::sort(result);
    return result;
}

Polynomial minimal_polynomial(const Ideal& I, const Polynomial& f, base::Run& run) {
    require_same_ring(I.ring(), f.ring(), "minimal polynomial modulo an ideal");
    require_zero_dimensional(I, "minimal polynomial", run);
    const std::vector<Polynomial>& basis = I.some_groebner_basis(run);
    const Ring ring = I.ring().with_order(I.is_zero() ? I.ring().order() : basis.front().ring().order());
    const Polynomial multiplier = normal_form(f.in_ring(ring), basis, run);
    const Ring univariate(ring.field(), {"t"});
    const Polynomial t = Polynomial::variable(univariate, std::size_t{0});

    Echelon echelon;
    Polynomial power_of_t = Polynomial::constant(univariate, 1);
    Polynomial power_of_f = normal_form(Polynomial::constant(ring, 1), basis, run);
    for (;;) {
        run.poll();
        if (const auto relation = echelon.add(power_of_f, power_of_t)) return relation->monic();
        power_of_t = power_of_t * t;
        power_of_f = normal_form(multiply(power_of_f, multiplier, run), basis, run);
    }
}

} // namespace eliminant::ideal
