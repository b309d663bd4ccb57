#include "render/false_colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace eliminant::render {
namespace {

/// Three values as they are stored, in [0, 1].
using Encoded = std::array<double, 3>;

Colour linear(const Encoded& encoded) {
    Colour colour{};
    for (std::size_t i = 0; i < 3; ++i) colour[i] = static_cast<float>(linear_from_srgb(encoded[i]));
    return colour;
}

/// NaN becomes 0.
double clamped(double x) { return x > 0 ? std::min(x, 1.0) : 0; }

/// Equidistant colours, joined by straight lines; `where` in [0, 1].
template <std::size_t N>
Colour on_scale(const std::array<Encoded, N>& scale, double where) {
    const double position = where * (N - 1);
    const std::size_t before = std::min(static_cast<std::size_t>(position), N - 2);
    const double part = position - static_cast<double>(before);
    Encoded mixed{};
    for (std::size_t i = 0; i < 3; ++i)
        mixed[i] = (1 - part) * scale[before][i] + part * scale[before + 1][i];
    return linear(mixed);
}

} // namespace

Colour normal_colour(const glm::dvec3& normal) {
    return linear({clamped((normal.x + 1) / 2), clamped((normal.y + 1) / 2), clamped((normal.z + 1) / 2)});
}

Colour depth_colour(double relative_depth) {
    const double grey = 1 - clamped(relative_depth);
    return linear({grey, grey, grey});
}

Colour heat_colour(double value) {
    static constexpr std::array<Encoded, 5> scale{
        {{0.05, 0.05, 0.35}, {0.05, 0.45, 0.75}, {0.30, 0.75, 0.35}, {0.98, 0.85, 0.20}, {0.80, 0.10, 0.10}}};
    return on_scale(scale, clamped(value));
}

Colour signed_colour(double value) {
    static constexpr std::array<Encoded, 5> scale{
        {{0.05, 0.19, 0.45}, {0.26, 0.57, 0.85}, {0.97, 0.97, 0.97}, {0.95, 0.55, 0.35}, {0.55, 0.04, 0.10}}};
    constexpr double half_way = 5;
    if (std::isinf(value)) return on_scale(scale, value > 0 ? 1 : 0);
    return on_scale(scale, clamped((1 + value / (std::abs(value) + half_way)) / 2));
}

} // namespace eliminant::render
