#include "eliminant/groebner/buchberger.hpp"

#include "eliminant/algebra/arithmetic.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::groebner {

using algebra::Polynomial;

std::vector<Polynomial> reduced_basis(std::vector<Polynomial> basis, base::Run& run) {
    std::erase_if(basis, [](const Polynomial& f) { return f.is_zero(); });
    std::ranges::stable_sort(basis, [](const Polynomial& f, const Polynomial& g) {
        return f.leading_monomial() < g.leading_monomial();
    });
    std::vector<Polynomial> minimal;
    for (Polynomial& f : basis) {
        // Ascending: what divides lm(f) properly comes before f, and of equal ones the first is kept.
        const auto divides = [&f](const Polynomial& g) {
            return g.leading_monomial().divides(f.leading_monomial());
        };
        if (std::ranges::none_of(minimal, divides)) minimal.push_back(std::move(f));
    }
    std::vector<Polynomial> reduced;
    for (const Polynomial& f : minimal) {
        // The tail of f involves only smaller monomials, so only smaller, already reduced elements can reduce
        // it.
        const Polynomial rest = normal_form(f.tail(), reduced, run);
        reduced.push_back((f.leading_term() + rest).primitive_part());
    }
    return reduced;
}

bool is_groebner(std::span<const Polynomial> elements, base::Run& run) {
    std::vector<Polynomial> nonzero;
    std::ranges::copy_if(elements, std::back_inserter(nonzero),
                         [](const Polynomial& f) { return !f.is_zero(); });
    for (std::size_t i = 0; i < nonzero.size(); ++i) {
        for (std::size_t j = i + 1; j < nonzero.size(); ++j) {
            if (!normal_form(algebra::s_polynomial(nonzero[i], nonzero[j]), nonzero, run).is_zero())
                return false;
        }
    }
    return true;
}

bool is_reduced_groebner(std::span<const Polynomial> elements, base::Run& run) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const Polynomial& f = elements[i];
        if (f.is_zero() || f != f.primitive_part()) return false;
        if (i != 0 && !(elements[i - 1].leading_monomial() < f.leading_monomial())) return false;
        for (std::size_t j = 0; j < elements.size(); ++j) {
            if (i == j || elements[j].is_zero()) continue;
            for (std::size_t k = 0; k < f.size(); ++k) {
                if (elements[j].leading_monomial().divides(f.monomial(k))) return false;
            }
        }
    }
    return is_groebner(elements, run);
}

} // namespace eliminant::groebner
