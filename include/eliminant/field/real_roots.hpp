/// \file
/// Real roots of univariate polynomials on an interval, exactly.
#pragma once

#include "eliminant/base/run.hpp"

#include <gmpxx.h>

#include <optional>
#include <span>
#include <vector>

namespace eliminant::field {

/// A real root of a univariate polynomial p.
struct RealRoot {
    /// The nearest double; the other neighbour where the root is halfway between two to some twenty bits
    /// more.
    double value = 0.0;
    /// At least 1. Odd exactly if p changes its sign here.
    unsigned multiplicity = 1;
    /// Sign of p just before the root, −1 or 1.
    int sign_before = 0;
};

/// All distinct real roots of p = Σ coefficients[i]·t^i in the closed interval [lower, upper], ascending;
/// `upper` may be +∞. Whether there is a root, how many there are and their multiplicities are exact.
///
/// Squarefree decomposition, then bisection with Descartes' rule of signs (Collins and Akritas, SYMSAC 1976;
/// it ends by the theorem of two circles of Ostrowski and Krandick–Mehlhorn) in integers.
///
/// \throws DomainError if p = 0, or a bound is not a number, or `lower` is infinite
std::vector<RealRoot> real_roots(std::span<const mpz_class> coefficients, double lower, double upper,
                                 base::Run& run);

/// The first of them, without isolating those after it.
std::optional<RealRoot> first_real_root(std::span<const mpz_class> coefficients, double lower, double upper,
                                        base::Run& run);

} // namespace eliminant::field

namespace eliminant {
using field::first_real_root;
using field::real_roots;
using field::RealRoot;
} // namespace eliminant
