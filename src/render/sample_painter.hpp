/// \file
/// From hits to colours.
#pragma once

#include "eliminant/render/renderer.hpp"
#include "render/occlusion.hpp"
#include "render/shading.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::render {

/// Finds the colours of samples: by lights and materials, or a false colour.
class SamplePainter {
  public:
    /// What it is given must outlive it.
    SamplePainter(const scene::Surface& surface, const Camera& camera, const scene::ClipRegion& clip,
                  const Lighting& lighting, const RenderOptions& options, std::uint64_t seed);

    /// Memory that calls reuse, one for each thread, and what they counted.
    struct Scratch {
        ShadingBatch batch;
        std::array<std::size_t, ShadingBatch::capacity> sample; ///< whose the points of the batch are
        std::vector<OcclusionProbe::Place> places;
        OcclusionProbe::Scratch occlusion;
    };

    /// How many samples a pixel has. Where it has n × n, each sends only its share of the rays for shadows
    /// and occlusion.
    enum class Density : unsigned char { single, several };

    /// The colours of the rays of a tile, given their hits; 3 · tile.size() floats.
    void paint(Density density, const scene::RayGrid& rays, const scene::Tile& tile,
               std::span<const scene::Hit> hits, std::span<float> colours, Scratch& scratch,
               base::Run& run) const;

  private:
    struct Samples; // the arguments of paint
    void paint_batch(const Samples& samples, Scratch& scratch, base::Run& run) const;
    void occlude(const Samples& samples, Scratch& scratch, base::Run& run) const;
    Colour false_colour(const Samples& samples, const ShadingBatch& batch, std::size_t i,
                        std::size_t sample) const;

    const scene::Surface& surface_;
    Colour background_;
    std::size_t light_count_;
    Colouring colouring_;
    Shader shader_;
    OcclusionProbe probe_;
    OcclusionProbe share_probe_; ///< for one of several samples
    double near_;                ///< depths of the ends of the clip region's bounding ball
    double far_;
    double radius_; ///< of that ball
};

} // namespace eliminant::render
