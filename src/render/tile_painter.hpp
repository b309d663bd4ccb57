/// \file
/// One tile of a picture: its rays, its colours, and more rays where colours change.
#pragma once

#include "render/sample_painter.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace eliminant::render {

/// Paints the tiles of one picture; many threads may paint at the same time.
class TilePainter {
  public:
    /// What it is given must outlive it.
    TilePainter(const scene::Surface& surface, const Camera& camera, const scene::ClipRegion& clip,
                const Lighting& lighting, const RenderOptions& options, base::Run& run);

    /// Memory that calls reuse, one for each thread, and what they counted.
    struct Scratch {
        std::vector<scene::Hit> hits;
        std::vector<float> colours;
        std::vector<std::uint8_t> is_marked; ///< pixels of the tile to be refined
        std::vector<scene::Hit> fine_hits;
        std::vector<float> fine_colours;
        SamplePainter::Scratch samples;
        std::uint64_t rays = 0;
        std::uint64_t hit_count = 0;
        std::uint64_t refined_pixels = 0;
    };

    /// Where the pixels of a tile go: row r of the tile begins at colours + 3 · r · stride.
    struct Target {
        float* colours;
        double* depths;     ///< or null
        std::size_t stride; ///< pixels from one row to the next
    };
    /// \param tile in pixels of the picture
    void paint(const scene::Tile& tile, const Target& target, Scratch& scratch, base::Run& run) const;

    /// Sphere tracing's statistics, if that is how rays are traced.
    std::optional<SphereStatistics> stepping() const;

  private:
    /// A grid of rays and what finds their first hits.
    struct Sampling {
        scene::RayGrid rays;
        std::unique_ptr<const scene::GridTracer> tracer;
        const SphereTracer* stepper = nullptr; ///< the tracer, if it steps
    };
    Sampling make_sampling(const scene::RayGrid& rays, base::Run& run) const;
    void trace(const Sampling& sampling, const scene::Tile& tile, std::span<scene::Hit> hits,
               Scratch& scratch, base::Run& run) const;
    void sample_centres(const scene::Tile& tile, Scratch& scratch, base::Run& run) const;

    void paint_centres(const scene::Tile& tile, const Target& target, Scratch& scratch, base::Run& run) const;
    void paint_fully(const scene::Tile& tile, const Target& target, Scratch& scratch, base::Run& run) const;
    void paint_adaptively(const scene::Tile& tile, const Target& target, Scratch& scratch,
                          base::Run& run) const;
    void refine_marked(const scene::Tile& tile, const Target& target, Scratch& scratch, base::Run& run) const;
    void refine(const scene::Tile& tile, const scene::Tile& block, const Target& target, Scratch& scratch,
                base::Run& run) const;
    void average(const float* samples, std::size_t stride, float* colour) const;
    void copy_depths(const scene::Tile& tile, const Target& target, const scene::Tile& traced,
                     Scratch& scratch) const;

    const scene::Surface& surface_;
    const scene::ClipRegion& clip_;
    RenderOptions options_;
    SamplePainter painter_;
    std::size_t border_; ///< of centres_: pixels around the picture whose colours are compared, too
    Sampling centres_;   ///< a ray a pixel
    Sampling fine_;      ///< antialias² rays a pixel, if that is more than one
};

} // namespace eliminant::render
