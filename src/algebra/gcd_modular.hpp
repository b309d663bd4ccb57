#pragma once

#include "random.hpp"

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <cstdint>
#include <optional>
#include <span>

namespace eliminant::algebra {

/// How images are put together.
enum class Interpolation { automatic, dense, sparse };

/// gcd of normalised polynomials in the same variables, by images over finite fields; proved by division.
///
/// `bounds` are upper bounds of the degrees of the gcd, positive for each variable that occurs. Nothing if
/// degrees are too high for dense univariate images or the field offers too few points; another method has to
/// do then.
std::optional<Polynomial> gcd_by_images(const Polynomial& f, const Polynomial& g,
                                        std::span<const std::uint64_t> bounds, Random& random, base::Run& run,
                                        Interpolation method = Interpolation::automatic);

} // namespace eliminant::algebra
