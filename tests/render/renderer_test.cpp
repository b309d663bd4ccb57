// Whole pictures of spheres, whose every pixel is known.
#include "eliminant/base/error.hpp"
#include "eliminant/render/renderer.hpp"
#include "render/spheres.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace eliminant::render {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using test::Spheres;

const Viewpoint from_front{{0, 0, 6}, {0, 0, 0}, {0, 1, 0}};

scene::ClipRegion ball_of(double radius) {
    scene::ClipRegion clip;
    clip.add(scene::Ball{glm::dvec3(0), radius});
    return clip;
}

/// White light from the camera on a matt material, on blue.
Lighting head_light(const Camera& camera) {
    Lighting lighting;
    lighting.lights = {{-camera.forward(), {1, 1, 1}, 0}};
    lighting.ambient = {0, 0, 0};
    lighting.background = {0, 0, 0.5F};
    lighting.outside = {{0.8F, 0.4F, 0.2F}, {0, 0, 0}, 1};
    lighting.inside = {{0.1F, 0.2F, 0.9F}, {0, 0, 0}, 1};
    return lighting;
}

bool same(const Image& a, const Image& b) {
    const ImageRows x = a.rows();
    const ImageRows y = b.rows();
    return std::ranges::equal(x.colours, y.colours) && std::ranges::equal(x.depths, y.depths);
}

/// A scene with shadows, several tiles and bands of unequal size.
Image busy_image(unsigned threads, std::uint32_t antialias, bool adaptive, ImageSize size = {150, 97}) {
    const Spheres surface({{{0, 0, 0}, 1}, {{0.9, 0.9, 0.9}, 0.4}});
    const Camera camera = Camera::perspective(from_front, 30);
    Lighting lighting = default_lighting(camera);
    RenderOptions options;
    options.size = size;
    options.antialias = antialias;
    options.adaptive = adaptive;
    options.occlusion.shadows = true;
    options.occlusion.ambient_rays = 4;
    RunOptions run_options;
    run_options.threads = threads;
    run_options.seed = 5;
    base::Run run(run_options);
    return render_image(surface, camera, ball_of(2), lighting, options, run);
}

