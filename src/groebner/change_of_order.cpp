#include "groebner/change_of_order.hpp"

#include "groebner/order_lifting.hpp"

#include <utility>

namespace eliminant::groebner {

using algebra::Integer;
using algebra::MonomialOrder;
using algebra::Polynomial;
using algebra::PolynomialBuilder;
using algebra::Ring;

namespace {

/// Above it vectors of D residues for D monomials pass 4 GB.
constexpr std::size_t max_dimension = 32768;

/// Whether linear algebra suits the ideal: normal forms in a large residue class ring that are sparse, as
/// those of binomials, are better left to Buchberger's algorithm, which follows the terms there are.
bool suits(const Staircase& staircase, std::span<const Polynomial> basis) {
    constexpr std::size_t small = 1000;
    std::size_t terms = 0;
    for (const Polynomial& f : basis) terms += f.size();
    return staircase.size() <= small || terms / basis.size() >= staircase.size() / 20;
}

std::vector<Polynomial> polynomials(const ConvertedBasis& basis, const Ring& target) {
    std::vector<Polynomial> result;
    for (std::size_t i = 0; i < basis.leads.size(); ++i) {
        PolynomialBuilder builder(target);
        builder.add(Integer(1), basis.leads[i].exponents());
        for (std::size_t s = 0; s < basis.standard.size(); ++s)
            if (basis.tails[i][s] != 0)
                builder.add(-Integer(basis.tails[i][s]), basis.standard[s].exponents());
        result.push_back(builder.build());
    }
    return result;
}

} // namespace

std::optional<ChangedOrder> change_order(std::span<const Polynomial> reduced_basis, const Ring& target,
                                         Proof proof, base::Run& run) {
    const std::optional<Staircase> staircase = Staircase::of(reduced_basis, max_dimension, run);
    if (!staircase || !suits(*staircase, reduced_basis)) return std::nullopt;
    if (staircase->size() == 0) return ChangedOrder{{Polynomial::constant(target, 1)}, 0};
    std::vector<std::size_t> variables;
    for (const std::string& name : target.names())
        variables.push_back(reduced_basis.front().ring().index_of(name).value());
    if (target.field().is_rationals())
        return OrderLifting(*staircase, reduced_basis, target, std::move(variables), run).compute(proof);
    const bool try_shape = target.order().kind() == MonomialOrder::Kind::lex || target.variable_count() == 1;
    QuotientAlgebra algebra(*staircase, reduced_basis, target.field().prime_field(), run);
    return ChangedOrder{polynomials(convert(algebra, target, variables, try_shape, run), target), 0};
}

} // namespace eliminant::groebner
