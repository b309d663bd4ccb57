#include "render/shading.hpp"

#include "render/fast_math.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace eliminant::render {
namespace {

float specular_factor(double specular, double shininess) {
    return static_cast<float>(reflectance_times_pi(0, specular, shininess, 1));
}

/// Vectors of length 1; their lengths are normal numbers.
void normalise(std::array<ShadingBatch::Floats, 3>& vectors, std::size_t count) {
    auto& [x, y, z] = vectors;
    for (std::size_t i = 0; i < count; ++i) {
        const float inverse = 1 / std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
        x[i] *= inverse;
        y[i] *= inverse;
        z[i] *= inverse;
    }
}

} // namespace

void orient(ShadingBatch& batch) {
    normalise(batch.normal, batch.count);
    normalise(batch.view, batch.count);
    auto& [nx, ny, nz] = batch.normal;
    const auto& [vx, vy, vz] = batch.view;
    for (std::size_t i = 0; i < batch.count; ++i) {
        const float facing = nx[i] * vx[i] + ny[i] * vy[i] + nz[i] * vz[i];
        const float turn = facing < 0 ? -1.0F : 1.0F;
        const float side = batch.side[i] != 0 ? batch.side[i] : turn;
        batch.is_outside[i] = side > 0 ? 1.0F : 0.0F;
        nx[i] *= turn;
        ny[i] *= turn;
        nz[i] *= turn;
    }
}

Shader::Shader(const Lighting& lighting) : ambient_(lighting.ambient) {
    for (const DirectionalLight& light : lighting.lights) {
        const double largest = std::max({std::abs(light.towards.x), std::abs(light.towards.y),
                                         std::abs(light.towards.z)}); // before squares overflow
        const glm::dvec3 towards = glm::normalize(light.towards / largest);
        lights_.push_back(
            {{static_cast<float>(towards.x), static_cast<float>(towards.y), static_cast<float>(towards.z)},
             light.colour});
    }
    const Material& inside = lighting.inside;
    const Material& outside = lighting.outside;
    for (std::size_t i = 0; i < 3; ++i) {
        const float specular_inside = specular_factor(inside.specular[i], inside.shininess);
        const float specular_outside = specular_factor(outside.specular[i], outside.shininess);
        diffuse_[i] = {inside.diffuse[i], outside.diffuse[i] - inside.diffuse[i]};
        specular_[i] = {specular_inside, specular_outside - specular_inside};
    }
    shininess_ = {inside.shininess, outside.shininess - inside.shininess};
}

void Shader::shade(ShadingBatch& batch) const {
    for (std::size_t channel = 0; channel < 3; ++channel)
        for (std::size_t i = 0; i < batch.count; ++i)
            batch.colour[channel][i] =
                ambient_[channel] * batch.openness[i] * diffuse_[channel].at(batch.is_outside[i]);
    for (std::size_t i = 0; i < lights_.size(); ++i)
        add_light(batch, lights_[i], batch.visibility.empty() ? nullptr : &batch.visibility[i]);
}

void Shader::add_light(ShadingBatch& batch, const Light& light,
                       const ShadingBatch::Floats* visibility) const {
    const auto [lx, ly, lz] = light.towards;
    const auto& [nx, ny, nz] = batch.normal;
    const auto& [vx, vy, vz] = batch.view;
    ShadingBatch::Floats received; // cosine of incidence times visibility
    ShadingBatch::Floats highlight;
    constexpr float least = 1e-12F;
    for (std::size_t i = 0; i < batch.count; ++i) {
        const float cosine = nx[i] * lx + ny[i] * ly + nz[i] * lz;
        received[i] = cosine > 0 ? cosine : 0;
        // n·(l + v) / |l + v|, with |l + v|² = 2 + 2 l·v
        const float sum = cosine + nx[i] * vx[i] + ny[i] * vy[i] + nz[i] * vz[i];
        const float square = 2 + 2 * (lx * vx[i] + ly * vy[i] + lz * vz[i]);
        const float half_cosine = sum / std::sqrt(square > least ? square : least);
        const float clamped = half_cosine < 1 ? half_cosine : 1;
        highlight[i] = fast_power(clamped > 0 ? clamped : 0, shininess_.at(batch.is_outside[i]));
    }
    if (visibility != nullptr)
        for (std::size_t i = 0; i < batch.count; ++i) received[i] *= (*visibility)[i];
    for (std::size_t channel = 0; channel < 3; ++channel)
        for (std::size_t i = 0; i < batch.count; ++i)
            batch.colour[channel][i] += light.colour[channel] * received[i] *
                                        (diffuse_[channel].at(batch.is_outside[i]) +
                                         specular_[channel].at(batch.is_outside[i]) * highlight[i]);
}

} // namespace eliminant::render
