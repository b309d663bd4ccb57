/// \file
/// What keeps light from a point.
#pragma once

#include "eliminant/render/lighting.hpp"
#include "eliminant/render/renderer.hpp"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eliminant::render {

/// Sends rays from points of a surface to the lights and into the hemisphere.
class OcclusionProbe {
  public:
    /// What it is given must outlive it.
    OcclusionProbe(const scene::Surface& surface, const scene::ClipRegion& clip, const Lighting& lighting,
                   const Occlusion& options, std::uint64_t seed);

    /// A point to be lit.
    struct Place {
        glm::dvec3 point;         ///< on the surface
        glm::dvec3 normal;        ///< of length 1, on the side that is seen
        std::uint64_t column = 0; ///< which sample of the picture it is, for the choice of directions
        std::uint64_t row = 0;
    };

    /// The part of a light that arrives. Adds the number of rays to `rays`.
    float visibility(const Place& place, std::size_t light, std::uint64_t& rays, base::Run& run) const;
    /// The part of the ambient light that arrives.
    float openness(const Place& place, std::uint64_t& rays, base::Run& run) const;

    bool has_shadows() const { return options_.shadows; }
    bool has_ambient() const { return options_.ambient_rays > 0; }

  private:
    struct Light {
        glm::dvec3 towards; ///< of length 1
        double least_cosine = 1;
    };
    bool is_blocked(const Place& place, const glm::dvec3& direction, double reach, base::Run& run) const;

    const scene::Surface& surface_;
    const scene::ClipRegion& clip_;
    Occlusion options_;
    std::uint64_t seed_;
    std::vector<Light> lights_;
    double offset_; ///< how far above the surface rays start
    double reach_;  ///< how far occluders of ambient light may be
};

} // namespace eliminant::render
