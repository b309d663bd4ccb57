#include "eliminant/algebra/arithmetic.hpp"

#include "term_arithmetic.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::algebra {

namespace {

/// Σ over i in [first, last) of a_i·b, summed in a balanced tree of merges.
template <class Domain, class Terms>
Terms product_of_range(const Domain& domain, const Terms& a, std::size_t first, std::size_t last, const Terms& b,
                       base::Run& run) {
    if (last - first == 1) {
        run.poll();
        Terms row = b;
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (!b.layout->multiply(a.monomial(first), b.monomial(j), row.monomial(j)))
                throw OverflowError("an exponent or weighted degree exceeds 2^63 - 1");
            row.coefficients[j] = domain.multiply(a.coefficients[first], b.coefficients[j]);
        }
        return row;
    }
    const std::size_t middle = first + (last - first) / 2;
    const Terms left = product_of_range(domain, a, first, middle, b, run);
    const Terms right = product_of_range(domain, a, middle, last, b, run);
    return linear_combination(domain, left, Domain::one(), right, Domain::one());
}

template <class Domain, class Terms>
Terms product(const Domain& domain, const Ring& ring, const Terms& a, const Terms& b, base::Run& run) {
    const auto maxima_a = a.field_maxima();
    const auto maxima_b = b.field_maxima();
    std::uint64_t widest = 0;
    for (std::size_t i = 0; i < maxima_a.size(); ++i) widest = std::max(widest, maxima_a[i] + maxima_b[i]);
    const MonomialLayout& layout = ring.layout_for(widest);
    if (a.empty() || b.empty()) return Terms(layout);
    return product_of_range(domain, *repacked(a, layout), 0, a.size(), *repacked(b, layout), run);
}

} // namespace

Polynomial multiply(const Polynomial& a, const Polynomial& b, base::Run& run) {
    require_same_ring(a.ring(), b.ring(), "product of polynomials");
    if (!a.ring().field().is_rationals()) {
        const PrimeDomain domain{a.ring().field().prime_field()};
        return Polynomial::from_terms(a.ring(),
                                      product(domain, a.ring(), a.residue_terms(), b.residue_terms(), run));
    }
    return Polynomial::from_terms(a.ring(),
                                  product(IntegerDomain{}, a.ring(), a.integer_terms(), b.integer_terms(), run),
                                  a.denominator() * b.denominator());
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    base::Run run;
    return multiply(a, b, run);
}

Polynomial pow(const Polynomial& f, std::uint64_t exponent, base::Run& run) {
    Polynomial result = Polynomial::constant(f.ring(), 1);
    Polynomial square = f;
    for (; exponent != 0; exponent >>= 1) {
        if ((exponent & 1) != 0) result = multiply(result, square, run);
        if (exponent > 1) square = multiply(square, square, run);
    }
    return result;
}

Polynomial pow(const Polynomial& f, std::uint64_t exponent) {
    base::Run run;
    return pow(f, exponent, run);
}

} // namespace eliminant::algebra
