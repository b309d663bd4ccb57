/// \file
/// Which part of a parametrized surface its author has in mind.
#pragma once

#include "eliminant/base/run.hpp"
#include "eliminant/implicit/parametrization.hpp"
#include "eliminant/scene/clip_region.hpp"

#include <optional>

namespace eliminant::app {

/// What values parameters take that are no angles; angles run over the full circle.
enum class ParameterRange {
    unit,   ///< [0, 1], as those of a control net
    chosen, ///< the largest of [0, 1], [−1, 1] and the whole line that keeps the image from growing threefold
};

/// A ball around the image, with a margin. The implicit equation of a patch does not tell where the patch is:
/// that of a bicubic one has degree 18, and most of its zeros are far from the image of the unit square.
///
/// From samples of the parameters, each evaluated exactly. Where denominators change sign, samples far
/// outside of the ball that holds most of them are left out. A map with two coordinates lies in z = 0.
/// Nothing if the parameters have relations, are too many, or the image is a point. \throws Stopped
///
/// \param map of two or three coordinates, without constants
/// \param range of its parameters
/// \param run limits
std::optional<Ball> ball_around_image(const Parametrization& map, ParameterRange range, Run& run);

} // namespace eliminant::app
