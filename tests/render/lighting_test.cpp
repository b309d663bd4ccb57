// Reflection keeps the laws of physics; the vector code computes what the formula says.
#include "eliminant/base/error.hpp"
#include "render/fast_math.hpp"
#include "render/sampling.hpp"
#include "render/shading.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>

namespace eliminant::render {
namespace {

constexpr double pi = std::numbers::pi;

/// A direction in the plane of incidence, or turned out of it.
glm::dvec3 direction(double polar, double azimuth) {
    return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)};
}

double reflectance(const Material& material, const glm::dvec3& light, const glm::dvec3& view) {
    const glm::dvec3 half = glm::normalize(light + view);
    return reflectance_times_pi(material.diffuse[0], material.specular[0], material.shininess,
                                std::max(0.0, half.z)) /
           pi;
}

/// The part of light from one direction that goes anywhere: the integral of the reflectance times the cosine.
double albedo(const Material& material, double polar_light) {
    const glm::dvec3 light = direction(polar_light, 0);
    constexpr int steps = 600;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double polar = pi / 2 * (i + 0.5) / steps;
            const double azimuth = pi * (j + 0.5) / steps; // half of it: the other half is its mirror image
            sum +=
                reflectance(material, light, direction(polar, azimuth)) * std::cos(polar) * std::sin(polar);
        }
    return 2 * sum * (pi / 2 / steps) * (pi / steps);
}

Material grey_material(float diffuse, float specular, float shininess) {
    return {{diffuse, diffuse, diffuse}, {specular, specular, specular}, shininess};
}

TEST(Reflection, NoMaterialReflectsMoreThanItReceives) {
    for (const float shininess : {0.0F, 1.0F, 10.0F, 100.0F}) {
        const Material mirror = grey_material(0, 1, shininess);
        EXPECT_NEAR(albedo(mirror, 0), 1, 2e-4) << shininess;
        double before = 1.001;
        for (const double polar : {0.0, 0.4, 0.8, 1.2, 1.5}) {
            const double now = albedo(mirror, polar);
            EXPECT_LE(now, before) << shininess << " at " << polar;
            before = now + 1e-6;
        }
    }
    EXPECT_NEAR(albedo(grey_material(0.7F, 0, 5), 1), 0.7, 1e-3);
    EXPECT_NEAR(albedo(grey_material(0.6F, 0.4F, 50), 0), 1, 1e-3);
}

TEST(Reflection, LightAndViewerMayChangePlaces) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> number(0, 1);
    const Material material = grey_material(0.3F, 0.4F, 25);
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 a = direction(number(random) * pi / 2, number(random) * 2 * pi);
        const glm::dvec3 b = direction(number(random) * pi / 2, number(random) * 2 * pi);
        EXPECT_DOUBLE_EQ(reflectance(material, a, b), reflectance(material, b, a));
    }
}

TEST(FastMath, PowersAreGoodEnoughForColours) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<float> base(0, 1);
    for (const float exponent : {0.0F, 0.5F, 1.0F, 7.0F, 80.0F, 1000.0F, 10000.0F})
        for (int i = 0; i < 2000; ++i) {
            const float x = i == 0 ? 1.0F : i < 1000 ? base(random) : 1 - base(random) / exponent;
            if (x < 0) continue;
            EXPECT_NEAR(fast_power(x, exponent), std::pow(x, exponent),
                        2e-6 + 1e-6 * static_cast<double>(exponent))
                << x << '^' << exponent;
        }
    EXPECT_EQ(fast_power(0, 0), 1);
    EXPECT_NEAR(fast_power(0, 1), 0, 1e-29);
    EXPECT_NEAR(fast_power(0, 100), 0, 1e-37);
}

/// What Shader::shade is to compute, in doubles and one point at a time.
double expected_channel(const Lighting& lighting, std::size_t channel, const glm::dvec3& normal,
                        const glm::dvec3& view, bool is_outside) {
    const Material& material = is_outside ? lighting.outside : lighting.inside;
    double sum = lighting.ambient[channel] * material.diffuse[channel];
    for (const DirectionalLight& light : lighting.lights) {
        const glm::dvec3 l = glm::normalize(light.towards);
        const double cosine = std::max(0.0, glm::dot(normal, l));
        const double half_cosine = std::max(0.0, glm::dot(normal, glm::normalize(l + view)));
        sum += light.colour[channel] * cosine *
               reflectance_times_pi(material.diffuse[channel], material.specular[channel], material.shininess,
                                    half_cosine);
    }
    return sum;
}

