#include "eliminant/field/projection.hpp"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace eliminant::field {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

double largest_coordinate(const glm::dvec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// About the spacing of doubles around a point.
double spacing(const glm::dvec3& p) { return std::max(largest_coordinate(p), 0x1p-900) * 0x1p-52; }

/// The value without cancellation, so that Newton's iteration ends at the surface and not in the noise.
double value_at(const CompiledPolynomial& f, const glm::dvec3& q) { return f.reliable_value(q).value; }

/// Newton's iteration along the gradient.
glm::dvec3 descend(const CompiledPolynomial& f, glm::dvec3 q) {
    for (int i = 0; i < 100 && is_finite(q); ++i) {
        const Jet jet = f.jet(q);
        const double square = glm::dot(jet.gradient, jet.gradient);
        const glm::dvec3 step = (value_at(f, q) / square) * jet.gradient;
        if (!is_finite(step)) break;
        q -= step;
        if (glm::length(step) <= 4 * spacing(q)) break;
    }
    return q;
}

/// Newton's iteration for q − point + λ ∇f(q) = 0, f(q) = 0, from a point of the surface; where it ends, or
/// the start if that is no nearer.
glm::dvec3 slide(const CompiledPolynomial& f, const glm::dvec3& point, const glm::dvec3& start) {
    glm::dvec3 q = start;
    Jet jet = f.jet(q);
    double lambda = glm::dot(point - q, jet.gradient) / glm::dot(jet.gradient, jet.gradient);
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 residual = q - point + lambda * jet.gradient;
        const glm::dmat3 block = glm::dmat3(1.0) + lambda * jet.hessian.matrix();
        const glm::dmat4 lagrange(glm::dvec4(block[0], jet.gradient.x), glm::dvec4(block[1], jet.gradient.y),
                                  glm::dvec4(block[2], jet.gradient.z), glm::dvec4(jet.gradient, 0));
        const glm::dvec4 step = glm::inverse(lagrange) * glm::dvec4(residual, value_at(f, q));
        const glm::dvec3 move(step.x, step.y, step.z);
        if (!is_finite(move) || !std::isfinite(step.w) || !is_finite(q - move)) return start;
        q -= move;
        lambda -= step.w;
        jet = f.jet(q);
        if (glm::length(move) <= 4 * spacing(q))
            return glm::length(q - point) <= glm::length(start - point) * (1 + 0x1p-40) ? q : start;
    }
    return start;
}

/// The least radius, doubled from the spacing of doubles on, at which f changes its sign along the gradient;
/// +∞ if there is none of reasonable size.
double certified_radius(const CompiledPolynomial& f, const glm::dvec3& foot) {
    if (f.sign(foot) == 0) return 0;
    const glm::dvec3 gradient = f.jet(foot).gradient;
    const double slope = glm::length(gradient);
    if (!(slope > 0) || !std::isfinite(slope)) return infinity;
    const glm::dvec3 normal = gradient / slope;
    const double smallest = spacing(foot);
    for (double radius = smallest; radius <= smallest * 0x1p30; radius *= 2) {
        const glm::dvec3 ahead = foot + radius * normal;
        const glm::dvec3 behind = foot - radius * normal;
        if (!is_finite(ahead) || !is_finite(behind)) return infinity;
        if (f.sign(ahead) * f.sign(behind) <= 0)
            return std::max(glm::length(ahead - foot), glm::length(behind - foot)) * (1 + 0x1p-50);
    }
    return infinity;
}

} // namespace

std::optional<Projection> project(const DistanceField& field, const glm::dvec3& point) {
    const CompiledPolynomial& f = field.polynomial();
    if (!is_finite(point)) return std::nullopt;
    if (f.sign(point) == 0) return Projection{point, 0, 0, 0};
    const glm::dvec3 reached = descend(f, point);
    if (!is_finite(reached)) return std::nullopt;
    Projection result;
    result.foot = slide(f, point, reached);
    result.radius = certified_radius(f, result.foot);
    if (std::isinf(result.radius)) { // the second iteration may have left for a singular point
        result.foot = reached;
        result.radius = certified_radius(f, reached);
    }
    if (std::isinf(result.radius)) return std::nullopt;
    result.lower = distance(field, point, DistanceLevel::guaranteed).value;
    result.upper = (glm::length(point - result.foot) + result.radius) * (1 + 0x1p-50);
    return result;
}

} // namespace eliminant::field
