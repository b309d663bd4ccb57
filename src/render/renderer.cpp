#include "eliminant/render/renderer.hpp"

#include "base/parallel.hpp"
#include "eliminant/base/error.hpp"
#include "render/tile_painter.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace eliminant::render {
namespace {

constexpr std::uint32_t tile_side = 64;

/// A band has about so many pixels: enough tiles for many threads, and 12 MB of colours.
constexpr std::size_t band_pixels = std::size_t{1} << 20;

void check_number(std::uint32_t value, std::uint32_t least, std::uint32_t most, const char* of) {
    if (value < least || value > most)
        throw DomainError("rendering: expected " + std::string(of) + " from " + std::to_string(least) +
                          " to " + std::to_string(most) + ", found " + std::to_string(value));
}

void check_options(const RenderOptions& options, const scene::ClipRegion& clip) {
    constexpr std::uint32_t most_antialias = 16;
    constexpr std::uint32_t most_rays = 1024;
    check_size(options.size);
    check_number(options.antialias, 1, most_antialias, "a number of samples along a pixel's side");
    check_number(options.occlusion.shadow_rays, 1, most_rays, "a number of rays for a soft shadow");
    check_number(options.occlusion.ambient_rays, 0, most_rays, "a number of rays for ambient occlusion");
    const double reach = options.occlusion.ambient_reach;
    if (!(reach > 0 && std::isfinite(reach)))
        throw DomainError("rendering: expected a positive reach of ambient occlusion, found " +
                          std::to_string(reach));
    if (!clip.bounding_ball())
        throw DomainError("rendering: expected a bounded clip region, found an unbounded one");
}

/// How a picture is cut: bands of complete rows, cut into tiles.
struct Layout {
    ImageSize size;
    std::uint32_t band_rows;

    explicit Layout(ImageSize picture) : size(picture) {
        const std::size_t tiles = std::max<std::size_t>(1, band_pixels / tile_side / size.width);
        band_rows = static_cast<std::uint32_t>(std::min<std::size_t>(tiles * tile_side, size.height));
    }

    std::uint32_t bands() const { return (size.height + band_rows - 1) / band_rows; }
    std::uint32_t first_row(std::uint32_t band) const { return band * band_rows; }
    std::uint32_t rows(std::uint32_t band) const {
        return std::min(band_rows, size.height - first_row(band));
    }
    std::uint32_t tiles_across() const { return (size.width + tile_side - 1) / tile_side; }
    std::uint32_t tiles(std::uint32_t band) const {
        return tiles_across() * ((rows(band) + tile_side - 1) / tile_side);
    }
    std::uint64_t all_tiles() const {
        std::uint64_t sum = 0;
        for (std::uint32_t band = 0; band < bands(); ++band) sum += tiles(band);
        return sum;
    }
    /// A tile of a band, in pixels of the picture.
    scene::Tile tile(std::uint32_t band, std::uint32_t index) const {
        const std::size_t column = std::size_t{index % tiles_across()} * tile_side;
        const std::size_t row = std::size_t{index / tiles_across()} * tile_side;
        return {column, first_row(band) + row, std::min<std::size_t>(tile_side, size.width - column),
                std::min<std::size_t>(tile_side, rows(band) - row)};
    }
};

/// The rows of a band, in memory of their own.
class Band {
  public:
    Band(const Layout& layout, bool has_depths)
        : width_(layout.size.width), colours_(3 * std::size_t{layout.size.width} * layout.band_rows),
          depths_(has_depths ? std::size_t{layout.size.width} * layout.band_rows : 0) {}

    void begin(std::uint32_t first, std::uint32_t count) {
        first_ = first;
        count_ = count;
    }
    TilePainter::Target target(const scene::Tile& tile) {
        const std::size_t begin = (tile.row - first_) * width_ + tile.column;
        return {&colours_[3 * begin], depths_.empty() ? nullptr : &depths_[begin], width_};
    }
    ImageRows rows() const {
        const std::size_t pixels = std::size_t{width_} * count_;
        const std::span<const double> depths(depths_);
        return {width_, first_, count_, std::span(colours_).first(3 * pixels),
                depths.first(std::min(pixels, depths.size()))};
    }

