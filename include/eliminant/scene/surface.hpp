/// \file
/// What a renderer may ask of a surface.
#pragma once

#include "eliminant/scene/clip_region.hpp"
#include "eliminant/scene/ray.hpp"

#include "eliminant/base/run.hpp"
#include "eliminant/field/distance.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace eliminant::scene {

/// How a ray meets a surface.
enum class HitKind : unsigned char {
    miss,
    crossing,  ///< The sign changes here.
    tangency,  ///< It does not: the ray touches, or meets a part of lower dimension.
    contained, ///< The ray lies within the surface; t is the start of the interval.
};

/// The arithmetic in which a hit was decided, cheapest first. It says what an answer cost, not how sure it
/// is: all are certain.
enum class Decision : unsigned char {
    region, ///< A whole box of rays at once, or an empty interval.
    vector, ///< Several rays at once, in doubles.
    wide,   ///< Floating point of more than 53 bits.
    exact,  ///< Integers of any size.
};

/// A point where a ray meets a surface.
struct Hit {
    double t = std::numeric_limits<double>::infinity(); ///< Ray parameter; +∞ for a miss.
    /// Gradient of the defining function at the hit, not normalised: it points where the function grows. Zero
    /// at singular points and for a miss.
    glm::dvec3 gradient{0.0};
    HitKind kind = HitKind::miss;
    /// Sign of the defining function on the ray just before the hit, or throughout when it missed; 0 where it
    /// is not known or not defined (an empty interval, a ray within the surface).
    std::int8_t side = 0;
    Decision decision = Decision::region;
    std::uint8_t steps = 0; ///< Subdivisions and refinements it took, at most 255.

    explicit operator bool() const { return kind != HitKind::miss; }
};

/// Principal curvatures of the level set through a point, for the unit normal ∇f/‖∇f‖: a sphere of radius r
/// whose function grows outward has both 1/r.
struct Curvature {
    double mean = 0.0;
    double gaussian = 0.0;
    double minimum = 0.0;
    double maximum = 0.0;
};

/// First hits of the rays of one grid within one clip region: the state that a picture prepares once.
/// Immutable, so that many threads may trace tiles at the same time.
class GridTracer {
  public:
    GridTracer() = default;
    GridTracer(const GridTracer&) = delete;
    GridTracer& operator=(const GridTracer&) = delete;
    virtual ~GridTracer() = default;

    /// The first hit of each ray of the tile, row by row: hits[(r − tile.row)·tile.width + (c −
    /// tile.column)]. The answers do not depend on how a picture is cut into tiles; tiles of 32 to 128 pixels
    /// a side are fastest. \throws DomainError if the tile does not lie in the grid or hits.size() ≠
    /// tile.size()
    virtual void trace(const Tile& tile, std::span<Hit> hits, base::Run& run) const = 0;
};

/// The zero set of a function of space, as a renderer sees it. Immutable; every query may be asked from many
/// threads at once.
///
/// A ray hits the surface exactly if the function has a zero on the closed interval. Rays are taken as given:
/// their doubles are exact numbers. \throws DomainError from every query whose ray, point or interval holds
/// NaN, or whose ray has an infinite member or direction 0.
class Surface {
  public:
    Surface() = default;
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;
    virtual ~Surface() = default;

    /// Prepares the first hits of all rays of a grid within a bounded clip region. The surface must outlive
    /// the tracer. \throws DomainError if a ray of the grid has direction 0, or the region is unbounded
    virtual std::unique_ptr<GridTracer> tracer(const RayGrid& rays, const ClipRegion& clip,
                                               base::Run& run) const = 0;

    /// The first hit with t in the closed interval.
    virtual Hit first_hit(const Ray& ray, Interval interval, base::Run& run) const = 0;
    /// Every hit with t in the closed interval, ascending; one `contained` hit if the ray lies in the
    /// surface.
    virtual std::vector<Hit> all_hits(const Ray& ray, Interval interval, base::Run& run) const = 0;
    /// Whether there is any hit in the closed interval: for shadows.
    virtual bool occluded(const Ray& ray, Interval interval, base::Run& run) const;
    /// The same for many rays, each between its origin and t = reach as far as it lies in the region:
    /// answers[k], 1 or 0, is that of ray k. Several rays from each point, and neighbouring points, are
    /// fastest. \throws DomainError if the lengths do not fit, or `reach` is negative or NaN
    virtual void occluded(const RayStars& rays, const ClipRegion& clip, double reach,
                          std::span<std::uint8_t> answers, base::Run& run) const;

    /// Sign of the function: −1, 0 or +1, exact.
    virtual int sign(glm::dvec3 point) const = 0;
    /// Value of the function, to about double precision.
    virtual double value(glm::dvec3 point) const = 0;
    /// Gradient of the function, to about double precision.
    virtual glm::dvec3 gradient(glm::dvec3 point) const = 0;
    /// Distance to the surface at one of the levels of field::DistanceLevel: an estimate at `first_order` and
    /// `second_order`, never more than the distance at `guaranteed`. At least 0.
    virtual double distance(glm::dvec3 point, field::DistanceLevel level) const = 0;
    /// The same for many points. \throws DomainError if the two lengths differ
    virtual void distances(std::span<const glm::dvec3> points, field::DistanceLevel level,
                           std::span<double> results) const;
    /// Curvatures of the level set; all zero where the gradient vanishes.
    virtual Curvature curvature(glm::dvec3 point) const = 0;

    /// A ball outside of which nothing needs to be drawn to see the surface, for a camera that has to be
    /// placed without being told where: it contains the surface if that is bounded and small, and is a
    /// sensible part of it otherwise.
    virtual Ball framing_ball(base::Run& run) const = 0;
};

} // namespace eliminant::scene

namespace eliminant {
using scene::Curvature;
using scene::Decision;
using scene::GridTracer;
using scene::Hit;
using scene::HitKind;
using scene::Surface;
} // namespace eliminant