TEST(Renderer, EveryPixelOfASphereIsAsComputedByHand) {
    const Spheres surface({{{0, 0, 0}, 1}});
    const Camera camera = Camera::perspective(from_front, 30);
    const Lighting lighting = head_light(camera);
    RenderOptions options;
    options.size = {90, 70};
    base::Run run;
    const Image image = render_image(surface, camera, ball_of(2), lighting, options, run);
    const scene::RayGrid rays = camera.rays(options.size);
    for (std::uint32_t row = 0; row < 70; ++row)
        for (std::uint32_t column = 0; column < 90; ++column) {
            const scene::Ray ray = rays.ray(column, row);
            const scene::Hit hit = surface.first_hit(ray, {0, 100}, run);
            const Colour colour = image.colour(column, row);
            if (!hit) {
                EXPECT_EQ(colour, lighting.background);
                EXPECT_EQ(image.depth(column, row), infinity);
                continue;
            }
            EXPECT_DOUBLE_EQ(image.depth(column, row), glm::length(ray.at(hit.t) - camera.origin()));
            const double cosine = std::max(0.0, glm::normalize(ray.at(hit.t)).z);
            for (std::size_t channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(colour[channel], lighting.outside.diffuse[channel] * cosine, 1e-5);
        }
}

TEST(Renderer, TheInsideHasItsOwnColour) {
    // Cut open by the clip region, the near half of the sphere is gone.
    const Camera camera = Camera::perspective(from_front, 20);
    const Lighting lighting = head_light(camera);
    scene::ClipRegion clip = ball_of(2);
    clip.add(scene::HalfSpace{{0, 0, 1}, 0});
    RenderOptions options;
    options.size = {1, 1};
    base::Run run;
    for (const bool flipped : {false, true}) {
        const Spheres surface({{{0, 0, 0}, 1}}, flipped);
        const Image image = render_image(surface, camera, clip, lighting, options, run);
        EXPECT_NEAR(image.depth(0, 0), 7, 1e-12);
        const Material& seen = flipped ? lighting.outside : lighting.inside;
        for (std::size_t channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(image.colour(0, 0)[channel], seen.diffuse[channel], 1e-5);
    }
}

TEST(Renderer, ThreadsDoNotChangeThePicture) {
    for (const std::uint32_t antialias : {1U, 3U}) {
        const Image one = busy_image(1, antialias, true);
        EXPECT_TRUE(same(one, busy_image(2, antialias, true)));
        EXPECT_TRUE(same(one, busy_image(5, antialias, true)));
    }
}

TEST(Renderer, BandsOfAWidePictureFitTogether) {
    const Spheres surface({{{0, 0, 0}, 1}});
    const Camera camera = Camera::orthographic(from_front, 2.5);
    RenderOptions options;
    options.size = {9000, 200}; // bands of 64 rows
    base::Run run;
    std::uint32_t next = 0;
    std::size_t hits = 0;
    int bands = 0;
    options.depths = true;
    const RenderStatistics statistics =
        render(surface, camera, ball_of(2), head_light(camera), options, run, [&](const ImageRows& rows) {
            ++bands;
            EXPECT_EQ(rows.first, next);
            EXPECT_EQ(rows.colours.size(), 3U * 9000 * rows.count);
            EXPECT_EQ(rows.depths.size(), 9000U * rows.count);
            next += rows.count;
            hits += static_cast<std::size_t>(
                std::count_if(rows.depths.begin(), rows.depths.end(), [](double d) { return d < infinity; }));
        });
    EXPECT_EQ(next, 200U);
    EXPECT_EQ(bands, 4);
    EXPECT_EQ(statistics.hits, hits);
    EXPECT_EQ(statistics.rays, 9000U * 200);
    EXPECT_NEAR(static_cast<double>(hits), 3.14159265 * 80 * 80, 60); // a disc of radius 80 pixels
}

TEST(Renderer, FullSamplingAveragesThePixelsOfALargerPicture) {
    const Spheres surface({{{0.3, 0.1, 0}, 1}});
    const Camera camera = Camera::perspective(from_front, 30);
    const Lighting lighting = head_light(camera);
    base::Run run;
    for (const std::uint32_t n : {2U, 3U}) {
        RenderOptions fine;
        fine.size = {70 * n, 30 * n};
        const Image large = render_image(surface, camera, ball_of(2), lighting, fine, run);
        RenderOptions options;
        options.size = {70, 30};
        options.antialias = n;
        options.adaptive = false;
        const Image small = render_image(surface, camera, ball_of(2), lighting, options, run);
        for (std::uint32_t row = 0; row < 30; ++row)
            for (std::uint32_t column = 0; column < 70; ++column) {
                float sum = 0;
                for (std::uint32_t i = 0; i < n * n; ++i)
                    sum += large.colour(n * column + i % n, n * row + i / n)[0];
                EXPECT_NEAR(small.colour(column, row)[0], sum / static_cast<float>(n * n), 1e-5);
            }
    }
}

TEST(Renderer, AdaptiveSamplingDiffersInvisiblyFromFull) {
    const Image full = busy_image(1, 4, false);
    const Image adaptive = busy_image(1, 4, true);
    const Image none = busy_image(1, 1, true);
    EXPECT_TRUE(std::ranges::equal(full.rows().depths, none.rows().depths));
    for (std::size_t i = 0; i < full.rows().depths.size(); ++i) { // their grids begin at different pixels
        const double depth = full.rows().depths[i];
        EXPECT_TRUE(depth == adaptive.rows().depths[i] ||
                    std::abs(depth - adaptive.rows().depths[i]) < 1e-12);
    }
    double adaptive_error = 0;
    double unsampled_error = 0;
    for (std::size_t i = 0; i < full.rows().colours.size(); ++i) {
        const double exact = srgb_from_linear(std::min(1.0F, full.rows().colours[i]));
        const auto error = [&](const Image& image) {
            return std::abs(srgb_from_linear(std::min(1.0F, image.rows().colours[i])) - exact);
        };
        adaptive_error = std::max(adaptive_error, error(adaptive));
        unsampled_error = std::max(unsampled_error, error(none));
    }
    EXPECT_LT(adaptive_error, 0.08);
    EXPECT_GT(unsampled_error, 0.2); // or there was nothing to do
}

TEST(Renderer, ATurnedSceneLooksTheSame) {
    // Camera, lights, spheres and clip turn together.
    const auto turned = [](const glm::dvec3& v) { return glm::dvec3(v.z, v.x, v.y); };
    const std::vector<scene::Ball> balls{{{0, 0, 0}, 1}, {{0.8, 0.3, 1.1}, 0.3}};
    std::vector<scene::Ball> turned_balls;
    for (const scene::Ball& ball : balls) turned_balls.push_back({turned(ball.center), ball.radius});
    RenderOptions options;
    options.size = {60, 50};
    options.occlusion.shadows = true;
    base::Run run;
    const auto picture = [&](const std::vector<scene::Ball>& spheres, const Viewpoint& viewpoint) {
        const Camera camera = Camera::perspective(viewpoint, 28);
        Lighting lighting = default_lighting(camera);
        for (DirectionalLight& light : lighting.lights) light.angular_radius = 0;
        return render_image(Spheres(spheres), camera, ball_of(2), lighting, options, run);
    };
    const Image straight = picture(balls, {{1, 2, 6}, {0, 0, 0}, {0, 1, 0}});
    const Image around = picture(turned_balls, {turned({1, 2, 6}), {0, 0, 0}, turned({0, 1, 0})});
    int different = 0;
    for (std::uint32_t row = 0; row < 50; ++row)
        for (std::uint32_t column = 0; column < 60; ++column) {
            for (std::size_t channel = 0; channel < 3; ++channel)
                if (std::abs(straight.colour(column, row)[channel] - around.colour(column, row)[channel]) >
                    1e-4)
                    ++different;
        }
    EXPECT_LE(different, 3); // a shadow's edge may cross a pixel's centre
}

TEST(Renderer, ASphereShadowsWhatIsBehindIt) {
    // A small sphere between the light and the large one; the camera looks from the side.
    const Spheres surface({{{0, 0, 0}, 1}, {{0, 2, 0}, 0.3}});
    const Camera camera = Camera::perspective({{0, 3, 8}, {0, 1, 0}, {0, 1, 0}}, 50);
    Lighting lighting = head_light(camera);
    lighting.lights = {{{0, 1, 0}, {1, 1, 1}, 0}};
    RenderOptions options;
    options.size = {120, 120};
    options.occlusion.shadows = true;
    base::Run run;
    const Image image = render_image(surface, camera, ball_of(4), lighting, options, run);
    const scene::RayGrid rays = camera.rays(options.size);
    int shadowed = 0;
    for (std::uint32_t row = 0; row < 120; ++row)
        for (std::uint32_t column = 0; column < 120; ++column) {
            const scene::Ray ray = rays.ray(column, row);
            if (image.depth(column, row) == infinity) continue;
            const glm::dvec3 p = ray.at(image.depth(column, row) / glm::length(ray.direction));
            if (glm::length(p) > 1.001 || p.y < 0.01) continue; // on the small one, or turned away
            const double distance_to_axis = std::hypot(p.x, p.z);
            if (std::abs(distance_to_axis - 0.3) < 0.001) continue;
            const bool in_shadow = distance_to_axis < 0.3;
            shadowed += in_shadow ? 1 : 0;
            EXPECT_NEAR(image.colour(column, row)[0], in_shadow ? 0 : 0.8 * p.y, 1e-4);
        }
    EXPECT_GT(shadowed, 10);
}

TEST(Renderer, SoftShadowsHaveThePenumbraOfTheLight) {
    // In the middle of the shadow of a ball that looks half as large as the light, a quarter of its disc is
    // hidden.
    const Spheres surface({{{0, -100, 0}, 100}, {{0, 10, 0}, 10 * std::sin(0.1)}});
    const Camera camera = Camera::perspective({{0, 3, 0}, {0, 0, 0}, {0, 0, -1}}, 0.001);
    Lighting lighting = head_light(camera);
    lighting.lights = {{{0, 1, 0}, {1, 1, 1}, 0.2 * 180 / 3.14159265358979}};
    RenderOptions options;
    options.size = {4, 4};
    options.occlusion.shadows = true;
    options.occlusion.shadow_rays = 1024;
    base::Run run;
    const Image image = render_image(surface, camera, ball_of(30), lighting, options, run);
    const double hidden = (1 - std::cos(0.1)) / (1 - std::cos(0.2));
    for (std::uint32_t i = 0; i < 16; ++i)
        EXPECT_NEAR(image.colour(i % 4, i / 4)[0], 0.8 * (1 - hidden), 0.01);
}

TEST(Renderer, AmbientOcclusionIsTheOpenPartOfTheSky) {
    // At the touching plane of a sphere of angular radius a seen at the zenith, cosine-weighted: sin² a is
    // hidden.
    const Spheres surface({{{0, -1000, 0}, 1000}, {{0, 2, 0}, 1}});
    const Camera camera = Camera::perspective({{0, 0.5, 0}, {0, 0, 0}, {0, 0, -1}}, 0.001);
    Lighting lighting = head_light(camera);
    lighting.lights.clear();
    lighting.ambient = {1, 1, 1};
    RenderOptions options;
    options.size = {4, 4};
    options.occlusion.ambient_rays = 1024;
    options.occlusion.ambient_reach = 1;
    base::Run run;
    const Image image = render_image(surface, camera, ball_of(10), lighting, options, run);
    for (std::uint32_t i = 0; i < 16; ++i) EXPECT_NEAR(image.colour(i % 4, i / 4)[0], 0.8 * (1 - 0.25), 0.01);
}

TEST(Renderer, FalseColoursShowWhatTheySay) {
    const Spheres surface({{{0, 0, 0}, 1}});
    const Camera camera = Camera::orthographic(from_front, 2.2);
    RenderOptions options;
    options.size = {41, 41};
    base::Run run;
    const auto centre = [&](Colouring colouring, const Spheres& of) {
        options.colouring = colouring;
        return render_image(of, camera, ball_of(2), head_light(camera), options, run).colour(20, 20);
    };
    const Colour normal = centre(Colouring::normal, surface); // (0, 0, 1)
    EXPECT_NEAR(normal[0], linear_from_srgb(0.5), 1e-3);
    EXPECT_NEAR(normal[1], linear_from_srgb(0.5), 1e-3);
    EXPECT_NEAR(normal[2], 1, 1e-3);
    const Colour depth = centre(Colouring::depth, surface); // 5 of 4 … 8
    EXPECT_NEAR(depth[0], linear_from_srgb(0.75), 1e-5);
    const Colour outward = centre(Colouring::mean_curvature, surface);
    const Colour inward = centre(Colouring::mean_curvature, Spheres({{{0, 0, 0}, 1}}, true));
    EXPECT_GT(outward[0], outward[2]);
    EXPECT_LT(inward[0], inward[2]);
    EXPECT_EQ(centre(Colouring::gaussian_curvature, surface),
              centre(Colouring::gaussian_curvature, Spheres({{{0, 0, 0}, 1}}, true)));
}

TEST(Renderer, ImproperOptionsAreRefused) {
    const Spheres surface({{{0, 0, 0}, 1}});
    const Camera camera = Camera::perspective(from_front, 30);
    base::Run run;
    const auto expect_refused = [&](auto&& spoil, const scene::ClipRegion& clip = ball_of(2)) {
        RenderOptions bad;
        bad.size = {8, 8};
        spoil(bad);
        EXPECT_THROW(render(surface, camera, clip, head_light(camera), bad, run, [](const ImageRows&) {}),
                     DomainError);
    };
    expect_refused([](RenderOptions& bad) { bad.size.width = 0; });
    expect_refused([](RenderOptions& bad) { bad.antialias = 0; });
    expect_refused([](RenderOptions& bad) { bad.antialias = 17; });
    expect_refused([](RenderOptions& bad) { bad.occlusion.shadow_rays = 0; });
    expect_refused([](RenderOptions& bad) { bad.occlusion.ambient_rays = 1025; });
    expect_refused([](RenderOptions& bad) { bad.occlusion.ambient_reach = 0; });
    expect_refused([](RenderOptions& bad) {
        bad.sphere_tracing = SphereTracing{field::DistanceLevel{}, 2.0, 100};
    });
    expect_refused([](RenderOptions&) {}, scene::ClipRegion{}); // all of space
}

TEST(Renderer, StopsWhenAskedAndPassesOnWhatTheSinkThrows) {
    const Spheres surface({{{0, 0, 0}, 1}});
    const Camera camera = Camera::perspective(from_front, 30);
    const Lighting lighting = head_light(camera);
    RenderOptions options;
    options.size = {2000, 2000};
    base::Run run;
    EXPECT_THROW(render(surface, camera, ball_of(2), lighting, options, run,
                        [&](const ImageRows&) { run.request_stop(); }),
                 Stopped);
    struct Full {};
    base::Run another;
    EXPECT_THROW(render(surface, camera, ball_of(2), lighting, options, another,
                        [&](const ImageRows&) { throw Full{}; }),
                 Full);
}

TEST(Renderer, ReportsTilesAsProgress) {
    const Spheres surface({{{0, 0, 0}, 1}});
    const Camera camera = Camera::perspective(from_front, 30);
    std::uint64_t reports = 0;
    std::uint64_t last_done = 0;
    std::uint64_t total = 0;
    RunOptions run_options;
    run_options.progress_interval = std::chrono::milliseconds(0);
    run_options.progress = [&](const Progress& progress) {
        ++reports;
        last_done = progress.done;
        total = progress.total;
    };
    base::Run run(run_options);
    RenderOptions options;
    options.size = {200, 100};
    render_image(surface, camera, ball_of(2), head_light(camera), options, run);
    EXPECT_EQ(total, 8U);
    EXPECT_EQ(reports, 8U);
    EXPECT_EQ(last_done, 8U);
}

TEST(Renderer, FramingHasAllOfTheBallInView) {
    const scene::Ball ball{{3, -2, 5}, 4};
    const Spheres surface({ball});
    base::Run run;
    for (const ImageSize size : {ImageSize{64, 64}, ImageSize{100, 40}, ImageSize{40, 100}}) {
        const Camera camera = framing_camera(ball, size, 35);
        scene::ClipRegion clip;
        clip.add(scene::Ball{ball.center, 5});
        RenderOptions options;
        options.size = size;
        const Image image = render_image(surface, camera, clip, head_light(camera), options, run);
        std::uint32_t widest = 0;
        for (std::uint32_t row = 0; row < size.height; ++row) {
            std::uint32_t width = 0;
            for (std::uint32_t column = 0; column < size.width; ++column) {
                if (image.depth(column, row) == infinity) continue;
                ++width;
                EXPECT_TRUE(column > 0 && column + 1 < size.width && row > 0 && row + 1 < size.height);
            }
            widest = std::max(widest, width);
        }
        EXPECT_GT(widest, 0.85 * std::min(size.width, size.height));
    }
}

} // namespace
} // namespace eliminant::render
