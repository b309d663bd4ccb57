#include "eliminant/field/curvature.hpp"

#include <glm/geometric.hpp>

#include <cmath>

namespace eliminant::field {

std::optional<Curvatures> curvatures(const Jet& jet) {
    const double slope = std::hypot(jet.gradient.x, jet.gradient.y, jet.gradient.z);
    if (!(slope > 0) || !std::isfinite(slope) || !std::isfinite(jet.hessian.frobenius_norm()))
        return std::nullopt;
    Curvatures result;
    const glm::dvec3 n = jet.gradient / slope;
    result.normal = n;

    // A basis a, b of the tangent plane, from the axis that is farthest from the normal.
    const glm::dvec3 magnitude = glm::abs(n);
    glm::dvec3 axis(0);
    axis[magnitude.x <= magnitude.y ? (magnitude.x <= magnitude.z ? 0 : 2)
                                    : (magnitude.y <= magnitude.z ? 1 : 2)] = 1;
    const glm::dvec3 a = glm::normalize(glm::cross(n, axis));
    const glm::dvec3 b = glm::cross(n, a);

    // The shape operator in that basis: {{p, q}, {q, r}}.
    const glm::dmat3 hessian = jet.hessian.matrix();
    const double p = glm::dot(a, hessian * a) / slope;
    const double q = glm::dot(a, hessian * b) / slope;
    const double r = glm::dot(b, hessian * b) / slope;
    result.mean = (p + r) / 2;
    result.gaussian = p * r - q * q;
    const double radius = std::hypot((p - r) / 2, q);
    result.principal = {result.mean + radius, result.mean - radius};
    const double angle = std::atan2(q, (p - r) / 2) / 2;
    result.directions[0] = std::cos(angle) * a + std::sin(angle) * b;
    result.directions[1] = std::cos(angle) * b - std::sin(angle) * a;
    return result;
}

} // namespace eliminant::field
