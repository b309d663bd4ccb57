/// \file
/// Colours of many points at once.
#pragma once

#include "eliminant/render/lighting.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace eliminant::render {

/// Points to be shaded, one array a quantity, so that the loops over them become vector code.
struct ShadingBatch {
    static constexpr std::size_t capacity = 256;
    using Floats = std::array<float, capacity>;

    std::size_t count = 0;
    std::array<Floats, 3> normal; ///< of either orientation, until orient() turns it to the viewer
    std::array<Floats, 3> view;   ///< towards the viewer
    Floats side;       ///< which side of the surface is seen: > 0 outside, < 0 inside, 0 as the normal says
    Floats is_outside; ///< set by orient(): 1 or 0
    Floats openness;   ///< the part of the ambient light that arrives, in [0, 1]
    std::vector<Floats>
        visibility; ///< for each light, the part of it that arrives, in [0, 1]; or empty: all of it
    std::array<Floats, 3> colour; ///< the result: linear red, green, blue
};

/// Makes `normal` and `view` unit vectors, turns the normals to the viewer, and sets `is_outside`: where
/// `side` is 0, the outside is seen if the normal came in pointing to the viewer.
void orient(ShadingBatch& batch);

/// A Lighting made ready.
class Shader {
  public:
    explicit Shader(const Lighting& lighting);

    /// Sets `batch.colour` of a batch that has been oriented.
    void shade(ShadingBatch& batch) const;

  private:
    /// A material with a zero difference, or both sides of the surface: value = inside + is_outside ·
    /// difference.
    struct TwoSided {
        float inside = 0;
        float difference = 0;
        float at(float is_outside) const { return inside + is_outside * difference; }
    };
    struct Light {
        std::array<float, 3> towards; ///< of length 1
        Colour colour;
    };
    void add_light(ShadingBatch& batch, const Light& light, const ShadingBatch::Floats* visibility) const;

    std::vector<Light> lights_;
    Colour ambient_;
    std::array<TwoSided, 3> diffuse_;
    std::array<TwoSided, 3> specular_; ///< normalised, times π
    TwoSided shininess_;
};

} // namespace eliminant::render
