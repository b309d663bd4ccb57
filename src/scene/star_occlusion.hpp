#pragma once

#include "eliminant/base/run.hpp"
#include "eliminant/scene/clip_region.hpp"
#include "eliminant/scene/ray.hpp"

#include "field/ray_stars.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::scene {

/// \throws DomainError unless all rays are rays, there are as many answers, and as many rays from each point
void require_stars(const RayStars& rays, double reach, std::size_t answers);

/// Stars of rays as field::StarRoots takes them: coordinates apart, the points padded.
class StarPacket {
  public:
    StarPacket(const RayStars& rays, const ClipRegion& clip, double reach);

    struct Ray {
        std::size_t index;
        Interval interval;
    };
    /// Sets the answers that are certain, to 1 or 0, and returns the other rays.
    std::vector<Ray> solve(const field::StarRoots& roots, std::span<std::uint8_t> answers, base::Run& run);

  private:
    std::size_t points_;
    std::size_t padded_;
    std::size_t rays_; ///< of each point
    std::array<std::vector<double>, 3> origins_;
    std::array<std::vector<double>, 3> directions_;
    std::vector<double> lower_;
    std::vector<double> upper_;
    std::vector<field::RayState> states_;
};

} // namespace eliminant::scene
