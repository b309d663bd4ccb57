/// \file
/// Weighted degrees, homogeneous parts, homogenisation.
#pragma once

#include "eliminant/algebra/polynomial.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace eliminant::algebra {

// In all these functions `weights` has one non-negative entry a variable of the ring, or is empty, which
// means that all weights are 1. Another length is a DomainError, a weighted degree from 2^63 on an
// OverflowError. O(n·terms).

/// Largest weighted degree of a term; −1 for 0.
std::int64_t weighted_degree(const Polynomial& f, std::span<const std::uint64_t> weights = {});

/// Whether all terms have the same weighted degree (0 has).
bool is_homogeneous(const Polynomial& f, std::span<const std::uint64_t> weights);

/// The sum of the terms of one weighted degree.
Polynomial homogeneous_part(const Polynomial& f, std::uint64_t degree,
                            std::span<const std::uint64_t> weights = {});

/// The homogeneous part of the highest degree; 0 for 0.
Polynomial leading_form(const Polynomial& f, std::span<const std::uint64_t> weights = {});

/// Each term times the power of the variable that brings it to the weighted degree of f.
///
/// The variable is usually one that does not occur in f (Ring holds it already), but it may. Throws
/// DomainError if its weight is 0, or does not divide what a term lacks.
Polynomial homogenize(const Polynomial& f, std::size_t variable, std::span<const std::uint64_t> weights = {});

/// f with 1 in the place of the variable.
Polynomial dehomogenize(const Polynomial& f, std::size_t variable);

} // namespace eliminant::algebra

namespace eliminant {
using algebra::dehomogenize;
using algebra::homogeneous_part;
using algebra::homogenize;
using algebra::is_homogeneous;
using algebra::leading_form;
using algebra::weighted_degree;
} // namespace eliminant
