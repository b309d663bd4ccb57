#pragma once

#include "eliminant/scene/ray.hpp"

#include "eliminant/base/error.hpp"

#include <cmath>

namespace eliminant::scene {

inline bool is_finite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// \throws DomainError for what is no ray
inline void require_ray(const Ray& ray) {
    if (!is_finite(ray.origin) || !is_finite(ray.direction))
        throw base::DomainError("ray: origin and direction must be finite numbers");
    if (ray.direction == glm::dvec3(0.0)) throw base::DomainError("ray: the direction is 0");
}

} // namespace eliminant::scene
