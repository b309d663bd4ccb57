#include "render/occlusion.hpp"

#include "render/sampling.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace eliminant::render {
namespace {

/// A ray that starts exactly on the surface would meet it there. In units of the radius of what is drawn: far
/// more than the rounding of a hit, far less than a pixel.
constexpr double relative_offset = 1e-6;

glm::dvec3 unit(const glm::dvec3& v) {
    return glm::normalize(v / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
}

} // namespace

OcclusionProbe::OcclusionProbe(const scene::Surface& surface, const scene::ClipRegion& clip,
                               const Lighting& lighting, const Occlusion& options, std::uint64_t seed)
    : surface_(surface), clip_(clip), options_(options), seed_(seed) {
    for (const DirectionalLight& light : lighting.lights)
        lights_.push_back({unit(light.towards), std::cos(light.angular_radius * (std::numbers::pi / 180))});
    const double radius = clip.bounding_ball().value_or(scene::Ball{}).radius;
    offset_ = relative_offset * radius;
    reach_ = options.ambient_reach * radius;
}

bool OcclusionProbe::is_blocked(const Place& place, const glm::dvec3& direction, double reach,
                                base::Run& run) const {
    const scene::Ray ray{place.point + offset_ * place.normal, direction};
    scene::Interval inside = clip_.interval(ray);
    inside.upper = std::min(inside.upper, reach);
    return !inside.empty() && surface_.occluded(ray, inside, run);
}

float OcclusionProbe::visibility(const Place& place, std::size_t light, std::uint64_t& rays,
                                 base::Run& run) const {
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    const glm::dvec3& towards = lights_[light].towards;
    const double least_cosine = lights_[light].least_cosine;
    if (least_cosine == 1) {
        if (!(glm::dot(place.normal, towards) > 0)) return 0; // shading knows, too
        ++rays;
        return is_blocked(place, towards, everywhere, run) ? 0 : 1;
    }
    const std::uint32_t count = options_.shadow_rays;
    const SampleSet samples(seed_, place.column, place.row, light + 1, count);
    std::uint32_t arrived = 0;
    const auto send = [&](SampleSet::Point sample) {
        ++rays;
        if (!is_blocked(place, direction_in_cone(towards, least_cosine, sample), everywhere, run)) ++arrived;
    };
    // Where the rays to the middle and the rim of the light all fare alike, so do nearly always the others.
    // Rays to arbitrary points of it would agree too often in a penumbra, which makes specks.
    constexpr std::uint32_t rim_rays = 6;
    if (count > rim_rays) {
        send({0, 0});
        for (std::uint32_t i = 0; i < rim_rays; ++i)
            send({samples[0].x + static_cast<double>(i) / rim_rays, 1});
        if (arrived == 0 || arrived == rim_rays + 1) return arrived == 0 ? 0 : 1;
        arrived = 0;
    }
    for (std::uint32_t i = 0; i < count; ++i) send(samples[i]);
    return static_cast<float>(arrived) / static_cast<float>(count);
}

float OcclusionProbe::openness(const Place& place, std::uint64_t& rays, base::Run& run) const {
    const std::uint32_t count = options_.ambient_rays;
    const SampleSet samples(seed_, place.column, place.row, 0, count);
    std::uint32_t open = 0;
    for (std::uint32_t i = 0; i < count; ++i)
        if (!is_blocked(place, direction_by_cosine(place.normal, samples[i]), reach_, run)) ++open;
    rays += count;
    return static_cast<float>(open) / static_cast<float>(count);
}

} // namespace eliminant::render
