#include "scene/framing.hpp"

#include "eliminant/algebra/evaluation.hpp"

#include <glm/geometric.hpp>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
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

/// Points of equal area on the unit sphere along a golden spiral.
glm::dvec3 spiral(int index, int count) {
    const double z = 1.0 - (2.0 * index + 1.0) / count;
    const double angle = 2.399963229728653 * index;
    const double r = std::sqrt(1.0 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

/// Goes from a point of the sphere of a ball against the values of the function, by Newton's steps along it,
/// until the sign is another one.
bool reaches_other_sign(const Surface& surface, const Ball& ball, glm::dvec3 direction, bool is_positive,
                        base::Run& run) {
    constexpr int most_steps = 40;
    constexpr double longest_step = 0.25;
    for (int step = 0; step < most_steps; ++step) {
        run.poll();
        const glm::dvec3 point = ball.center + ball.radius * direction;
        const double value = surface.value(point);
        if (!std::isfinite(value)) return false;
        if ((value > 0.0) != is_positive) return true;
        const glm::dvec3 gradient = surface.gradient(point);
        const glm::dvec3 along = gradient - glm::dot(gradient, direction) * direction;
        const double slope = glm::length(along);
        if (!(slope > 0.0) || !std::isfinite(slope)) return false;
        // A little further than to the zero of the tangent.
        const double angle = std::min(1.1 * std::abs(value) / (slope * ball.radius), longest_step);
        direction = glm::normalize(direction - (is_positive ? angle : -angle) / slope * along);
    }
    return false;
}

/// Whether the surface passes through the sphere of a ball, as far as samples and descents from them tell:
/// rays miss what is thin far away.
bool crosses_sphere(const Surface& surface, const Ball& ball, base::Run& run) {
    constexpr int samples = 200;
    constexpr std::size_t descents = 8;
    std::vector<std::pair<double, int>> sizes;
    int positive = 0;
    for (int i = 0; i < samples; ++i) {
        run.poll();
        const double value = surface.value(ball.center + ball.radius * spiral(i, samples));
        if (!std::isfinite(value)) return false;
        positive += value > 0.0 ? 1 : 0;
        sizes.emplace_back(std::abs(value), i);
    }
    if (positive != 0 && positive != samples) return true;
    std::partial_sort(sizes.begin(), sizes.begin() + descents, sizes.end());
    return std::any_of(sizes.begin(), sizes.begin() + descents, [&](const auto& sample) {
        return reaches_other_sign(surface, ball, spiral(sample.second, samples), positive != 0, run);
    });
}

/// The median distance of the first hits of rays from the middle of a ball; 0 if few rays hit.
double usual_distance(const Surface& surface, const Ball& ball, base::Run& run) {
    constexpr int rays = 96;
    // Off the centre of symmetry, where all that is singular there would be met.
    const glm::dvec3 origin = ball.center + 0x1p-20 * ball.radius * glm::dvec3(0.51, 0.67, 0.36);
    std::vector<double> distances;
    for (int i = 0; i < rays; ++i)
        if (const Hit hit = surface.first_hit({origin, spiral(i, rays)}, {0.0, ball.radius}, run))
            distances.push_back(hit.t);
    if (distances.size() < rays / 3) return 0.0;
    const auto median = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), median, distances.end());
    return *median;
}

/// Where powers of coordinates are still numbers of doubles, with room for coefficients: farther out
/// everything is decided by integers of thousands of digits.
double largest_radius(const algebra::Polynomial& f) {
    constexpr double largest = 0x1p8;
    constexpr double exponents = 800.0;
    return std::min(largest,
                    std::exp2(exponents / static_cast<double>(std::max<std::int64_t>(f.total_degree(), 1))));
}

/// Expanding a polynomial about a point takes too long beyond.
constexpr std::int64_t most_shifted_degree = 24;

/// f(center + q), q being the variables.
algebra::Polynomial shifted(const algebra::Polynomial& f, const glm::dvec3& center, base::Run& run) {
    std::vector<algebra::Polynomial> images;
    for (std::size_t v = 0; v < f.ring().variable_count(); ++v)
        images.push_back(algebra::Polynomial::variable(f.ring(), v) +
                         algebra::Polynomial::constant(f.ring(), mpq_class(center[static_cast<int>(v)])));
    return algebra::compose(f, f.ring(), images, run);
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
        const glm::dvec3 point = spiral(d, directions);
        std::ranges::fill(parts, 0.0);
        for (std::size_t i = 0; i < f.size(); ++i) {
            double term = f.integer_terms().coefficients[i].to_double();
            std::size_t degree = 0;
            for (std::size_t v = 0; v < variables; ++v) {
                const auto e = static_cast<std::size_t>(f.exponent(i, v));
                term *= std::pow(point[static_cast<int>(v)], static_cast<double>(e));
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

Ball frame(const Surface& surface, const algebra::Polynomial& f, base::Run& run) {
    constexpr double least = 0x1p-6;
    const double largest = largest_radius(f);
    glm::dvec3 center = center_of(f);
    double asymptotic = 1.0;
    if (center == glm::dvec3(0.0))
        asymptotic = asymptotic_radius(f);
    else if (f.total_degree() <= most_shifted_degree)
        asymptotic = asymptotic_radius(shifted(f, center, run));
    // A centre far away from where the surface is met all around says more about the polynomial than about
    // what is of interest.
    constexpr double far = 8.0;
    const double around_origin = usual_distance(surface, {glm::dvec3(0.0), largest}, run);
    const bool is_credible = !(around_origin > 0.0 && far * around_origin < glm::length(center));
    if (!is_credible) center = glm::dvec3(0.0);

    // From the largest ball down to the first that has hits not only near its middle.
    if (!crosses_sphere(surface, {center, largest}, run))
        for (double radius = largest; radius >= least; radius *= 0.5) {
            const double farthest = farthest_hit(surface, {center, radius}, 5, run);
            if (farthest <= 0.3 * radius) continue;
            if (radius == largest) break;
            const double closer = farthest_hit(surface, {center, 1.5 * radius}, 16, run);
            return {center, 1.1 * std::max(farthest, closer)};
        }
    constexpr double room = 1.75;
    if (!is_credible) return {center, room * around_origin};
    return {center, std::max(asymptotic, room * usual_distance(surface, {center, largest}, run))};
}

} // namespace eliminant::scene
