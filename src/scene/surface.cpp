#include "eliminant/scene/surface.hpp"

#include "scene/star_occlusion.hpp"

#include "eliminant/base/error.hpp"

#include <algorithm>

namespace eliminant::scene {

bool Surface::occluded(const Ray& ray, Interval interval, base::Run& run) const {
    return static_cast<bool>(first_hit(ray, interval, run));
}

void Surface::occluded(const RayStars& rays, const ClipRegion& clip, double reach,
                       std::span<std::uint8_t> answers, base::Run& run) const {
    require_stars(rays, reach, answers.size());
    for (std::size_t k = 0; k < answers.size(); ++k) {
        Interval inside = clip.interval(rays.ray(k));
        inside.upper = std::min(inside.upper, reach);
        answers[k] = occluded(rays.ray(k), inside, run) ? 1 : 0;
    }
}

void Surface::distances(std::span<const glm::dvec3> points, field::DistanceLevel level,
                        std::span<double> results) const {
    if (points.size() != results.size())
        throw base::DomainError("distances: as many results as points are expected");
    for (std::size_t i = 0; i < points.size(); ++i) results[i] = distance(points[i], level);
}

} // namespace eliminant::scene
