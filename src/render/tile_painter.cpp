#include "render/tile_painter.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace eliminant::render {
namespace {

/// Colours that differ by more than this in a channel are told apart, in the square roots of linear values,
/// about as they are stored: 8 of 255.
constexpr float visible_difference = 8.0F / 255;

/// As bright as the screen shows it, on a scale that is roughly even for the eye.
float perceived(float linear) { return std::sqrt(std::clamp(linear, 0.0F, 1.0F)); }

/// Colours of the pixels of a tile and its border of one pixel.
class BorderedColours {
  public:
    /// Replaces the colours by perceived ones.
    BorderedColours(std::span<float> colours, std::size_t width) : colours_(colours), width_(width) {
        for (float& value : colours_) value = perceived(value);
    }

    /// Whether a pixel differs from one of its eight neighbours; counted with the border.
    bool is_edge(std::size_t column, std::size_t row) const {
        for (std::size_t r = row - 1; r <= row + 1; ++r)
            for (std::size_t c = column - 1; c <= column + 1; ++c)
                if (differ(c, r, column, row)) return true;
        return false;
    }

  private:
    const float* at(std::size_t column, std::size_t row) const {
        return &colours_[3 * (row * width_ + column)];
    }
    bool differ(std::size_t c1, std::size_t r1, std::size_t c2, std::size_t r2) const {
        const float* a = at(c1, r1);
        const float* b = at(c2, r2);
        const float difference =
            std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
        return difference > visible_difference;
    }

    std::span<float> colours_;
    std::size_t width_;
};

} // namespace

TilePainter::TilePainter(const scene::Surface& surface, const Camera& camera, const scene::ClipRegion& clip,
                         const Lighting& lighting, const RenderOptions& options, base::Run& run)
    : surface_(surface), clip_(clip), options_(options),
      painter_(surface, camera, clip, lighting, options, run.seed()),
      border_(options.antialias > 1 && options.adaptive ? 1 : 0) {
    const std::uint32_t n = options.antialias;
    const bool needs_centres = n == 1 || options.adaptive || options.depths;
    if (needs_centres)
        centres_ = make_sampling(camera.rays(options.size, static_cast<std::uint32_t>(border_)), run);
    if (n > 1) fine_ = make_sampling(camera.rays({n * options.size.width, n * options.size.height}), run);
}

TilePainter::Sampling TilePainter::make_sampling(const scene::RayGrid& rays, base::Run& run) const {
    Sampling sampling{rays, nullptr, nullptr};
    if (options_.sphere_tracing) {
        auto stepper = std::make_unique<SphereTracer>(surface_, rays, clip_, *options_.sphere_tracing);
        sampling.stepper = stepper.get();
        sampling.tracer = std::move(stepper);
    } else {
        sampling.tracer = surface_.tracer(rays, clip_, run);
    }
    return sampling;
}

void TilePainter::paint(const scene::Tile& tile, const Target& target, Scratch& scratch,
                        base::Run& run) const {
    if (options_.antialias == 1)
        paint_centres(tile, target, scratch, run);
    else if (options_.adaptive)
        paint_adaptively(tile, target, scratch, run);
    else
        paint_fully(tile, target, scratch, run);
}

void TilePainter::trace(const Sampling& sampling, const scene::Tile& tile, std::span<scene::Hit> hits,
                        Scratch& scratch, base::Run& run) const {
    sampling.tracer->trace(tile, hits, run);
    scratch.rays += tile.size();
    scratch.hit_count += static_cast<std::uint64_t>(std::count_if(
        hits.begin(), hits.end(), [](const scene::Hit& hit) { return static_cast<bool>(hit); }));
}

void TilePainter::sample_centres(const scene::Tile& tile, Scratch& scratch, base::Run& run) const {
    scratch.hits.resize(tile.size());
    scratch.colours.resize(3 * tile.size());
    trace(centres_, tile, scratch.hits, scratch, run);
    painter_.paint(SamplePainter::Density::single, centres_.rays, tile, scratch.hits, scratch.colours,
                   scratch.samples, run);
}

void TilePainter::copy_depths(const scene::Tile& tile, const Target& target, const scene::Tile& traced,
                              Scratch& scratch) const {
    if (target.depths == nullptr) return;
    for (std::size_t row = 0; row < tile.height; ++row)
        for (std::size_t column = 0; column < tile.width; ++column) {
            const scene::Hit& hit = scratch.hits[(row + border_) * traced.width + column + border_];
            const scene::Ray ray = centres_.rays.ray(static_cast<double>(traced.column + column + border_),
                                                     static_cast<double>(traced.row + row + border_));
            target.depths[row * target.stride + column] = hit.t * glm::length(ray.direction);
        }
}

void TilePainter::paint_centres(const scene::Tile& tile, const Target& target, Scratch& scratch,
                                base::Run& run) const {
    sample_centres(tile, scratch, run);
    for (std::size_t row = 0; row < tile.height; ++row)
        std::copy_n(&scratch.colours[3 * row * tile.width], 3 * tile.width,
                    target.colours + 3 * row * target.stride);
    copy_depths(tile, target, tile, scratch);
}

