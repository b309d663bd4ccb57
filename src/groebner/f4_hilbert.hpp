// F4 that knows how many leading monomials there are.
#pragma once

#include "eliminant/groebner/buchberger.hpp"
#include "groebner/monomial_ideal.hpp"

#include <span>

namespace eliminant::groebner {

/// f4() for homogeneous generators of an ideal whose Hilbert series is N(t)/(1 − t)ⁿ, as that of an ideal is
/// known as soon as it has a basis in any order. Pairs that must reduce to zero, which are most of them where
/// a basis in degrevlex is converted to lex, are not reduced: see F4Computation.
///
/// \param hilbert_numerator N; null if unknown
GroebnerBasis f4_with_hilbert_series(const algebra::Ring& ring,
                                     std::span<const algebra::Polynomial> generators,
                                     const BuchbergerOptions& options, const SparseSeries* hilbert_numerator,
                                     base::Run& run);

} // namespace eliminant::groebner
