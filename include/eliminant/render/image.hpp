/// \file
/// Pictures: linear colour and depth, whole or a band of rows at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::render {

/// Linear (not sRGB-encoded) red, green, blue with the sRGB primaries; 1 is the white of the screen, more is
/// allowed.
using Colour = std::array<float, 3>;

/// Width and height in pixels.
struct ImageSize {
    std::uint32_t width = 640;
    std::uint32_t height = 480;

    std::size_t pixels() const { return std::size_t{width} * height; } ///< How many.
    friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

/// No picture has more rows or columns than this.
inline constexpr std::uint32_t most_pixels_a_side = 1U << 20;

/// \throws DomainError if a side is 0 or longer than most_pixels_a_side
void check_size(ImageSize size);

/// A view of some complete rows of a picture:
///
///     row first      r g b r g b r g b …   (3 · width floats)
///     row first + 1  r g b …
///
/// and in the same way one depth a pixel, or none at all.
struct ImageRows {
    std::uint32_t width = 0;
    std::uint32_t first = 0; ///< row 0 is the top of the picture
    std::uint32_t count = 0;
    std::span<const float> colours = {}; ///< 3 · width · count, linear
    std::span<const double> depths = {}; ///< width · count, infinity where nothing was hit; or empty
};

/// A picture in memory.
class Image {
  public:
    /// Black, and infinitely far away. \throws DomainError for an impossible size
    explicit Image(ImageSize size);

    ImageSize size() const { return size_; }
    Colour colour(std::uint32_t column, std::uint32_t row) const; ///< linear
    double depth(std::uint32_t column, std::uint32_t row) const { return depths_[index(column, row)]; }
    void set(std::uint32_t column, std::uint32_t row, Colour colour, double depth);

    /// All of it.
    ImageRows rows() const;
    /// Copies a band to its place. Depths stay as they are if `rows` has none.
    void assign(const ImageRows& rows);

  private:
    std::size_t index(std::uint32_t column, std::uint32_t row) const {
        return std::size_t{row} * size_.width + column;
    }

    ImageSize size_;
    std::vector<float> colours_; // interleaved, as in ImageRows
    std::vector<double> depths_;
};

/// The sRGB transfer function (IEC 61966-2-1): linear light in [0, 1] to the value that is stored.
double srgb_from_linear(double linear);
/// Its inverse.
double linear_from_srgb(double encoded);

/// The byte for each linear value: 255 · srgb_from_linear rounded to nearest. Values beyond [0, 1] are
/// clamped, NaN becomes 0. Both spans have the same length.
void encode_srgb(std::span<const float> linear, std::span<std::uint8_t> bytes);

} // namespace eliminant::render

namespace eliminant {
using render::Image;
using render::ImageSize;
} // namespace eliminant
