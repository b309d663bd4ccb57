/// \file
/// What values a polynomial takes on a region, and of which sign they are for certain.
#pragma once

#include "eliminant/field/distance.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <string_view>

namespace eliminant::field {

/// An interval that contains all values of f·2^−scale_exponent() on a region, rounding included; (−∞, ∞)
/// where nothing is known.
struct Range {
    double lower = 0;
    double upper = 0;
};

/// How values on a box are bounded.
enum class RangeForm : std::uint8_t {
    /// Horner's scheme in interval arithmetic. Overestimates most, O(terms).
    horner,
    /// The expansion at the center, term by term: overestimates by O(h²) for a box of size h (Moore, Kearfott
    /// and Cloud 2009, §6.4). About the cost of a guaranteed distance.
    taylor,
    /// The least and greatest coefficient in Bernstein's basis of the box, which are values of f at corners
    /// or
    /// as near to such as O(h²) (Garloff 1986): exact for polynomials that are linear or monotone enough.
    /// O(degree) operations for each of (deg_x + 1)(deg_y + 1)(deg_z + 1) coefficients.
    bernstein,
    /// The intersection of `taylor` and, where it takes at most 4096 coefficients and the former has not
    /// already excluded 0, of `bernstein`.
    automatic,
};

/// `horner`, `taylor`, `bernstein`, `automatic`.
std::string_view to_string(RangeForm form);

/// \throws DomainError unless the box is finite with lower ≤ upper
Range range(const DistanceField& field, const Box& box, RangeForm form = RangeForm::automatic);

/// What is known of the sign of f on a whole region.
enum class CertainSign : std::int8_t {
    negative = -1, ///< f < 0 everywhere in it
    unknown = 0,   ///< f may have zeros there
    positive = 1,  ///< f > 0 everywhere in it
};

/// By the range of f, then by the guaranteed distance of the center, which escalates precision near the
/// surface. \throws DomainError unless the box is finite with lower ≤ upper
CertainSign sign_on_box(const DistanceField& field, const Box& box);

/// By the guaranteed distance of the center. \throws DomainError if the radius is negative or NaN
CertainSign sign_on_ball(const DistanceField& field, const glm::dvec3& center, double radius);

} // namespace eliminant::field

namespace eliminant {
using field::CertainSign;
using field::range;
using field::Range;
using field::RangeForm;
using field::sign_on_ball;
using field::sign_on_box;
} // namespace eliminant
