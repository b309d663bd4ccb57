/// \file
/// An algebraic surface inside somebody else's renderer: a torus above two triangles, in one picture with
/// common shadows. All that the renderer needs of the surface are its answers to rays.
///
///     example_surface_and_triangles > picture.ppm
#include "eliminant/algebra/parse.hpp"
#include "eliminant/base/error.hpp"
#include "eliminant/render/camera.hpp"
#include "eliminant/render/image_writer.hpp"
#include "eliminant/scene/algebraic_surface.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using eliminant::Interval;
using eliminant::Ray;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where a ray meets something, and what that looks like.
struct Meeting {
    double t = infinity;
    glm::dvec3 normal{0};
    glm::dvec3 colour{1}; // of the sky
};

struct Triangle {
    std::array<glm::dvec3, 3> corners;

    /// Möller and Trumbore, Journal of Graphics Tools 2 (1997).
    std::optional<double> meets(const Ray& ray) const {
        const glm::dvec3 first = corners[1] - corners[0];
        const glm::dvec3 second = corners[2] - corners[0];
        const glm::dvec3 p = glm::cross(ray.direction, second);
        const double determinant = glm::dot(first, p);
        if (determinant == 0) return std::nullopt;
        const glm::dvec3 to = ray.origin - corners[0];
        const double u = glm::dot(to, p) / determinant;
        const glm::dvec3 q = glm::cross(to, first);
        const double v = glm::dot(ray.direction, q) / determinant;
        const double t = glm::dot(second, q) / determinant;
        if (u < 0 || v < 0 || u + v > 1 || t < 0) return std::nullopt;
        return t;
    }
    glm::dvec3 normal() const {
        return glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    }
};

/// The renderer's own world, with the surface as one more kind of shape.
class World {
  public:
    World(const eliminant::Surface& surface, eliminant::ClipRegion region, eliminant::Run& run)
        : surface_(surface), region_(std::move(region)), run_(run) {}

    void add(const Triangle& triangle) { triangles_.push_back(triangle); }

    Meeting first_meeting(const Ray& ray) const {
        Meeting nearest;
        for (const Triangle& triangle : triangles_)
            if (const std::optional<double> t = triangle.meets(ray); t && *t < nearest.t)
                nearest = {*t, triangle.normal(), {0.55, 0.6, 0.65}};

        // The surface is asked about the part of the ray in front of what has been found.
        Interval interval = region_.interval(ray);
        interval.upper = std::min(interval.upper, nearest.t);
        if (interval.empty()) return nearest;
        if (const eliminant::Hit hit = surface_.first_hit(ray, interval, run_))
            nearest = {hit.t, glm::normalize(hit.gradient), {0.9, 0.5, 0.15}};
        return nearest;
    }

    bool is_shadowed(const Ray& ray) const {
        for (const Triangle& triangle : triangles_)
            if (triangle.meets(ray)) return true;
        const Interval interval = region_.interval(ray);
        return !interval.empty() && surface_.occluded(ray, interval, run_);
    }

    glm::dvec3 colour(const Ray& ray) const {
        const Meeting meeting = first_meeting(ray);
        if (meeting.t == infinity) return meeting.colour;
        const glm::dvec3 normal =
            glm::dot(meeting.normal, ray.direction) < 0 ? meeting.normal : -meeting.normal;
        const glm::dvec3 to_light = glm::normalize(glm::dvec3(1, 2, 1));
        const Ray shadow{ray.at(meeting.t) + 1e-6 * normal, to_light};
        const double light = is_shadowed(shadow) ? 0 : std::max(0.0, glm::dot(normal, to_light));
        return meeting.colour * (0.15 + 0.85 * light);
    }

  private:
    const eliminant::Surface& surface_;
    eliminant::ClipRegion region_;
    eliminant::Run& run_;
    std::vector<Triangle> triangles_;
};

void draw() {
    const eliminant::Ring ring(eliminant::CoefficientField::rationals(), {"x", "y", "z"});
    eliminant::Run run;
    const auto surface = eliminant::algebraic_surface(
        eliminant::parse_equation(ring, "(x^2+y^2+z^2+3/4)^2 = 4*(x^2+y^2)", run), run);
    World world(*surface, eliminant::ClipRegion().add(eliminant::Ball{glm::dvec3(0), 2}), run);
    world.add({{{{-4, -1.2, 4}, {4, -1.2, 4}, {-4, -1.2, -4}}}});
    world.add({{{{4, -1.2, 4}, {4, -1.2, -4}, {-4, -1.2, -4}}}});

    const eliminant::ImageSize size{160, 120};
    const auto rays = eliminant::Camera::perspective({{2, 2.5, 6}, {0, -0.3, 0}, {0, 1, 0}}, 32).rays(size);
    eliminant::Image image(size);
    for (std::uint32_t row = 0; row < size.height; ++row)
        for (std::uint32_t column = 0; column < size.width; ++column) {
            const glm::vec3 colour(world.colour(rays.ray(column, row)));
            image.set(column, row, {colour.r, colour.g, colour.b}, infinity);
        }
    eliminant::write_image(image, eliminant::ImageFormat::ppm, [](std::string_view bytes) {
        std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    });
}

} // namespace

int main() {
    try {
        draw();
        return std::cout.flush() ? 0 : 2;
    } catch (const eliminant::Error& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
