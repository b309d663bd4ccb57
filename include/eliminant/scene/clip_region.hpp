/// \file
/// The part of space that is drawn.
#pragma once

#include "eliminant/scene/ray.hpp"

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace eliminant::scene {

/// A closed ball.
struct Ball {
    glm::dvec3 center{0.0};
    double radius = 1.0;
};

/// A closed box with sides along the axes.
struct Box {
    glm::dvec3 lower{-1.0};
    glm::dvec3 upper{1.0};
};

/// The points with dot(normal, p) ≤ offset.
struct HalfSpace {
    glm::dvec3 normal{0.0, 0.0, 1.0};
    double offset = 0.0;
};

/// An intersection of balls, boxes and half-spaces: convex and closed, all of space when nothing was added.
///
/// A surface is not capped where it is clipped: a ray that enters the region inside the solid has not hit
/// anything yet.
class ClipRegion {
  public:
    ClipRegion() = default;

    /// \throws DomainError unless center and radius are finite and radius ≥ 0
    ClipRegion& add(const Ball& ball);
    /// \throws DomainError unless all bounds are finite and lower ≤ upper
    ClipRegion& add(const Box& box);
    /// \throws DomainError unless normal and offset are finite and the normal is not 0
    ClipRegion& add(const HalfSpace& half_space);

    /// The t ≥ 0 of the ray within the region, rounded outward: it contains the exact interval and exceeds it
    /// by a few units in the last place of the quantities involved, so a surface that touches the region's
    /// boundary from within is kept. Empty when the ray misses the region; where it grazes a ball within
    /// rounding the interval may be a short one instead. The upper end is +∞ where the region is unbounded
    /// along the ray. \throws DomainError unless the ray is finite and its direction is not 0
    Interval interval(const Ray& ray) const;

    bool contains(glm::dvec3 point) const;

    /// A ball around the region, if it is bounded: one of the balls or boxes that make it.
    std::optional<Ball> bounding_ball() const;

    const std::vector<Ball>& balls() const { return balls_; }
    const std::vector<HalfSpace>& half_spaces() const { return half_spaces_; } ///< Those of boxes included.

  private:
    std::vector<Ball> balls_;
    std::vector<HalfSpace> half_spaces_;
    std::vector<Box> boxes_;
};

} // namespace eliminant::scene

namespace eliminant {
using scene::Ball;
using scene::Box;
using scene::ClipRegion;
using scene::HalfSpace;
} // namespace eliminant
