#include "eliminant/render/camera.hpp"

#include "eliminant/base/error.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace eliminant::render {
namespace {

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The direction of `v` for the largest and the smallest numbers alike; `v` is finite and not 0.
glm::dvec3 direction_of(const glm::dvec3& v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return glm::normalize(v / largest);
}

[[noreturn]] void fail(const std::string& what) { throw DomainError("camera: " + what); }

} // namespace

Camera::Camera(const Viewpoint& viewpoint, bool is_perspective, double half_height)
    : origin_(viewpoint.origin), is_perspective_(is_perspective), half_height_(half_height) {
    if (!is_finite(viewpoint.origin) || !is_finite(viewpoint.look_at) || !is_finite(viewpoint.up))
        fail("expected finite coordinates, found one that is infinite or not a number");
    const glm::dvec3 sight = viewpoint.look_at - viewpoint.origin;
    if (!is_finite(sight)) fail("expected a line of sight of finite length, found an infinite one");
    if (sight == glm::dvec3(0)) fail("expected it to look at a point other than its origin");
    if (viewpoint.up == glm::dvec3(0)) fail("expected a direction as up, found the null vector");
    forward_ = direction_of(sight);
    const glm::dvec3 across = glm::cross(forward_, direction_of(viewpoint.up));
    // Rounding leaves about 1e-16 of an up that is parallel: nobody means the direction of that.
    constexpr double least_sine = 1e-12;
    if (glm::length(across) < least_sine) fail("expected an up that is not parallel to the line of sight");
    right_ = glm::normalize(across);
    up_ = glm::cross(right_, forward_);
}

Camera Camera::perspective(const Viewpoint& viewpoint, double vertical_degrees) {
    if (!(vertical_degrees > 0 && vertical_degrees < 180))
        fail("expected a field of view between 0 and 180 degrees, found " + std::to_string(vertical_degrees));
    return {viewpoint, true, std::tan(vertical_degrees * (std::numbers::pi / 360))};
}

Camera Camera::orthographic(const Viewpoint& viewpoint, double height) {
    if (!(height > 0 && std::isfinite(height)))
        fail("expected a positive height of what is seen, found " + std::to_string(height));
    return {viewpoint, false, height / 2};
}

scene::RayGrid Camera::rays(ImageSize size, std::uint32_t border) const {
    const double columns = size.width;
    const double rows = size.height;
    const double margin = border;
    const glm::dvec3 step_right = (2 * half_height_ / rows) * right_;
    const glm::dvec3 step_down = (-2 * half_height_ / rows) * up_;
    const glm::dvec3 first = (half_height_ * ((1 - columns - 2 * margin) / rows)) * right_ +
                             (half_height_ * ((rows - 1 + 2 * margin) / rows)) * up_;

    scene::RayGrid grid;
    grid.width = size.width + 2 * std::size_t{border};
    grid.height = size.height + 2 * std::size_t{border};
    grid.origin = origin_;
    grid.direction = forward_;
    (is_perspective_ ? grid.direction : grid.origin) += first;
    (is_perspective_ ? grid.direction_dx : grid.origin_dx) = step_right;
    (is_perspective_ ? grid.direction_dy : grid.origin_dy) = step_down;
    return grid;
}

scene::RayGrid Camera::rays(ImageSize size) const { return rays(size, 0); }

} // namespace eliminant::render
