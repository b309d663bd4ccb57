/// \file
/// What keeps light from points.
#pragma once

#include "eliminant/render/lighting.hpp"
#include "eliminant/render/renderer.hpp"
#include "render/sampling.hpp"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::render {

/// Sends rays from points of a surface to the lights and into the hemisphere, those of many points at a time.
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

    /// Memory that calls reuse, one for each thread.
    struct Scratch {
        std::uint64_t rays = 0; ///< how many were sent
        std::vector<std::size_t> lit;
        std::vector<std::size_t> penumbra;
        std::vector<glm::dvec3> origins;
        std::vector<glm::dvec3> directions;
        std::vector<std::uint8_t> blocked;
        std::vector<std::uint32_t> arrived;
    };

    /// The part of a light that arrives at each place; 0 where the light is behind the tangent plane.
    void visibility(std::span<const Place> places, std::size_t light, std::span<float> parts,
                    Scratch& scratch, base::Run& run) const;
    /// The part of the ambient light that arrives.
    void openness(std::span<const Place> places, std::span<float> parts, Scratch& scratch,
                  base::Run& run) const;

    bool has_shadows() const { return has_shadows_; }
    bool has_ambient() const { return ambient_pattern_.size() > 0; }

  private:
    struct Light {
        glm::dvec3 towards; ///< of length 1
        Frame frame;        ///< around it
        double least_cosine = 1;
    };

    /// Sends `rays` rays from each of the chosen places, and counts in scratch.arrived those that reach as
    /// far as `reach`. \param directions a function of a place, whose value is a function of a ray's number
    template <class Directions>
    void send(std::span<const Place> places, std::span<const std::size_t> chosen, std::uint32_t rays,
              double reach, const Directions& directions, Scratch& scratch, base::Run& run) const;
    void find_penumbra(std::span<const Place> places, std::size_t light, std::span<float> parts,
                       Scratch& scratch, base::Run& run) const;

    const scene::Surface& surface_;
    const scene::ClipRegion& clip_;
    bool has_shadows_;
    SamplePattern shadow_pattern_;
    SamplePattern rim_pattern_; ///< only its angles are used
    SamplePattern ambient_pattern_;
    std::uint64_t seed_;
    std::vector<Light> lights_;
    double offset_; ///< how far above the surface rays start
    double reach_;  ///< how far occluders of ambient light may be
};

} // namespace eliminant::render
