/// \file
/// PNG through libpng, whose errors become exceptions.
#pragma once

#include "eliminant/render/image_writer.hpp"

#include <cstdint>
#include <memory>
#include <span>

namespace eliminant::render {

/// Writes an 8-bit sRGB picture row by row.
class PngEncoder {
  public:
    PngEncoder(ImageSize size, ByteSink sink);
    ~PngEncoder();
    PngEncoder(const PngEncoder&) = delete;
    PngEncoder& operator=(const PngEncoder&) = delete;

    /// Complete rows of r g b bytes.
    void write_rows(std::span<const std::uint8_t> bytes);
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace eliminant::render
