#include "eliminant/render/lighting.hpp"

#include "eliminant/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace eliminant::render {
namespace {

[[noreturn]] void fail(const std::string& what) { throw DomainError("lighting: " + what); }

void check_colour(const Colour& colour, const std::string& of) {
    for (const float channel : colour)
        if (!(channel >= 0) || !std::isfinite(channel))
            fail("expected the " + of + " to have finite channels that are not negative, found " +
                 std::to_string(channel));
}

void check_light(const DirectionalLight& light) {
    const glm::dvec3& d = light.towards;
    if (!std::isfinite(d.x) || !std::isfinite(d.y) || !std::isfinite(d.z) || d == glm::dvec3(0))
        fail("expected a finite direction towards a light that is not the null vector");
    check_colour(light.colour, "colour of a light");
    if (!(light.angular_radius >= 0 && light.angular_radius <= 45))
        fail("expected an angular radius of a light from 0 to 45 degrees, found " +
             std::to_string(light.angular_radius));
}

void check_material(const Material& material) {
    check_colour(material.diffuse, "diffuse colour of a material");
    check_colour(material.specular, "specular colour of a material");
    if (!(material.shininess >= 0 && material.shininess <= 10000))
        fail("expected a shininess from 0 to 10000, found " + std::to_string(material.shininess));
}

/// A colour as pictures and web pages write it, 0xrrggbb.
Colour from_hex(unsigned rgb) {
    const auto channel = [&](unsigned shift) {
        return static_cast<float>(linear_from_srgb(((rgb >> shift) & 0xff) / 255.0));
    };
    return {channel(16), channel(8), channel(0)};
}

Colour grey(float value) { return {value, value, value}; }

} // namespace

Lighting default_lighting(const Camera& camera) {
    const auto towards = [&](double right, double up, double back) {
        return right * camera.right() + up * camera.up() - back * camera.forward();
    };
    Lighting lighting;
    lighting.lights = {{towards(-0.6, 0.8, 0.7), {0.90F, 0.87F, 0.82F}, 2},
                       {towards(0.9, 0.1, 0.6), {0.18F, 0.20F, 0.25F}, 10},
                       {towards(0.1, -0.8, 0.3), {0.07F, 0.07F, 0.07F}, 20}};
    lighting.ambient = grey(0.10F);
    lighting.background = grey(1);
    lighting.outside = {from_hex(0xe8a33d), grey(0.05F), 80};
    lighting.inside = {from_hex(0x3f84c4), grey(0.05F), 80};
    return lighting;
}

void check_lighting(const Lighting& lighting) {
    std::for_each(lighting.lights.begin(), lighting.lights.end(), check_light);
    check_colour(lighting.ambient, "ambient colour");
    check_colour(lighting.background, "background colour");
    check_material(lighting.outside);
    check_material(lighting.inside);
}

double reflectance_times_pi(double diffuse, double specular, double shininess, double cosine) {
    const double s = shininess;
    const double normalisation = (s + 2) * (s + 4) / (8 * (s + std::exp2(-s / 2)));
    return diffuse + specular * normalisation * std::pow(cosine, s);
}

} // namespace eliminant::render
