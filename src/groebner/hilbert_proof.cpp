#include "groebner/hilbert_proof.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/grading.hpp"
#include "groebner/monomial_ideal.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace eliminant::groebner {

using algebra::Polynomial;
using algebra::Ring;

bool is_basis_of_homogenization(std::span<const Polynomial> candidate, std::size_t h,
                                std::span<const Polynomial> graded_basis, base::Run& run) {
    if (candidate.empty() || graded_basis.empty()) return candidate.empty() && graded_basis.empty();
    if (!std::ranges::all_of(candidate, &Polynomial::is_homogeneous)) return false;

    // The same number of variables for both series: h divides none of the second leading monomials.
    std::vector<Exponents> leads = leading_exponents(graded_basis);
    for (Exponents& m : leads) m.push_back(0);
    if (hilbert_numerator(leading_exponents(candidate), run) != hilbert_numerator(std::move(leads), run))
        return false;

    const Ring& ring = graded_basis.front().ring();
    std::vector<std::size_t> without_h;
    for (const std::string& name : candidate.front().ring().names())
        without_h.push_back(ring.index_of(name).value_or(Polynomial::dropped));
    return std::ranges::all_of(candidate, [&](const Polynomial& g) {
        return normal_form(dehomogenize(g, h).in_ring(ring, without_h), graded_basis, run).is_zero();
    });
}

} // namespace eliminant::groebner
