/// \file
/// The dimension of an ideal, and variables that are independent modulo it.
#pragma once

#include "eliminant/ideal/ideal.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eliminant::ideal {

/// The Krull dimension of K[x₁, …, xₙ]/I: that of the variety of I over the algebraic closure, as an affine
/// variety also for homogeneous I. n for the zero ideal, −1 for the unit ideal, whose variety is empty.
///
/// It is the dimension of the leading ideal (Kredel and Weispfenning 1988; Cox, Little, O'Shea, §9.3), and of
/// a monomial ideal n minus the least number of variables that meet every generator: a minimum hitting set,
/// found by branch and bound; exponential in n at worst.
std::int64_t dimension(const Ideal& I, base::Run& run);

/// n − dimension(I); n + 1 for the unit ideal.
std::int64_t codimension(const Ideal& I, base::Run& run);

/// dimension(I) many variables, as ascending indices, such that I contains no nonzero polynomial in them
/// alone. \throws DomainError for the unit ideal, modulo which not even the empty set is independent
std::vector<std::size_t> maximal_independent_set(const Ideal& I, base::Run& run);

} // namespace eliminant::ideal

namespace eliminant {
using ideal::codimension;
using ideal::dimension;
using ideal::maximal_independent_set;
} // namespace eliminant
