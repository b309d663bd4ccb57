#pragma once

#include "eliminant/groebner/buchberger.hpp"

#include <span>

namespace eliminant::groebner {

/// The reduced Groebner basis over GF(p) by F4 (Faugère, J. Pure Appl. Algebra 139 (1999)): the pairs of one
/// degree are reduced together, as rows of a sparse matrix whose other rows are all the multiples of basis
/// elements that they may need. Options, result and errors are those of buchberger(), and so is the basis; of
/// the statistics, reduction steps stay 0. Selection normal (all pairs whose lcm has the least degree) suits
/// it better than sugar: reimer-6 takes 0.03 s against 1.2 s. Throws DomainError over ℚ.
GroebnerBasis f4(const algebra::Ring& ring, std::span<const algebra::Polynomial> generators,
                 const BuchbergerOptions& options, base::Run& run);

} // namespace eliminant::groebner

namespace eliminant {
using groebner::f4;
} // namespace eliminant
