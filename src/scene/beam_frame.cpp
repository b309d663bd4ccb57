#include "scene/beam_frame.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace eliminant::scene {
namespace {

/// `pixels` rounded up, so that every block of pixels lies within the frame.
std::size_t whole_blocks(std::size_t pixels) {
    return (pixels + BeamFrame::block_size - 1) / BeamFrame::block_size * BeamFrame::block_size;
}

/// The smallest power of two that is at least `size`/2, so that pixels have exact coordinates.
double half_extent(std::size_t size) {
    double half = 0.5;
    while (2.0 * half < static_cast<double>(size)) half *= 2.0;
    return half;
}

mpq_class centered(std::size_t pixel, double middle, double half) {
    return (mpq_class(static_cast<unsigned long>(pixel)) - mpq_class(middle)) / mpq_class(half);
}

} // namespace

std::optional<BeamFrame> BeamFrame::make(const RayGrid& rays, const Ball& ball, double free_radius) {
    const bool parallel = rays.direction_dx == glm::dvec3(0.0) && rays.direction_dy == glm::dvec3(0.0);
    const bool pencil = rays.origin_dx == glm::dvec3(0.0) && rays.origin_dy == glm::dvec3(0.0);
    if (parallel == pencil) return std::nullopt;
    BeamFrame frame;
    frame.is_pencil_ = pencil;
    const std::size_t width = whole_blocks(rays.width);
    const std::size_t height = whole_blocks(rays.height);
    frame.middle_column_ = 0.5 * static_cast<double>(width - 1);
    frame.middle_row_ = 0.5 * static_cast<double>(height - 1);
    frame.half_width_ = half_extent(width);
    frame.half_height_ = half_extent(height);
    const glm::dvec3 along_u = frame.half_width_ * (pencil ? rays.direction_dx : rays.origin_dx);
    const glm::dvec3 along_v = frame.half_height_ * (pencil ? rays.direction_dy : rays.origin_dy);
    const glm::dvec3 center = rays.ray(frame.middle_column_, frame.middle_row_).direction;
    const double determinant = glm::dot(center, glm::cross(along_u, along_v));
    if (!(std::abs(determinant) > 1e-12 * glm::length(center) * glm::length(along_u) * glm::length(along_v)))
        return std::nullopt;
    const double orientation = determinant > 0.0 ? 1.0 : -1.0;
    frame.u_cross_v_ = orientation * glm::cross(along_u, along_v);
    frame.v_cross_center_ = orientation * glm::cross(along_v, center);
    frame.center_cross_u_ = orientation * glm::cross(center, along_u);

    const std::optional<Interval> range = frame.depth_range(rays, ball, center, free_radius);
    if (!range) return std::nullopt;
    const double first = pencil ? -1.0 / range->lower : range->lower;
    const double last = pencil ? -1.0 / range->upper : range->upper;
    frame.middle_w_ = 0.5 * (first + last);
    frame.radius_w_ = 0.5 * (last - first) * (1.0 + 0x1p-20); // room for all that was rounded here
    // The whole range stays on one side of the point at infinity.
    if (pencil && frame.middle_w_ + frame.radius_w_ >= 0.0) return std::nullopt;
    if (!std::isfinite(frame.middle_w_) || !(frame.radius_w_ > 0.0)) return std::nullopt;
    frame.make_forms(rays);
    return frame;
}

/// Where the rays can be in the ball, at t > 0.
std::optional<Interval> BeamFrame::depth_range(const RayGrid& rays, const Ball& ball, glm::dvec3 center,
                                               double free_radius) const {
    const std::array<Ray, 4> corners{
        rays.ray(0.0, 0.0), rays.ray(static_cast<double>(rays.width - 1), 0.0),
        rays.ray(0.0, static_cast<double>(rays.height - 1)),
        rays.ray(static_cast<double>(rays.width - 1), static_cast<double>(rays.height - 1))};
    if (!is_pencil_) {
        // The parameter of the point next to the center is affine in the pixel: extreme at corners.
        Interval range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
        const double squared = glm::dot(center, center);
        const double reach = ball.radius / std::sqrt(squared);
        for (const Ray& ray : corners) {
            const double nearest = glm::dot(ball.center - ray.origin, ray.direction) / squared;
            range.lower = std::min(range.lower, nearest - reach);
            range.upper = std::max(range.upper, nearest + reach);
        }
        range.lower = std::max(range.lower, 0.0);
        return range.empty() ? std::nullopt : std::optional(range);
    }
    // The parameter of a point is its distance from the origin over the length of the direction, and also its
    // height above the plane of the origin over that of the direction, which all rays share.
    double longest = 0.0;
    for (const Ray& ray : corners) longest = std::max(longest, glm::length(ray.direction));
    const glm::dvec3 to_center = ball.center - rays.origin;
    const double distance = glm::length(to_center);
    const glm::dvec3 normal = glm::normalize(u_cross_v_);
    const double height = glm::dot(center, normal); // least length of a direction
    const double center_height = glm::dot(to_center, normal);
    const double upper = std::min((distance + ball.radius) / height, (center_height + ball.radius) / height);
    const double lower = std::max({(distance - ball.radius) / longest, (center_height - ball.radius) / height,
                                   std::min(free_radius / longest, upper) * (1.0 - 0x1p-40)});
    // From a thousandth of the range on, what is near the origin would take up nearly all of −1/t.
    if (!(lower > 0x1p-10 * upper)) return std::nullopt;
    return Interval{lower, upper};
}

void BeamFrame::make_forms(const RayGrid& rays) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto exact = [axis](const glm::dvec3& value) { return mpq_class(value[axis]); };
        const mpq_class middle_column(middle_column_);
        const mpq_class middle_row(middle_row_);
        const mpq_class origin =
            exact(rays.origin) + middle_column * exact(rays.origin_dx) + middle_row * exact(rays.origin_dy);
        const mpq_class direction = exact(rays.direction) + middle_column * exact(rays.direction_dx) +
                                    middle_row * exact(rays.direction_dy);
        const mpq_class du = mpq_class(half_width_) * exact(is_pencil_ ? rays.direction_dx : rays.origin_dx);
        const mpq_class dv = mpq_class(half_height_) * exact(is_pencil_ ? rays.direction_dy : rays.origin_dy);
        const mpq_class middle(middle_w_);
        const mpq_class radius(radius_w_);
        auto& form = forms_[static_cast<std::size_t>(axis)];
        if (is_pencil_)
            form = {direction - middle * origin, du, dv, -radius * origin};
        else
            form = {origin + middle * direction, du, dv, radius * direction};
    }
    if (is_pencil_)
        forms_[3] = {-mpq_class(middle_w_), 0, 0, -mpq_class(radius_w_)};
    else
        forms_[3] = {1, 0, 0, 0};
}

mpq_class BeamFrame::exact_u(std::size_t column) const {
    return centered(column, middle_column_, half_width_);
}
mpq_class BeamFrame::exact_v(std::size_t row) const { return centered(row, middle_row_, half_height_); }

} // namespace eliminant::scene
