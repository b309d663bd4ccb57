// Rational functions from their values.
#pragma once

#include "algebra/univariate_mod_p.hpp"
#include "eliminant/base/run.hpp"

#include <optional>
#include <span>

namespace eliminant::implicit {

/// n/d over GF(p), coprime, d monic.
struct RationalInterpolant {
    algebra::dense::Vector numerator;
    algebra::dense::Vector denominator;
};

/// The rational function of least deg n + deg d with these values at distinct points, among the rows of the
/// Euclidean scheme of ∏(z − zᵢ) and the interpolating polynomial (von zur Gathen and Gerhard, Modern
/// Computer Algebra, §5.8), if it takes fewer coefficients than there are points, by `redundancy` at least:
/// values of no such function pass once in p^redundancy times. O(points²).
std::optional<RationalInterpolant> rational_interpolant(const algebra::PrimeField& field,
                                                        std::span<const algebra::dense::Element> points,
                                                        std::span<const algebra::dense::Element> values,
                                                        std::size_t redundancy, base::Run& run);

} // namespace eliminant::implicit