  private:
    std::uint32_t width_;
    std::uint32_t first_ = 0;
    std::uint32_t count_ = 0;
    std::vector<float> colours_;
    std::vector<double> depths_;
};

} // namespace

RenderStatistics render(const scene::Surface& surface, const Camera& camera, const scene::ClipRegion& clip,
                        const Lighting& lighting, const RenderOptions& options, base::Run& run,
                        const RowSink& sink) {
    check_options(options, clip);
    check_lighting(lighting);
    const TilePainter painter(surface, camera, clip, lighting, options, run);
    const Layout layout(options.size);
    const std::uint64_t all_tiles = layout.all_tiles();
    std::vector<std::unique_ptr<TilePainter::Scratch>> scratch(run.threads());
    std::atomic<std::uint64_t> tiles_done{0};

    // While a band is painted, one of the threads delivers the band before: two bands take turns.
    std::vector<Band> bands(std::min(layout.bands(), 2U), Band(layout, options.depths));
    const auto paint = [&](std::uint32_t band, std::uint32_t index, std::size_t worker) {
        if (!scratch[worker]) scratch[worker] = std::make_unique<TilePainter::Scratch>();
        const scene::Tile tile = layout.tile(band, index);
        painter.paint(tile, bands[band % 2].target(tile), *scratch[worker], run);
        const std::uint64_t done = tiles_done.fetch_add(1, std::memory_order_relaxed) + 1;
        run.report([&] { return Progress{"picture", done, all_tiles, {}}; });
    };
    for (std::uint32_t band = 0; band < layout.bands(); ++band) {
        bands[band % 2].begin(layout.first_row(band), layout.rows(band));
        base::parallel_for(run, layout.tiles(band) + std::size_t{1},
                           [&](std::size_t item, std::size_t worker) {
                               if (item > 0)
                                   paint(band, static_cast<std::uint32_t>(item - 1), worker);
                               else if (band > 0)
                                   sink(bands[(band - 1) % 2].rows());
                           });
    }
    sink(bands[(layout.bands() - 1) % 2].rows());

    RenderStatistics statistics;
    for (const auto& part : scratch) {
        if (!part) continue;
        statistics.rays += part->rays;
        statistics.hits += part->hit_count;
        statistics.occlusion_rays += part->samples.occlusion.rays;
        statistics.refined_pixels += part->refined_pixels;
    }
    statistics.stepping = painter.stepping();
    return statistics;
}

Image render_image(const scene::Surface& surface, const Camera& camera, const scene::ClipRegion& clip,
                   const Lighting& lighting, RenderOptions options, base::Run& run) {
    check_size(options.size);
    Image image(options.size);
    options.depths = true;
    render(surface, camera, clip, lighting, options, run, [&](const ImageRows& rows) { image.assign(rows); });
    return image;
}

Camera framing_camera(const scene::Ball& ball, ImageSize size, double vertical_degrees) {
    // From the front, a little from the right and from above, as solids are usually drawn.
    const glm::dvec3 from = glm::normalize(glm::dvec3(0.45, 0.38, 1.0));
    check_size(size);
    const double aspect = static_cast<double>(size.width) / size.height;
    const double vertical = std::tan(vertical_degrees * (std::numbers::pi / 360));
    // The ball touches the narrower pair of sides of the view when sin(half angle) = radius / distance.
    const double half_angle = std::atan(vertical * std::min(1.0, aspect));
    constexpr double margin = 1.03;
    const double radius = ball.radius > 0 ? ball.radius : 1;
    const double distance = margin * radius / std::sin(half_angle);
    return Camera::perspective({ball.center + distance * from, ball.center, {0, 1, 0}}, vertical_degrees);
}

} // namespace eliminant::render
