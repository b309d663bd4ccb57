#pragma once

#include "eliminant/algebra/polynomial.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// The positive weights by which the order of the ring compares first, if it does: such an order is called
/// graded.
std::optional<std::vector<std::uint64_t>> weights_compared_first(const algebra::Ring& ring);

/// The ring's own order if it is graded, else degrevlex: an order in which a basis is got cheaply.
algebra::MonomialOrder cheap_order(const algebra::Ring& ring);

/// Whether the polynomials are a Groebner basis because their leading monomials are pairwise coprime
/// (Buchberger's first criterion), as those of X_i − f_i(t) where X_i is large.
bool have_coprime_leads(std::span<const algebra::Polynomial> polynomials);

/// Whether a basis of the ideal of the generators, which are of `ring`, is better got by convert_basis() from
/// one in degrevlex than directly: if the order is not graded, unless they are homogeneous or a basis
/// already.
bool is_cheaper_by_graded_basis(const algebra::Ring& ring, std::span<const algebra::Polynomial> generators);

} // namespace eliminant::groebner
