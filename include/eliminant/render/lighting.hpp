/// \file
/// Lights, materials, and what reflects how much.
#pragma once

#include "eliminant/render/camera.hpp"
#include "eliminant/render/image.hpp"

#include <glm/vec3.hpp>

#include <vector>

namespace eliminant::render {

/// A light so far away that it comes from one direction everywhere.
struct DirectionalLight {
    glm::dvec3 towards{0, 0, 1}; ///< from the scene to the light; of any length but 0
    /// What a white matt surface that faces the light looks like in it (irradiance / π).
    Colour colour{1, 1, 1};
    /// How large it looks, as an angle from its middle to its edge, in degrees in [0, 45]: soft shadows are
    /// soft by this.
    double angular_radius = 0;
};

/// One side of a surface in the model of Blinn and Phong, with the half-way vector and normalised, so that
/// no surface reflects more light than it receives as long as diffuse + specular ≤ 1 in each channel.
struct Material {
    Colour diffuse{0.5F, 0.5F, 0.5F};
    Colour specular{0.04F, 0.04F, 0.04F};
    float shininess = 60; ///< exponent of the highlight, in [0, 10000]
};

/// Everything about a scene that is not its shape.
struct Lighting {
    std::vector<DirectionalLight> lights = {};
    Colour ambient{0.1F, 0.1F, 0.1F}; ///< light from everywhere; what a white surface looks like in it
    Colour background{0, 0, 0};       ///< where nothing is hit
    Material outside = {};            ///< seen from where the surface's function is positive
    Material inside = {};             ///< seen from where it is negative
};

/// Three lights that go with the camera (the main one from the upper left, so that relief is seen), a warm
/// outside, a cool inside, on white.
Lighting default_lighting(const Camera& camera);

/// \throws DomainError if a direction is null or not finite, a colour negative or not finite, or another
///   number out of its range
void check_lighting(const Lighting& lighting);

/// The reflectance f(l, v) of a material in one channel with these coefficients, times π:
///
///     diffuse + specular · π (s + 2)(s + 4) / (8π (s + 2^(−s/2))) · (n·h)^s,   h = (l + v) / |l + v|
///
/// The factor is the one for which a mirror-like surface (diffuse 0, specular 1) reflects, of light from the
/// direction n, exactly all into the hemisphere; from every other direction it is less.
/// \param diffuse,specular,shininess of the Material
/// \param cosine n·h, in [0, 1]
double reflectance_times_pi(double diffuse, double specular, double shininess, double cosine);

} // namespace eliminant::render

namespace eliminant {
using render::DirectionalLight;
using render::Lighting;
using render::Material;
} // namespace eliminant
