#include "eliminant/scene/surface.hpp"

#include "eliminant/base/error.hpp"

namespace eliminant::scene {

bool Surface::occluded(const Ray& ray, Interval interval, base::Run& run) const {
    return static_cast<bool>(first_hit(ray, interval, run));
}

void Surface::distances(std::span<const glm::dvec3> points, field::DistanceLevel level,
                        std::span<double> results) const {
    if (points.size() != results.size())
        throw base::DomainError("distances: as many results as points are expected");
    for (std::size_t i = 0; i < points.size(); ++i) results[i] = distance(points[i], level);
}

} // namespace eliminant::scene
