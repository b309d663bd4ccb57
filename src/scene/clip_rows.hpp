#pragma once

#include "eliminant/scene/clip_region.hpp"

#include "base/vector_unit.hpp"

#include <cstddef>

namespace eliminant::scene {

/// A ClipRegion without its containers.
struct RegionParts {
    const Ball* balls = nullptr;
    std::size_t ball_count = 0;
    const HalfSpace* half_spaces = nullptr;
    std::size_t half_space_count = 0;

    static RegionParts of(const ClipRegion& region) {
        return {region.balls().data(), region.balls().size(), region.half_spaces().data(),
                region.half_spaces().size()};
    }
};

/// One row of rays against a clip region, several rays at once: as ClipRegion::interval() for each, in the
/// coordinate w of a BeamFrame.
struct ClipRow {
    static constexpr std::size_t padding = 8;

    Ray first;            ///< of the first column
    glm::dvec3 origin_dx; ///< from column to column
    glm::dvec3 direction_dx;
    RegionParts region = {};

    bool is_pencil = true; ///< w is affine in −1/t, else in t
    double middle_w = 0.0;
    double radius_w = 1.0;

    std::size_t count = 0;   ///< a multiple of `padding`
    double* lower = nullptr; ///< within [−1, 1]; lower > upper where the ray misses the region
    double* upper = nullptr;
};

/// Defined for each unit by clip_rows_per_unit.cpp, as clip_stars().
template <base::VectorUnit unit>
void clip_row(const ClipRow& row);

using RowClipper = void (*)(const ClipRow&);
inline RowClipper row_clipper(base::VectorUnit unit) {
    return base::with_unit(unit, [](auto u) -> RowClipper { return clip_row<u()>; });
}

/// The same for rays from some points, as many from each (field::StarRays), in the rays' parameter and up to
/// `reach`.
struct ClipStars {
    RegionParts region = {};
    double reach = 0.0;
    std::size_t count = 0;      ///< points, a multiple of ClipRow::padding
    std::size_t rays = 0;       ///< of each
    const double* origin[3];    ///< [point]
    const double* direction[3]; ///< [ray·count + point]; not 0
    double* lower = nullptr;    ///< so, too; lower > upper where the ray misses the region
    double* upper = nullptr;
};

template <base::VectorUnit unit>
void clip_stars(const ClipStars& stars);

using StarClipper = void (*)(const ClipStars&);
inline StarClipper star_clipper(base::VectorUnit unit) {
    return base::with_unit(unit, [](auto u) -> StarClipper { return clip_stars<u()>; });
}

} // namespace eliminant::scene
