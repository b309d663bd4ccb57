// An ideal over the field of rational functions in some of its variables, and at a random value of these.
#pragma once

#include "eliminant/ideal/ideal.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace eliminant::ideal {

using Variables = std::vector<std::size_t>; ///< ascending indices

/// The indices below variable_count that are not in `some`.
Variables complement(const Variables& some, std::size_t variable_count);

/// The coefficient in K[U] of the leading monomial of f in the bound variables, U being the others; f is of a
/// ring whose order is a product order that puts the bound variables first.
algebra::Polynomial leading_coefficient_over(const algebra::Polynomial& f, const Variables& bound);

/// Whether J·K(U)[bound] is radical, and stays so over every extension of K(U), where that can be told from
/// one fibre; `bound` are the variables outside a maximal set U of variables independent modulo J.
///
/// Over A = K[U] localised at the leading coefficients of a Groebner basis of J in a product order, K[x]/J is
/// free on the standard monomials. So its fibre at a value u of U, and modulo a prime, where no leading
/// coefficient vanishes, has the same dimension. If the fibre is reduced over the prime field, which is
/// perfect, then the discriminant of its trace form is not 0, hence neither is that of the generic fibre,
/// which is therefore reduced.
///
/// Returns the bound variables whose minimal polynomials on the fibre have multiple factors: if there are
/// none the ideal is radical (Seidenberg, as in radical()); if there are, nothing is proved, but these are to
/// be looked at first. nullopt if no fibre was good.
std::optional<Variables> suspects_of_multiplicity(const Ideal& J, const Variables& bound, base::Run& run);

} // namespace eliminant::ideal
