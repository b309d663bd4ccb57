#include "render/occlusion.hpp"

#include "render/sampling.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

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
    : surface_(surface), clip_(clip), has_shadows_(options.shadows), shadow_pattern_(options.shadow_rays),
      rim_pattern_(6), ambient_pattern_(options.ambient_rays), seed_(seed) {
    for (const DirectionalLight& light : lighting.lights) {
        const glm::dvec3 towards = unit(light.towards);
        lights_.push_back(
            {towards, Frame(towards), std::cos(light.angular_radius * (std::numbers::pi / 180))});
    }
    const double radius = clip.bounding_ball().value_or(scene::Ball{}).radius;
    offset_ = relative_offset * radius;
    reach_ = options.ambient_reach * radius;
}

template <class Directions>
void OcclusionProbe::send(std::span<const Place> places, std::span<const std::size_t> chosen,
                          std::uint32_t rays, double reach, const Directions& directions, Scratch& scratch,
                          base::Run& run) const {
    scratch.rays += chosen.size() * rays;
    scratch.arrived.assign(chosen.size(), 0);
    constexpr std::size_t most_rays = 8192; // at a time: they stay in the second-level cache
    const std::size_t most_places = std::max<std::size_t>(16, most_rays / rays);
    for (std::size_t first = 0; first < chosen.size(); first += most_places) {
        const std::size_t count = std::min(most_places, chosen.size() - first);
        run.poll();
        scratch.origins.resize(count);
        scratch.directions.resize(count * rays);
        scratch.blocked.resize(count * rays);
        for (std::size_t i = 0; i < count; ++i) {
            const Place& place = places[chosen[first + i]];
            scratch.origins[i] = place.point + offset_ * place.normal;
            const auto direction = directions(place);
            for (std::uint32_t ray = 0; ray < rays; ++ray)
                scratch.directions[ray * count + i] = direction(ray);
        }
        surface_.occluded({scratch.origins, scratch.directions}, clip_, reach, scratch.blocked, run);
        for (std::size_t k = 0; k < scratch.blocked.size(); ++k)
            scratch.arrived[first + k % count] += scratch.blocked[k] == 0 ? 1 : 0;
    }
}

void OcclusionProbe::visibility(std::span<const Place> places, std::size_t light, std::span<float> parts,
                                Scratch& scratch, base::Run& run) const {
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    const Light& source = lights_[light];
    scratch.lit.clear();
    for (std::size_t i = 0; i < places.size(); ++i) {
        parts[i] = 0;
        if (glm::dot(places[i].normal, source.towards) > 0) scratch.lit.push_back(i);
    }
    if (source.least_cosine == 1) {
        const auto to_it = [&](const Place&) { return [&](std::uint32_t) { return source.towards; }; };
        send(places, scratch.lit, 1, everywhere, to_it, scratch, run);
        for (std::size_t i = 0; i < scratch.lit.size(); ++i)
            parts[scratch.lit[i]] = static_cast<float>(scratch.arrived[i]);
        return;
    }
    find_penumbra(places, light, parts, scratch, run);
    const auto into_it = [&](const Place& place) {
        const SampleSet samples(shadow_pattern_, seed_, place.column, place.row, light + 1);
        return [&source, samples](std::uint32_t ray) {
            return source.frame.in_cone(source.least_cosine, samples[ray]);
        };
    };
    send(places, scratch.penumbra, shadow_pattern_.size(), everywhere, into_it, scratch, run);
    for (std::size_t i = 0; i < scratch.penumbra.size(); ++i)
        parts[scratch.penumbra[i]] =
            static_cast<float>(scratch.arrived[i]) / static_cast<float>(shadow_pattern_.size());
}

/// Where the rays to the middle and the rim of the light all fare alike, so do nearly always the others: sets
/// the parts there, and leaves the other places in scratch.penumbra. Rays to arbitrary points of the light
/// would agree too often in a penumbra, which makes specks.
void OcclusionProbe::find_penumbra(std::span<const Place> places, std::size_t light, std::span<float> parts,
                                   Scratch& scratch, base::Run& run) const {
    scratch.penumbra = scratch.lit;
    const std::uint32_t rim_rays = rim_pattern_.size();
    if (shadow_pattern_.size() <= rim_rays) return;
    const Light& source = lights_[light];
    const auto to_middle_and_rim = [&](const Place& place) {
        const SampleSet samples(rim_pattern_, seed_, place.column, place.row, light + 1);
        return [&source, samples, rim_rays](std::uint32_t ray) {
            if (ray == rim_rays) return source.towards;
            return source.frame.on_rim(source.least_cosine, samples[ray]);
        };
    };
    send(places, scratch.lit, rim_rays + 1, std::numeric_limits<double>::infinity(), to_middle_and_rim,
         scratch, run);
    scratch.penumbra.clear();
    for (std::size_t i = 0; i < scratch.lit.size(); ++i) {
        const std::uint32_t arrived = scratch.arrived[i];
        if (arrived == 0 || arrived == rim_rays + 1)
            parts[scratch.lit[i]] = arrived == 0 ? 0.0F : 1.0F;
        else
            scratch.penumbra.push_back(scratch.lit[i]);
    }
}

void OcclusionProbe::openness(std::span<const Place> places, std::span<float> parts, Scratch& scratch,
                              base::Run& run) const {
    scratch.lit.resize(places.size());
    std::iota(scratch.lit.begin(), scratch.lit.end(), std::size_t{0});
    const auto up = [&](const Place& place) {
        const Frame frame(place.normal);
        const SampleSet samples(ambient_pattern_, seed_, place.column, place.row, 0);
        return [frame, samples](std::uint32_t ray) { return frame.by_cosine(samples[ray]); };
    };
    send(places, scratch.lit, ambient_pattern_.size(), reach_, up, scratch, run);
    for (std::size_t i = 0; i < places.size(); ++i)
        parts[i] = static_cast<float>(scratch.arrived[i]) / static_cast<float>(ambient_pattern_.size());
}

} // namespace eliminant::render
