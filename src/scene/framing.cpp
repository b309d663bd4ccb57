#include "scene/framing.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace eliminant::scene {
namespace {

/// How far from the centre rays along the axes, `count` × `count` for each axis, enter or leave the surface
/// within the ball at the farthest; 0 without hits.
double farthest_hit(const Surface& surface, const Ball& ball, int count, base::Run& run) {
    const double radius = ball.radius;
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
                    const Hit hit =
                        surface.first_hit({ball.center + origin, direction}, {-reach, reach}, run);
                    if (hit) farthest = std::max(farthest, glm::length(origin + hit.t * direction));
                }
            }
    return farthest;
}

using Form = std::map<std::array<std::uint64_t, 3>, double>; ///< coefficients by exponents

Form part_of_degree(const algebra::Polynomial& f, std::uint64_t degree) {
    Form form;
    for (std::size_t i = 0; i < f.size(); ++i) {
        std::array<std::uint64_t, 3> e{};
        for (std::size_t v = 0; v < f.ring().variable_count(); ++v) e.at(v) = f.exponent(i, v);
        if (e[0] + e[1] + e[2] == degree) form[e] = f.integer_terms().coefficients[i].to_double();
    }
    return form;
}

Form derivative(const Form& form, std::size_t variable) {
    Form result;
    for (const auto& [e, c] : form) {
        if (e.at(variable) == 0) continue;
        std::array<std::uint64_t, 3> lower = e;
        --lower.at(variable);
        result[lower] = c * static_cast<double>(e.at(variable));
    }
    return result;
}

/// Bombieri's inner product, Σ a_e·b_e·e!/n!, which rotations leave as it is.
double product(const Form& a, const Form& b) {
    double sum = 0.0;
    for (const auto& [e, c] : a) {
        const auto other = b.find(e);
        if (other == b.end()) continue;
        const auto log_factorial = [](std::uint64_t k) { return std::lgamma(static_cast<double>(k) + 1.0); };
        sum += c * other->second *
               std::exp(log_factorial(e[0]) + log_factorial(e[1]) + log_factorial(e[2]) -
                        log_factorial(e[0] + e[1] + e[2]));
    }
    return sum;
}

/// The coordinates x[i] with G·x = b that G, symmetric and not negative, tells; they become known.
void solve(std::array<std::array<double, 3>, 3> G, std::array<double, 3> b, glm::dvec3& x,
           std::array<bool, 3>& known) {
    std::array<bool, 3> used{};
    const double scale = std::max({G[0][0], G[1][1], G[2][2]});
    for (std::size_t step = 0; step < 3; ++step) {
        std::size_t p = 3;
        for (std::size_t i = 0; i < 3; ++i)
            if (!used.at(i) && !known.at(i) && (p == 3 || G[i][i] > G[p][p])) p = i;
        if (p == 3 || !(G[p][p] > 1e-12 * scale)) break;
        used.at(p) = true;
        for (std::size_t i = 0; i < 3; ++i) {
            if (i == p) continue;
            const double factor = G[i][p] / G[p][p];
            for (std::size_t k = 0; k < 3; ++k) G[i][k] -= factor * G[p][k];
            b.at(i) -= factor * b[p];
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if (!used.at(i)) continue;
        x[static_cast<int>(i)] = b.at(i) / G[i][i];
        known.at(i) = true;
    }
}

} // namespace

glm::dvec3 center_of(const algebra::Polynomial& f) {
    glm::dvec3 center(0.0);
    std::array<bool, 3> known{};
    // Coordinates that the highest part does not contain are told by lower ones.
    for (std::int64_t degree = f.total_degree(); degree > 0; --degree) {
        const Form top = part_of_degree(f, static_cast<std::uint64_t>(degree));
        if (top.empty()) continue;
        const Form next = part_of_degree(f, static_cast<std::uint64_t>(degree - 1));
        std::array<Form, 3> gradient;
        for (std::size_t i = 0; i < 3; ++i)
            if (!known.at(i)) gradient.at(i) = derivative(top, i);
        std::array<std::array<double, 3>, 3> G{};
        std::array<double, 3> b{};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) G.at(i).at(j) = product(gradient.at(i), gradient.at(j));
            b.at(i) = -product(next, gradient.at(i));
        }
        solve(G, b, center, known);
        if (known[0] && known[1] && known[2]) break;
    }
    constexpr double negligible = 0x1p-20; // rounding
    const double distance = glm::length(center);
    return std::isfinite(distance) && distance > negligible ? center : glm::dvec3(0.0);
}

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

Ball frame(const Surface& surface, const glm::dvec3& center, double radius_if_unbounded, base::Run& run) {
    constexpr double least = 0x1p-6;
    constexpr double largest = 0x1p8;
    // From the largest ball down to the first that has hits not only near its middle.
    for (double radius = largest; radius >= least; radius *= 0.5) {
        const double farthest = farthest_hit(surface, {center, radius}, 5, run);
        if (farthest <= 0.3 * radius) continue;
        if (radius == largest) break;
        const double closer = farthest_hit(surface, {center, 1.5 * radius}, 16, run);
        return {center, 1.1 * std::max(farthest, closer)};
    }
    return {center, radius_if_unbounded};
}

} // namespace eliminant::scene
