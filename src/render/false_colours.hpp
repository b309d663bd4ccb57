/// \file
/// Numbers as colours. All results are linear.
#pragma once

#include "eliminant/render/image.hpp"

#include <glm/vec3.hpp>

namespace eliminant::render {

/// A unit vector: x, y and z from [−1, 1] to red, green and blue as they are stored.
Colour normal_colour(const glm::dvec3& normal);

/// White at 0, black at 1.
Colour depth_colour(double relative_depth);

/// From dark blue at 0 over green and yellow to red at 1.
Colour heat_colour(double value);

/// White at 0; towards red for positive, towards blue for negative numbers, half-way at ±5, as
/// x / (|x| + 5): curvatures have no largest value.
Colour signed_colour(double value);

} // namespace eliminant::render