glm::dvec3 random_direction(std::mt19937_64& random) {
    std::normal_distribution<double> number;
    return glm::normalize(glm::dvec3(number(random), number(random), number(random)));
}

TEST(Shader, AgreesWithTheFormula) {
    std::mt19937_64 random(5);
    Lighting lighting;
    lighting.lights = {{{1, 2, 3}, {0.8F, 0.7F, 0.6F}, 0}, {{-1, 0, 0.5}, {0.1F, 0.2F, 0.3F}, 0}};
    lighting.outside = {{0.6F, 0.3F, 0.1F}, {0.1F, 0.2F, 0.3F}, 30};
    lighting.inside = {{0.1F, 0.2F, 0.7F}, {0.05F, 0.05F, 0.05F}, 200};
    const Shader shader(lighting);
    const auto batch = std::make_unique<ShadingBatch>();
    for (const std::size_t count : {1U, 3U, 17U, 256U}) {
        std::vector<glm::dvec3> normals;
        std::vector<glm::dvec3> views;
        batch->count = count;
        for (std::size_t i = 0; i < count; ++i) {
            normals.push_back(random_direction(random));
            views.push_back(random_direction(random));
            for (int axis = 0; axis < 3; ++axis) {
                batch->normal[static_cast<std::size_t>(axis)][i] = static_cast<float>(7 * normals[i][axis]);
                batch->view[static_cast<std::size_t>(axis)][i] = static_cast<float>(3 * views[i][axis]);
            }
            batch->side[i] = static_cast<float>(i % 3) - 1;
            batch->openness[i] = 1;
        }
        orient(*batch);
        shader.shade(*batch);
        for (std::size_t i = 0; i < count; ++i) {
            const bool gradient_faces_viewer = glm::dot(normals[i], views[i]) >= 0;
            const bool is_outside = i % 3 == 1 ? gradient_faces_viewer : i % 3 == 2;
            const glm::dvec3 normal = gradient_faces_viewer ? normals[i] : -normals[i];
            for (std::size_t channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(batch->colour[channel][i],
                            expected_channel(lighting, channel, normal, views[i], is_outside), 2e-4);
        }
    }
}

TEST(Shader, ShadowsTakeLightAwayAndOcclusionTheAmbientPart) {
    Lighting lighting;
    lighting.lights = {{{0, 0, 1}, {1, 1, 1}, 0}};
    lighting.ambient = {0.25F, 0.25F, 0.25F};
    lighting.outside = grey_material(0.5F, 0, 1);
    const Shader shader(lighting);
    const auto batch = std::make_unique<ShadingBatch>();
    batch->count = 4;
    batch->visibility.resize(1);
    for (std::size_t i = 0; i < 4; ++i) {
        batch->normal[0][i] = batch->normal[1][i] = batch->view[0][i] = batch->view[1][i] = 0;
        batch->normal[2][i] = batch->view[2][i] = 1;
        batch->side[i] = 1;
        batch->visibility[0][i] = i % 2 == 0 ? 1.0F : 0.0F;
        batch->openness[i] = i < 2 ? 1.0F : 0.5F;
    }
    orient(*batch);
    shader.shade(*batch);
    EXPECT_NEAR(batch->colour[0][0], 0.5 + 0.125, 1e-6);
    EXPECT_NEAR(batch->colour[0][1], 0.125, 1e-6);
    EXPECT_NEAR(batch->colour[0][2], 0.5 + 0.0625, 1e-6);
    EXPECT_NEAR(batch->colour[0][3], 0.0625, 1e-6);
}

TEST(Lighting, ImproperOneIsRefused) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const Lighting good = default_lighting(Camera::perspective({}, 30));
    check_lighting(good);
    const auto expect_refused = [&](auto&& spoil) {
        Lighting bad = good;
        spoil(bad);
        EXPECT_THROW(check_lighting(bad), DomainError);
    };
    expect_refused([](Lighting& bad) { bad.lights[0].towards = {0, 0, 0}; });
    expect_refused([](Lighting& bad) { bad.lights[0].towards.x = std::numeric_limits<double>::infinity(); });
    expect_refused([](Lighting& bad) { bad.lights[0].angular_radius = -1; });
    expect_refused([](Lighting& bad) { bad.lights[0].angular_radius = 90; });
    expect_refused([](Lighting& bad) { bad.lights[0].colour[1] = -0.5F; });
    expect_refused([](Lighting& bad) { bad.background[2] = nan; });
    expect_refused([](Lighting& bad) { bad.ambient[0] = nan; });
    expect_refused([](Lighting& bad) { bad.inside.shininess = -1; });
    expect_refused([](Lighting& bad) { bad.outside.shininess = nan; });
    expect_refused([](Lighting& bad) { bad.outside.specular[0] = -1; });
}

