#include "eliminant/scene/clip_region.hpp"

#include "scene/finite.hpp"

#include "eliminant/base/error.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace eliminant::scene {
namespace {

constexpr double slack = 0x1p-48; // relative; the roundings below stay under a few 2^-52

/// Sum of |a_i·b_i|: what the rounding of dot(a, b) is relative to.
double absolute_dot(glm::dvec3 a, glm::dvec3 b) { return glm::dot(glm::abs(a), glm::abs(b)); }

void intersect(Interval& interval, double lower, double upper) {
    interval.lower = std::max(interval.lower, lower);
    interval.upper = std::min(interval.upper, upper);
}

void intersect(Interval& interval, const Ball& ball, const Ray& ray) {
    // From the point of the ray next to the center: no cancellation between large squares.
    const glm::dvec3 from_center = ray.origin - ball.center;
    const double squared_length = glm::dot(ray.direction, ray.direction);
    const double nearest = -glm::dot(from_center, ray.direction) / squared_length;
    const glm::dvec3 offset = from_center + nearest * ray.direction;
    const double scale = glm::length(glm::abs(ray.origin) + glm::abs(ball.center)) + ball.radius;
    const double radius = ball.radius + slack * scale;
    const double squared = radius * radius - glm::dot(offset, offset);
    if (squared < 0.0) return intersect(interval, 1.0, 0.0);
    const double length = std::sqrt(squared_length);
    const double reach = std::sqrt(squared) / length + slack * scale / length;
    intersect(interval, nearest - reach, nearest + reach);
}

void intersect(Interval& interval, const HalfSpace& half_space, const Ray& ray) {
    const double slope = glm::dot(half_space.normal, ray.direction);
    const double room = half_space.offset - glm::dot(half_space.normal, ray.origin);
    const double margin = slack * (std::abs(half_space.offset) + absolute_dot(half_space.normal, ray.origin));
    if (std::abs(slope) <= 0x1p-51 * absolute_dot(half_space.normal, ray.direction)) {
        if (room + margin < 0.0) intersect(interval, 1.0, 0.0);
        return;
    }
    const double end = room / slope;
    const double reach = margin / std::abs(slope) + slack * std::abs(end);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (slope > 0.0)
        intersect(interval, -infinity, end + reach);
    else
        intersect(interval, end - reach, infinity);
}

} // namespace

ClipRegion& ClipRegion::add(const Ball& ball) {
    if (!is_finite(ball.center) || !std::isfinite(ball.radius) || ball.radius < 0.0)
        throw base::DomainError(
            "clip region: a ball needs a finite center and a finite radius of at least 0");
    balls_.push_back(ball);
    return *this;
}

ClipRegion& ClipRegion::add(const Box& box) {
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(box.lower[axis]) || !std::isfinite(box.upper[axis]) ||
            box.lower[axis] > box.upper[axis])
            throw base::DomainError("clip region: a box needs finite bounds, the lower ones first");
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 normal(0.0);
        normal[axis] = 1.0;
        half_spaces_.push_back({normal, box.upper[axis]});
        half_spaces_.push_back({-normal, -box.lower[axis]});
    }
    boxes_.push_back(box);
    return *this;
}

ClipRegion& ClipRegion::add(const HalfSpace& half_space) {
    if (!is_finite(half_space.normal) || !std::isfinite(half_space.offset) ||
        half_space.normal == glm::dvec3(0.0))
        throw base::DomainError(
            "clip region: a half-space needs a finite normal other than 0, and a finite offset");
    half_spaces_.push_back(half_space);
    return *this;
}

Interval ClipRegion::interval(const Ray& ray) const {
    require_ray(ray);
    Interval result{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (const Ball& ball : balls_) intersect(result, ball, ray);
    for (const HalfSpace& half_space : half_spaces_) intersect(result, half_space, ray);
    result.lower = std::max(result.lower, 0.0);
    return result;
}

bool ClipRegion::contains(glm::dvec3 point) const {
    return std::ranges::all_of(
               balls_, [&](const Ball& ball) { return glm::distance(point, ball.center) <= ball.radius; }) &&
           std::ranges::all_of(half_spaces_, [&](const HalfSpace& half_space) {
               return glm::dot(half_space.normal, point) <= half_space.offset;
           });
}

std::optional<Ball> ClipRegion::bounding_ball() const {
    std::optional<Ball> best;
    const auto consider = [&best](const Ball& ball) {
        if (!best || ball.radius < best->radius) best = ball;
    };
    for (const Ball& ball : balls_) consider(ball);
    for (const Box& box : boxes_) {
        const glm::dvec3 half = 0.5 * box.upper - 0.5 * box.lower;
        consider({box.lower + half, glm::length(half) * (1.0 + slack)});
    }
    return best;
}

} // namespace eliminant::scene
