#include "scene/framing.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace eliminant::scene {
namespace {

/// The farthest point from the origin where rays along the axes, `count` × `count` for each axis, enter or
/// leave the surface within the ball; 0 without hits.
double farthest_hit(const Surface& surface, double radius, int count, base::Run& run) {
    double farthest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < count; ++j) {
                // Off the planes of symmetry, where surfaces have their singular points.
                glm::dvec3 origin(0.0);
                origin[(axis + 1) % 3] = radius * ((2.0 * i + 1.07) / count - 1.0);
                origin[(axis + 2) % 3] = radius * ((2.0 * j + 1.13) / count - 1.0);
                const double squared = radius * radius - glm::dot(origin, origin);
                if (squared <= 0.0) continue;
                for (const double sense : {-1.0, 1.0}) {
                    glm::dvec3 direction(0.0);
                    direction[axis] = sense;
                    const double reach = std::sqrt(squared);
                    const Hit hit = surface.first_hit({origin, direction}, {-reach, reach}, run);
                    if (hit) farthest = std::max(farthest, glm::length(origin + hit.t * direction));
                }
            }
    return farthest;
}

} // namespace

double asymptotic_radius(const algebra::Polynomial& f) {
    constexpr int directions = 60;
    const std::size_t variables = f.ring().variable_count();
    std::vector<double> squares(static_cast<std::size_t>(std::max<std::int64_t>(f.total_degree(), 0)) + 1);
    std::vector<double> parts(squares.size());
    for (int d = 0; d < directions; ++d) {
        // Points of equal area on the sphere along a golden spiral.
        const double z = 1.0 - (2.0 * d + 1.0) / directions;
        const double angle = 2.399963229728653 * d;
        const double r = std::sqrt(1.0 - z * z);
        const std::array<double, 3> point{r * std::cos(angle), r * std::sin(angle), z};
        std::ranges::fill(parts, 0.0);
        for (std::size_t i = 0; i < f.size(); ++i) {
            double term = f.integer_terms().coefficients[i].to_double();
            std::size_t degree = 0;
            for (std::size_t v = 0; v < variables; ++v) {
                const auto e = static_cast<std::size_t>(f.exponent(i, v));
                term *= std::pow(point[v], static_cast<double>(e));
                degree += e;
            }
            parts[degree] += term;
        }
        for (std::size_t m = 0; m < parts.size(); ++m) squares[m] += parts[m] * parts[m];
    }
    // Σ_{m<n} |part m| r^(m−n) decreases in r.
    const auto others = [&squares](double r) {
        double sum = 0.0;
        for (std::size_t m = 0; m + 1 < squares.size(); ++m) sum = (sum + std::sqrt(squares[m])) / r;
        return sum;
    };
    double radius = 0x1p-20;
    while (radius < 0x1p20 && others(radius) > std::sqrt(squares.back())) radius *= 1.25;
    const bool told = std::isfinite(others(radius)) && radius > 0x1p-20 && radius < 0x1p20;
    return told ? radius : 1.0;
}

Ball frame(const Surface& surface, double radius_if_unbounded, base::Run& run) {
    constexpr double least = 0x1p-6;
    constexpr double largest = 0x1p8;
    const glm::dvec3 origin(0.0);
    // From the largest ball down to the first that has hits not only near its middle.
    for (double radius = largest; radius >= least; radius *= 0.5) {
        const double farthest = farthest_hit(surface, radius, 5, run);
        if (farthest <= 0.3 * radius) continue;
        if (radius == largest) break;
        return {origin, 1.1 * std::max(farthest, farthest_hit(surface, 1.5 * radius, 16, run))};
    }
    return {origin, radius_if_unbounded};
}

} // namespace eliminant::scene
