// Rays go where the documented formulas say; impossible cameras are refused.
#include "eliminant/base/error.hpp"
#include "eliminant/render/camera.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace eliminant::render {
namespace {

constexpr double pi = std::numbers::pi;

/// Direction or origin of the ray of a pixel, straight from the definition.
glm::dvec3 offset_in(const Camera& camera, ImageSize size, double column, double row) {
    const double width = size.width;
    const double height = size.height;
    return camera.half_height() * ((2 * column + 1 - width) / height) * camera.right() +
           camera.half_height() * ((height - 1 - 2 * row) / height) * camera.up();
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-14) {
    EXPECT_LE(glm::length(a - b), tolerance * (1 + glm::length(b)));
}

TEST(Camera, FrameIsRightHandedAndOfUnitLength) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> number(-5, 5);
    const auto vector = [&] { return glm::dvec3(number(random), number(random), number(random)); };
    for (int i = 0; i < 200; ++i) {
        const Viewpoint viewpoint{vector(), vector(), vector()};
        const Camera camera = Camera::perspective(viewpoint, 40);
        expect_near(camera.forward(), glm::normalize(viewpoint.look_at - viewpoint.origin));
        expect_near(glm::cross(camera.right(), camera.up()), -camera.forward());
        EXPECT_NEAR(glm::length(camera.right()), 1, 1e-14);
        EXPECT_NEAR(glm::dot(camera.up(), camera.right()), 0, 1e-14);
        EXPECT_GT(glm::dot(camera.up(), viewpoint.up), 0);
    }
}

TEST(Camera, PerspectiveRaysFollowTheDefinition) {
    const ImageSize size{30, 20};
    const Camera camera = Camera::perspective({{1, 2, 3}, {-1, 0, 1}, {0, 1, 0}}, 30.219150244680932);
    EXPECT_NEAR(camera.half_height(), 0.27, 1e-16);
    const scene::RayGrid rays = camera.rays(size);
    EXPECT_EQ(rays.width, 30U);
    EXPECT_EQ(rays.height, 20U);
    for (int row = 0; row < 20; ++row)
        for (int column = 0; column < 30; ++column) {
            const scene::Ray ray = rays.ray(column, row);
            expect_near(ray.origin, {1, 2, 3}, 0);
            expect_near(ray.direction, camera.forward() + offset_in(camera, size, column, row));
        }
}

TEST(Camera, OrthographicRaysAreParallel) {
    const ImageSize size{7, 9};
    const Camera camera = Camera::orthographic({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}}, 4);
    const scene::RayGrid rays = camera.rays(size);
    for (int row = 0; row < 9; ++row)
        for (int column = 0; column < 7; ++column) {
            const scene::Ray ray = rays.ray(column, row);
            expect_near(ray.direction, {0, 0, -1}, 0);
            expect_near(ray.origin, glm::dvec3(0, 0, 5) + offset_in(camera, size, column, row));
        }
    // The top left: half a pixel inside of a height of 4 and a width of 4 · 7/9.
    expect_near(rays.ray(0, 0).origin, {-2 * 7.0 / 9 + 2.0 / 9, 2 - 2.0 / 9, 5});
}

TEST(Camera, ABorderContinuesTheGrid) {
    const ImageSize size{5, 4};
    const Camera camera = Camera::perspective({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}}, 50);
    const scene::RayGrid inner = camera.rays(size);
    const scene::RayGrid outer = camera.rays(size, 2);
    EXPECT_EQ(outer.width, 9U);
    EXPECT_EQ(outer.height, 8U);
    for (int row = -2; row < 6; ++row)
        for (int column = -2; column < 7; ++column)
            expect_near(outer.ray(column + 2, row + 2).direction, inner.ray(column, row).direction);
}

TEST(Camera, FinerGridsDivideThePixelsEvenly) {
    const Camera camera = Camera::perspective({{3, 1, 5}, {0, 0, 0}, {0, 1, 0}}, 50);
    const scene::RayGrid coarse = camera.rays({5, 4});
    for (const std::uint32_t n : {2U, 3U, 4U}) {
        const scene::RayGrid fine = camera.rays({5 * n, 4 * n});
        for (std::uint32_t column = 0; column < 5 * n; ++column) // offset (m + ½)/n − ½ of the pixel's middle
            expect_near(fine.ray(column, 0).direction,
                        coarse.ray((column + 0.5) / n - 0.5, 0.5 / n - 0.5).direction);
    }
}

TEST(Camera, ImpossibleOnesAreRefused) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Viewpoint good{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}};
    for (const Viewpoint& bad :
         {Viewpoint{{0, 0, 5}, {0, 0, 5}, {0, 1, 0}}, // looks at itself
          Viewpoint{{0, 0, 5}, {0, 0, 0}, {0, 0, 3}}, // up along the line of sight
          Viewpoint{{1, 1, 1}, {4, 4, 4}, {-0.1, -0.1, -0.1}}, Viewpoint{{0, 0, 5}, {0, 0, 0}, {0, 0, 0}},
          Viewpoint{{0, nan, 5}, {0, 0, 0}, {0, 1, 0}}, Viewpoint{{0, 0, 5}, {0, infinity, 0}, {0, 1, 0}},
          Viewpoint{{0, 0, 5}, {0, 0, 0}, {0, 1, -infinity}},
          Viewpoint{{0, 0, 1.7e308}, {0, 0, -1.7e308}, {0, 1, 0}}}) {
        EXPECT_THROW(Camera::perspective(bad, 40), DomainError);
        EXPECT_THROW(Camera::orthographic(bad, 2), DomainError);
    }
    for (const double degrees : {0.0, -1.0, 180.0, 270.0, nan, infinity})
        EXPECT_THROW(Camera::perspective(good, degrees), DomainError) << degrees;
    for (const double height : {0.0, -1.0, nan, infinity})
        EXPECT_THROW(Camera::orthographic(good, height), DomainError) << height;
}

TEST(Camera, ExtremeButPossibleOnesWork) {
    // Squares of these lengths overflow or underflow.
    for (const double scale : {1e-250, 1e-5, 1e200}) {
        const Camera camera = Camera::perspective({{0, 0, scale}, {0, 0, 0}, {0, scale, scale}}, 179);
        expect_near(camera.forward(), {0, 0, -1}, 1e-15);
        expect_near(camera.up(), {0, 1, 0}, 1e-15);
        EXPECT_NEAR(camera.half_height(), std::tan(89.5 * pi / 180), 1e-9);
    }
}

} // namespace
} // namespace eliminant::render
