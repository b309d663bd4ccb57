/// \file
/// Rays, and the grids of rays that pictures are made of.
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>

namespace eliminant::scene {

/// The points origin + t·direction. The direction need not be of unit length; t counts in its lengths.
struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};

    glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// A closed interval of ray parameters; empty when lower > upper.
struct Interval {
    double lower = 0.0;
    double upper = -1.0;

    bool empty() const { return !(lower <= upper); }
    bool contains(double t) const { return lower <= t && t <= upper; }
};

/// As many rays from each of some points: ray j of point i starts at origins[i] and goes along
/// directions[j · origins.size() + i].
struct RayStars {
    std::span<const glm::dvec3> origins = {};
    std::span<const glm::dvec3> directions = {}; ///< a multiple of the number of origins

    Ray ray(std::size_t index) const { return {origins[index % origins.size()], directions[index]}; }
};

/// width × height rays; that of column c and row r starts at origin + c·origin_dx + r·origin_dy and goes
/// along direction + c·direction_dx + r·direction_dy.
///
/// Perspective cameras have zero origin steps, orthographic ones zero direction steps; any other combination
/// is allowed. The members are doubles, but the rays are the exact sums: what is certified about pixel (c, r)
/// is certified for that ray, without the rounding that ray() cannot avoid. Only grids that are of neither
/// kind, degrees above 56, and degrees above 12 with few terms are traced ray by ray, as ray() rounds them.
struct RayGrid {
    std::size_t width = 1;
    std::size_t height = 1;
    glm::dvec3 origin{0.0};
    glm::dvec3 origin_dx{0.0};
    glm::dvec3 origin_dy{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};
    glm::dvec3 direction_dx{0.0};
    glm::dvec3 direction_dy{0.0};

    /// The ray at real coordinates, so that pixels can be subdivided; rounded to doubles.
    Ray ray(double column, double row) const {
        return {origin + column * origin_dx + row * origin_dy,
                direction + column * direction_dx + row * direction_dy};
    }
};

/// The pixels [column, column + width) × [row, row + height) of a grid.
struct Tile {
    std::size_t column = 0;
    std::size_t row = 0;
    std::size_t width = 0;
    std::size_t height = 0;

    std::size_t size() const { return width * height; }
};

} // namespace eliminant::scene

namespace eliminant {
using scene::Interval;
using scene::Ray;
using scene::RayGrid;
using scene::RayStars;
using scene::Tile;
} // namespace eliminant
