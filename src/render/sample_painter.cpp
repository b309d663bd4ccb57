#include "render/sample_painter.hpp"

#include "render/false_colours.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace eliminant::render {
namespace {

glm::dvec3 vector_at(const std::array<ShadingBatch::Floats, 3>& vectors, std::size_t i) {
    return {vectors[0][i], vectors[1][i], vectors[2][i]};
}

void put(std::array<ShadingBatch::Floats, 3>& vectors, std::size_t i, const glm::dvec3& v) {
    vectors[0][i] = static_cast<float>(v.x);
    vectors[1][i] = static_cast<float>(v.y);
    vectors[2][i] = static_cast<float>(v.z);
}

double largest_part(const glm::dvec3& v) {
    return std::max(std::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z));
}

/// The rays of one of n × n samples.
Occlusion share_of(Occlusion all, std::uint32_t n) {
    const auto share = [&](std::uint32_t rays) { return (rays + n * n - 1) / (n * n); };
    all.shadow_rays = share(all.shadow_rays);
    all.ambient_rays = share(all.ambient_rays);
    return all;
}

} // namespace

struct SamplePainter::Samples {
    const OcclusionProbe& probe;
    const scene::RayGrid& rays;
    const scene::Tile& tile;
    std::span<const scene::Hit> hits;
    std::span<float> colours;

    double column(std::size_t sample) const { return static_cast<double>(tile.column + sample % tile.width); }
    double row(std::size_t sample) const {
        const std::size_t rows_above = sample / tile.width;
        return static_cast<double>(tile.row + rows_above);
    }
    scene::Ray ray(std::size_t sample) const { return rays.ray(column(sample), row(sample)); }
    void set(std::size_t sample, const Colour& colour) const {
        std::copy(colour.begin(), colour.end(), &colours[3 * sample]);
    }
};

SamplePainter::SamplePainter(const scene::Surface& surface, const Camera& camera,
                             const scene::ClipRegion& clip, const Lighting& lighting,
                             const RenderOptions& options, std::uint64_t seed)
    : surface_(surface), background_(lighting.background), light_count_(lighting.lights.size()),
      colouring_(options.colouring), shader_(lighting),
      probe_(surface, clip, lighting, options.occlusion, seed),
      share_probe_(surface, clip, lighting, share_of(options.occlusion, options.antialias), seed) {
    const scene::Ball ball = clip.bounding_ball().value_or(scene::Ball{});
    const glm::dvec3 to_ball = ball.center - camera.origin();
    const double middle =
        camera.is_perspective() ? glm::length(to_ball) : glm::dot(to_ball, camera.forward());
    radius_ = ball.radius;
    near_ = std::max(0.0, middle - radius_);
    far_ = std::max(near_, middle + radius_);
}

void SamplePainter::paint(Density density, const scene::RayGrid& rays, const scene::Tile& tile,
                          std::span<const scene::Hit> hits, std::span<float> colours, Scratch& scratch,
                          base::Run& run) const {
    const Samples samples{density == Density::single ? probe_ : share_probe_, rays, tile, hits, colours};
    ShadingBatch& batch = scratch.batch;
    batch.count = 0;
    std::size_t sample = 0;
    for (std::size_t row = 0; row < tile.height; ++row) {
        const scene::Ray first =
            rays.ray(static_cast<double>(tile.column), static_cast<double>(tile.row + row));
        for (std::size_t column = 0; column < tile.width; ++column, ++sample) {
            const scene::Hit& hit = hits[sample];
            if (!hit) {
                samples.set(sample, background_);
                continue;
            }
            const glm::dvec3 view = -first.direction - static_cast<double>(column) * rays.direction_dx;
            // Coefficients may be of any size, floats may not.
            const double scale = 1 / largest_part(hit.gradient);
            const bool has_normal = scale > 0 && std::isfinite(scale);
            const std::size_t i = batch.count++;
            scratch.sample[i] = sample;
            put(batch.view, i, view);
            put(batch.normal, i, has_normal ? scale * hit.gradient : view);
            batch.side[i] = hit.side;
            if (batch.count == ShadingBatch::capacity) paint_batch(samples, scratch, run);
        }
    }
    paint_batch(samples, scratch, run);
}

void SamplePainter::paint_batch(const Samples& samples, Scratch& scratch, base::Run& run) const {
    ShadingBatch& batch = scratch.batch;
    orient(batch);
    if (colouring_ == Colouring::material) {
        std::fill_n(batch.openness.begin(), batch.count, 1.0F);
        if (samples.probe.has_shadows() || samples.probe.has_ambient()) occlude(samples, scratch, run);
        shader_.shade(batch);
        for (std::size_t i = 0; i < batch.count; ++i)
            samples.set(scratch.sample[i], {batch.colour[0][i], batch.colour[1][i], batch.colour[2][i]});
    } else {
        for (std::size_t i = 0; i < batch.count; ++i)
            samples.set(scratch.sample[i], false_colour(samples, batch, i, scratch.sample[i]));
    }
    batch.count = 0;
}

void SamplePainter::occlude(const Samples& samples, Scratch& scratch, base::Run& run) const {
    ShadingBatch& batch = scratch.batch;
    scratch.places.clear();
    for (std::size_t i = 0; i < batch.count; ++i) {
        const std::size_t sample = scratch.sample[i];
        scratch.places.push_back({samples.ray(sample).at(samples.hits[sample].t),
                                  glm::normalize(vector_at(batch.normal, i)),
                                  samples.tile.column + sample % samples.tile.width,
                                  samples.tile.row + sample / samples.tile.width});
    }
    if (samples.probe.has_shadows()) {
        batch.visibility.resize(light_count_);
        for (std::size_t light = 0; light < light_count_; ++light)
            samples.probe.visibility(scratch.places, light,
                                     std::span(batch.visibility[light]).first(batch.count), scratch.occlusion,
                                     run);
    }
    if (samples.probe.has_ambient())
        samples.probe.openness(scratch.places, std::span(batch.openness).first(batch.count),
                               scratch.occlusion, run);
}

Colour SamplePainter::false_colour(const Samples& samples, const ShadingBatch& batch, std::size_t i,
                                   std::size_t sample) const {
    const scene::Hit& hit = samples.hits[sample];
    const scene::Ray ray = samples.ray(sample);
    switch (colouring_) {
    case Colouring::normal:
        return normal_colour(vector_at(batch.normal, i));
    case Colouring::depth:
        return depth_colour((hit.t * glm::length(ray.direction) - near_) / (far_ - near_));
    case Colouring::steps:
        return heat_colour(hit.steps / 255.0);
    case Colouring::mean_curvature:
        return signed_colour(surface_.curvature(ray.at(hit.t)).mean * radius_);
    case Colouring::gaussian_curvature:
        return signed_colour(surface_.curvature(ray.at(hit.t)).gaussian * radius_ * radius_);
    case Colouring::material:
        break;
    }
    return background_;
}

} // namespace eliminant::render
