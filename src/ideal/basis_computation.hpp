// How an ideal gets a Groebner basis in an order that does not compare degrees first.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <optional>
#include <span>
#include <vector>

namespace eliminant::ideal {

/// The positive weights by which the order of the ring compares first, if it does: such an order is called
/// graded.
std::optional<std::vector<std::uint64_t>> weights_compared_first(const algebra::Ring& ring);

/// The ring's own order if it is graded, else degrevlex: an order in which a basis is got cheaply.
algebra::MonomialOrder cheap_order(const algebra::Ring& ring);

/// The reduced Groebner basis in the order of `target` of the ideal of the generators, which are of the same
/// ring in any order, by Buchberger's algorithm as it stands.
std::vector<algebra::Polynomial>
basis_directly(const algebra::Ring& target, std::span<const algebra::Polynomial> generators, base::Run& run);

/// The same from a Groebner basis in degrevlex or deglex.
///
/// In an order that does not compare degrees, Buchberger's algorithm runs into elements of large degree
/// before it has the small ones; the sugar of inhomogeneous polynomials mends that only in part. Homogenised
/// by a variable h, the elements of a basis in a graded order generate the whole homogenised ideal; its basis
/// is computed degree by degree, in the order continued to h as the last resort, and is a basis of the ideal
/// for h = 1 (Becker and Weispfenning, Gröbner Bases, §10.3; for lm(f)|_{h=1} = lm(f|_{h=1}) see there). On
/// the elimination of 3 variables from cyclic-6 over GF(p) 0.01 s instead of 9.3 s.
std::vector<algebra::Polynomial> basis_by_homogenization(const algebra::Ring& target,
                                                         std::span<const algebra::Polynomial> graded_basis,
                                                         base::Run& run);

} // namespace eliminant::ideal
