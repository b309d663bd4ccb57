// Rings with a variable more, with some variables fewer, or with their variables in another sequence, and the
// maps of exponents into them.
#pragma once

#include "algebra/fresh_name.hpp"
#include "eliminant/algebra/polynomial.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace eliminant::ideal {

using algebra::fresh_name;

/// K[x_i : i ∈ kept], kept in the sequence given, in the restriction of the ring's order. Where `kept` is not
/// ascending, an order that depends on the sequence of the variables (lex, degrevlex) follows the new one.
algebra::Ring subring(const algebra::Ring& ring, std::span<const std::size_t> kept);

/// The map of indices that takes the ring to subring(ring, kept).
std::vector<std::size_t> map_to_subring(const algebra::Ring& ring, std::span<const std::size_t> kept);

/// All polynomials in ring `target`, variables matched by name.
std::vector<algebra::Polynomial> in_ring(std::span<const algebra::Polynomial> polynomials,
                                         const algebra::Ring& target);

/// The variables, as polynomials.
std::vector<algebra::Polynomial> variables_of(const algebra::Ring& ring);

} // namespace eliminant::ideal
