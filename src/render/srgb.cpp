#include "eliminant/render/image.hpp"

#include <array>
#include <cassert>
#include <cmath>

namespace eliminant::render {
namespace {

/// Decides the byte of a linear value exactly with two small tables instead of a power.
///
/// `guess[i]` is the byte of the lower end of the i-th of `cells` equal parts of [0, 1]. The curve is
/// steepest at 0, where it rises by 255 · 12.92 / cells < 1 bytes a cell, so the byte is the guess or the
/// next one, and one comparison with the next byte's first linear value tells which.
class ByteTable {
  public:
    ByteTable() {
        for (std::size_t byte = 1; byte < 256; ++byte)
            first_[byte] = first_float_at_least(linear_from_srgb((static_cast<double>(byte) - 0.5) / 255));
        first_[256] = 2; // beyond all clamped values
        std::uint8_t byte = 0;
        for (std::size_t i = 0; i <= cells; ++i) {
            while (first_[byte + 1U] <= static_cast<float>(i) / cells) ++byte;
            guess_[i] = byte;
        }
    }

    std::uint8_t operator()(float linear) const {
        const float low = linear > 0 ? linear : 0; // also for NaN
        const float clamped = low < 1 ? low : 1;
        const std::uint8_t guess = guess_[static_cast<unsigned>(clamped * cells)];
        return static_cast<std::uint8_t>(guess + (clamped >= first_[guess + 1U] ? 1 : 0));
    }

  private:
    static constexpr unsigned cells = 4096; // a power of two: the product above is exact

    static float first_float_at_least(double value) {
        const auto nearest = static_cast<float>(value);
        return static_cast<double>(nearest) >= value ? nearest : std::nextafter(nearest, 2.0F);
    }

    std::array<float, 257> first_{}; ///< the least linear value of each byte
    std::array<std::uint8_t, cells + 1> guess_{};
};

} // namespace

double srgb_from_linear(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double linear_from_srgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

void encode_srgb(std::span<const float> linear, std::span<std::uint8_t> bytes) {
    assert(linear.size() == bytes.size());
    static const ByteTable byte_of;
    for (std::size_t i = 0; i < linear.size(); ++i) bytes[i] = byte_of(linear[i]);
}

} // namespace eliminant::render