void TilePainter::paint_fully(const scene::Tile& tile, const Target& target, Scratch& scratch,
                              base::Run& run) const {
    scratch.is_marked.assign(tile.size(), 1);
    refine_marked(tile, target, scratch, run);
    if (target.depths == nullptr) return;
    scratch.hits.resize(tile.size());
    trace(centres_, tile, scratch.hits, scratch, run);
    copy_depths(tile, target, tile, scratch);
}

void TilePainter::paint_adaptively(const scene::Tile& tile, const Target& target, Scratch& scratch,
                                   base::Run& run) const {
    // In the grid of centres, which has the border, the tile and its own border begin at the tile's numbers.
    const scene::Tile traced{tile.column, tile.row, tile.width + 2, tile.height + 2};
    sample_centres(traced, scratch, run);
    for (std::size_t row = 0; row < tile.height; ++row)
        std::copy_n(&scratch.colours[3 * ((row + 1) * traced.width + 1)], 3 * tile.width,
                    target.colours + 3 * row * target.stride);
    copy_depths(tile, target, traced, scratch);

    const BorderedColours seen(scratch.colours, traced.width);
    scratch.is_marked.resize(tile.size());
    for (std::size_t i = 0; i < tile.size(); ++i)
        scratch.is_marked[i] = seen.is_edge(i % tile.width + 1, i / tile.width + 1) ? 1 : 0;
    refine_marked(tile, target, scratch, run);
}

/// All marked pixels of a tile, block by block.
///
/// Blocks of about 32 × 32 rays: where many pixels are marked, tracing the others, too, is cheaper than
/// tracing the marked ones singly (a quarter of the time for Barth's sextic with n = 4).
void TilePainter::refine_marked(const scene::Tile& tile, const Target& target, Scratch& scratch,
                                base::Run& run) const {
    const std::size_t side = std::max(std::size_t{1}, std::size_t{32} / options_.antialias);
    for (std::size_t row = 0; row < tile.height; row += side)
        for (std::size_t column = 0; column < tile.width; column += side)
            refine(tile,
                   {column, row, std::min(side, tile.width - column), std::min(side, tile.height - row)},
                   target, scratch, run);
}

/// The marked pixels of a block by n × n samples each, all of equal weight.
void TilePainter::refine(const scene::Tile& tile, const scene::Tile& block, const Target& target,
                         Scratch& scratch, base::Run& run) const {
    const std::size_t n = options_.antialias;
    const auto is_marked = [&](std::size_t column, std::size_t row) {
        return scratch.is_marked[(block.row + row) * tile.width + block.column + column] != 0;
    };
    std::size_t marked = 0;
    for (std::size_t i = 0; i < block.size(); ++i)
        marked += is_marked(i % block.width, i / block.width) ? 1 : 0;
    if (marked == 0) return;
    scratch.refined_pixels += marked;

    const scene::Tile fine{n * (tile.column + block.column), n * (tile.row + block.row), n * block.width,
                           n * block.height};
    scratch.fine_hits.resize(fine.size());
    scratch.fine_colours.resize(3 * fine.size());
    trace(fine_, fine, scratch.fine_hits, scratch, run);
    // What is not marked need not be painted.
    for (std::size_t i = 0; i < fine.size(); ++i)
        if (!is_marked(i % fine.width / n, i / fine.width / n)) scratch.fine_hits[i] = {};
    painter_.paint(SamplePainter::Density::several, fine_.rays, fine, scratch.fine_hits, scratch.fine_colours,
                   scratch.samples, run);

    for (std::size_t row = 0; row < block.height; ++row)
        for (std::size_t column = 0; column < block.width; ++column)
            if (is_marked(column, row))
                average(&scratch.fine_colours[3 * (row * n * fine.width + column * n)], fine.width,
                        target.colours + 3 * ((block.row + row) * target.stride + block.column + column));
}

/// The mean of n × n samples, of which the first is given.
void TilePainter::average(const float* samples, std::size_t stride, float* colour) const {
    const std::size_t n = options_.antialias;
    const float weight = 1 / static_cast<float>(n * n);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        float sum = 0;
        for (std::size_t row = 0; row < n; ++row)
            for (std::size_t column = 0; column < n; ++column)
                sum += samples[3 * (row * stride + column) + channel];
        colour[channel] = weight * sum;
    }
}

std::optional<SphereStatistics> TilePainter::stepping() const {
    std::optional<SphereStatistics> sum;
    for (const Sampling* sampling : {&centres_, &fine_}) {
        if (sampling->stepper == nullptr) continue;
        if (!sum) sum.emplace();
        const SphereStatistics seen = sampling->stepper->statistics();
        sum->rays += seen.rays;
        sum->steps += seen.steps;
        sum->back_steps += seen.back_steps;
        sum->left += seen.left;
        sum->came_near += seen.came_near;
        sum->ran_out += seen.ran_out;
    }
    return sum;
}

} // namespace eliminant::render
