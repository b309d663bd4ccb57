#pragma once

#include "random.hpp"

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <cstdint>
#include <vector>

namespace eliminant::algebra {

/// Upper bounds of the degrees of gcd(f, g), one a variable of the ring; f and g are not 0. Bounds are
/// proved, and with high probability they are the degrees. O(n·terms) and one univariate gcd a variable.
///
/// The image of a gcd h with values in the place of all variables but x divides the gcd of the images. If the
/// leading coefficient in x of f (or g) does not vanish in the image, nor does that of h, which divides it.
/// So the degree of the images' gcd bounds that of h. Over ℚ the images are taken modulo a prime, which
/// changes nothing in this, over a small field in a small extension. Where an image would cost as much as the
/// gcd itself, in one variable alone or at high degrees, the bound is the smaller degree.
std::vector<std::uint64_t> gcd_degree_bounds(const Polynomial& f, const Polynomial& g, Random& random,
                                             base::Run& run);

/// Whether images over that field, which is, contains, or over ℚ is modulo a prime, the field of
/// coefficients, prove that f and g are coprime. A negative answer proves nothing.
template <class Field>
bool proved_coprime(const Field& field, const Polynomial& f, const Polynomial& g, Random& random,
                    base::Run& run);

} // namespace eliminant::algebra