TEST(Sampling, DirectionsAreDistributedAsSaid) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1, -2, -0.5));
    constexpr std::uint32_t count = 4096;
    const SamplePattern pattern(count);
    const SampleSet samples(pattern, 7, 1, 2, 3);
    const Frame frame(axis);
    const double least_cosine = std::cos(0.3);
    glm::dvec3 mean_in_cone(0);
    glm::dvec3 mean_on_rim(0);
    double mean_cosine = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 in_cone = frame.in_cone(least_cosine, samples[i]);
        EXPECT_NEAR(glm::length(in_cone), 1, 1e-12);
        EXPECT_GE(glm::dot(in_cone, axis), least_cosine - 1e-12);
        EXPECT_NEAR(glm::dot(frame.on_rim(least_cosine, samples[i]), axis), least_cosine, 1e-12);
        mean_in_cone += in_cone / static_cast<double>(count);
        mean_on_rim += frame.on_rim(least_cosine, samples[i]) / static_cast<double>(count);
        mean_cosine += glm::dot(frame.by_cosine(samples[i]), axis) / count;
    }
    // Uniform on a cap: the mean is the axis times the mean height. Cosine-weighted: ∫ 2 cos² sin = 2/3.
    EXPECT_LE(glm::length(mean_in_cone - axis * ((1 + least_cosine) / 2)), 2e-3);
    EXPECT_LE(glm::length(mean_on_rim - axis * least_cosine), 1e-9);
    EXPECT_NEAR(mean_cosine, 2.0 / 3, 2e-3);
}

TEST(Sampling, FramesAreRightHandedForEveryAxis) {
    std::mt19937_64 random(11);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 axis = i < 2 ? glm::dvec3(0, 0, 2 * i - 1) : random_direction(random);
        const Frame frame(axis);
        const glm::dvec3 first = frame.on_rim(0, {1, 0, 0});
        const glm::dvec3 second = frame.on_rim(0, {0, 1, 0});
        EXPECT_LE(glm::length(glm::cross(first, second) - axis), 1e-12);
        EXPECT_NEAR(glm::length(first), 1, 1e-12);
        EXPECT_NEAR(glm::dot(first, second), 0, 1e-12);
    }
}

TEST(Sampling, EverythingMatters) {
    const SamplePattern pattern(16);
    const auto first = [&](std::uint64_t seed, std::uint64_t column, std::uint64_t row,
                           std::uint64_t purpose) {
        const Sample sample = SampleSet(pattern, seed, column, row, purpose)[0];
        EXPECT_NEAR(sample.cosine * sample.cosine + sample.sine * sample.sine, 1, 1e-12);
        EXPECT_TRUE(sample.y >= 0 && sample.y < 1) << sample.y;
        return sample.cosine;
    };
    const double x = first(1, 2, 3, 4);
    EXPECT_EQ(x, first(1, 2, 3, 4));
    EXPECT_NE(x, first(2, 2, 3, 4));
    EXPECT_NE(x, first(1, 3, 3, 4));
    EXPECT_NE(x, first(1, 2, 4, 4));
    EXPECT_NE(x, first(1, 2, 3, 5));
    EXPECT_NE(first(1, 2, 3, 4), first(1, 3, 2, 4));
}

} // namespace
} // namespace eliminant::render
