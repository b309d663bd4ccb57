/// \file
/// First roots of many univariate polynomials.
#pragma once

#include "eliminant/base/run.hpp"

#include <cstddef>
#include <span>

namespace eliminant::field {

/// Polynomials of one degree on [−1, 1], and where in it each is searched. Coefficient k of polynomial i is
/// coefficients[k·count + i]; any interval of a ray is brought to [−1, 1] by an affine map.
struct PolynomialBatch {
    std::size_t degree = 0;
    std::size_t count = 0;
    std::span<const double> coefficients = {}; ///< (degree + 1)·count
    std::span<const double> lower = {};        ///< within [−1, 1]
    std::span<const double> upper = {};        ///< within [−1, 1]; less than `lower` for an empty interval
};

/// The first root of each polynomial in its closed interval, +∞ where there is none; `lower` for the
/// polynomial 0. Certified: the coefficients are taken as exact numbers, and there is a root if and only if
/// one is reported. Its position is right to 1e-9.
///
/// In vector registers, with rounding errors bounded; polynomials that stay undecided, because roots are
/// double or nearly so or at an end of the interval, by more precise numbers and at last exactly
/// (first_real_root()). \throws DomainError if the lengths of the spans do not fit, a bound is outside [−1,
/// 1], or a number is not finite
void first_roots(const PolynomialBatch& batch, std::span<double> roots, base::Run& run);

} // namespace eliminant::field

namespace eliminant {
using field::first_roots;
using field::PolynomialBatch;
} // namespace eliminant
