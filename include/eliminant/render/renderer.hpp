/// \file
/// From a surface, a camera and lights to a picture.
#pragma once

#include "eliminant/base/run.hpp"
#include "eliminant/render/camera.hpp"
#include "eliminant/render/image.hpp"
#include "eliminant/render/lighting.hpp"
#include "eliminant/render/sphere_tracer.hpp"
#include "eliminant/scene/clip_region.hpp"
#include "eliminant/scene/surface.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace eliminant::render {

/// What the colours of a picture mean.
enum class Colouring : unsigned char {
    material, ///< lights on materials
    normal,   ///< the unit normal (x, y, z) on the viewer's side, each coordinate from −1 … 1 to 0 … 1
    depth,    ///< white at the near end of the clip region's bounding ball, black at the far end
    mean_curvature, ///< blue, white, red for negative, zero, positive: bent towards −∇f, flat, towards ∇f
    gaussian_curvature, ///< blue for saddles, white, red for caps and bowls
    steps,              ///< from dark blue for few over green to red for 255 steps or more of a ray
};

/// Shadows and ambient occlusion: what keeps light away. Both are found with rays, so they are as exact as
/// the surface's own answers; only their number is finite. Numbers of rays are for a pixel: its samples share
/// them.
struct Occlusion {
    bool shadows = false;
    /// Rays for each light whose angular radius is not 0; one for the others. In [1, 1024].
    std::uint32_t shadow_rays = 16;
    /// Rays for ambient occlusion, cosine-weighted over the hemisphere; 0 is none. At most 1024.
    std::uint32_t ambient_rays = 0;
    /// How far an occluder may be, in units of the radius of the clip region's bounding ball; above 0.
    double ambient_reach = 0.5;
};

/// How a picture is made. All fields have a meaning without being set.
struct RenderOptions {
    ImageSize size = {};
    Colouring colouring = Colouring::material;
    Occlusion occlusion = {};
    /// n for n × n samples a pixel, at the middles of n × n equal parts of it; in [1, 16].
    std::uint32_t antialias = 1;
    /// Takes the n × n samples only where the colour of the pixel's centre differs from that of a neighbour.
    bool adaptive = true;
    /// How rays are traced: by root isolation if empty, otherwise by stepping.
    std::optional<SphereTracing> sphere_tracing = {};
    bool depths = false; ///< deliver the depths of the pixels' centres with the colours
};

/// What was done for a picture.
struct RenderStatistics {
    std::uint64_t rays = 0;           ///< from the camera
    std::uint64_t hits = 0;           ///< how many of them met the surface
    std::uint64_t occlusion_rays = 0; ///< for shadows and ambient occlusion
    std::uint64_t refined_pixels = 0; ///< pixels that were given n × n samples
    std::optional<SphereStatistics> stepping = {};
};

/// Takes finished rows, in order from the top.
using RowSink = std::function<void(const ImageRows&)>;

/// Draws a surface.
///
/// Each pixel shows the first hit of its ray in the clip region. Which side of the surface is seen is the
/// sign of its function just before the hit; the normal is the gradient, turned to the viewer. At singular
/// points, where there is no normal, the surface faces the viewer.
///
/// The depth of a pixel is the distance of the hit of its centre's ray from the ray's origin (of a
/// perspective camera: from the camera), infinity for a miss.
///
/// Pixels do not depend on the number of threads: what is random is decided by the Run's seed and the pixel.
/// Memory is that of a band of some rows, whatever the size of the picture.
///
/// \param surface what to draw
/// \param camera from where
/// \param clip which part of it; a bounded region
/// \param lighting lights, materials and background
/// \param options everything else
/// \param run threads, seed, limits and progress (phase `picture`, counted in tiles)
/// \param sink receives the rows; it is called in turn but not always from the same thread, and what it
/// throws
///   ends the rendering
/// \throws DomainError for an option out of its range, an unbounded region, or improper lighting
RenderStatistics render(const scene::Surface& surface, const Camera& camera, const scene::ClipRegion& clip,
                        const Lighting& lighting, const RenderOptions& options, base::Run& run,
                        const RowSink& sink);

/// The same picture in memory, with depths.
Image render_image(const scene::Surface& surface, const Camera& camera, const scene::ClipRegion& clip,
                   const Lighting& lighting, RenderOptions options, base::Run& run);

/// A camera at some distance, above and to the right of the x-z-plane, that has the ball in its view with a
/// small margin. \param ball what to look at
/// \param size of the picture, for its aspect
/// \param vertical_degrees field of view
Camera framing_camera(const scene::Ball& ball, ImageSize size, double vertical_degrees = 30);

} // namespace eliminant::render

namespace eliminant {
using render::Colouring;
using render::render_image;
using render::RenderOptions;
using render::RenderStatistics;
} // namespace eliminant
