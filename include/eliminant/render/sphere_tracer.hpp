/// \file
/// Sphere tracing: rays that advance by the distance to the surface.
#pragma once

#include "eliminant/scene/clip_region.hpp"
#include "eliminant/scene/ray.hpp"
#include "eliminant/scene/surface.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

namespace eliminant::render {

/// How a sphere tracer steps.
struct SphereTracing {
    /// The distance that it steps by. With field::DistanceLevel::guaranteed the answers are those of exact
    /// root isolation; the estimates can step through a surface.
    field::DistanceLevel level;
    /// How many times the distance it tries to step, in [1, 2).
    double over_relaxation = 1.6;
    /// After so many steps of a ray, the rest of it is decided by root isolation.
    std::uint32_t most_steps = 256;
};

/// What became of the rays, for all tiles so far.
struct SphereStatistics {
    std::uint64_t rays = 0;       ///< that met the clip region
    std::uint64_t steps = 0;      ///< distances asked for
    std::uint64_t back_steps = 0; ///< over-relaxed steps that had to be taken back
    std::uint64_t left = 0;       ///< rays that left the region without coming near the surface
    std::uint64_t came_near = 0;  ///< rays that came as near as half a pixel, and were handed over
    std::uint64_t ran_out = 0;    ///< rays handed over because of `most_steps`
};

/// Hart's sphere tracing (The Visual Computer 12, 1996) with the over-relaxation of Keinert, Schäfer,
/// Korndörfer, Ganse and Stamminger (Enhanced Sphere Tracing, STAG 2014) and a certified end.
///
/// The ball around a point whose radius is the distance there is free of the surface. A ray steps by ω times
/// the radius; if the ball at the new point does not reach the last one, something may lie between, and the
/// ray goes back to the edge of the last ball and on with ω = 1. Once a ball is smaller than half a pixel, or
/// after `most_steps`, the surface decides with Surface::first_hit what the rest of the ray meets: a small
/// ball never counts as a hit by itself.
class SphereTracer : public scene::GridTracer {
  public:
    /// Surface and region must outlive it.
    /// \throws DomainError if the over-relaxation is not in [1, 2) or the region is unbounded
    SphereTracer(const scene::Surface& surface, const scene::RayGrid& rays, const scene::ClipRegion& clip,
                 const SphereTracing& options);

    /// As every GridTracer; the `steps` of a hit are those along its ray.
    void trace(const scene::Tile& tile, std::span<scene::Hit> hits, base::Run& run) const override;

    SphereStatistics statistics() const;

  private:
    class Packet;

    const scene::Surface& surface_;
    scene::RayGrid rays_;
    const scene::ClipRegion& clip_;
    SphereTracing options_;
    double pixel_at_origin_; ///< half the distance of neighbouring rays at t = 0,
    double pixel_growth_;    ///< and how much it grows with t

    struct Counters {
        std::atomic<std::uint64_t> rays{0}, steps{0}, back_steps{0}, left{0}, came_near{0}, ran_out{0};
    };
    mutable Counters counters_;
};

} // namespace eliminant::render

namespace eliminant {
using render::SphereTracer;
using render::SphereTracing;
} // namespace eliminant
