/// \file
/// Pictures as files: PNG, PPM, PFM and raw depth.
#pragma once

#include "eliminant/base/error.hpp"
#include "eliminant/render/image.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

namespace eliminant::render {

/// The formats of pictures.
enum class ImageFormat : unsigned char {
    png,   ///< 8 bits a channel, sRGB, compressed without loss (ISO/IEC 15948)
    ppm,   ///< 8 bits a channel, sRGB, binary (`P6`)
    pfm,   ///< linear little-endian float32 (`PF`)
    depth, ///< little-endian float64 depths, row by row from the top, infinity for a miss; nothing else
};

/// Takes the bytes of a file as they come. What it throws passes through the writer.
using ByteSink = std::function<void(std::string_view)>;

/// Takes bytes for places of a file, which may come in any sequence.
using PositionedSink = std::function<void(std::uint64_t offset, std::string_view bytes)>;

/// A picture that could not be encoded; the message is the encoder's.
class EncodingError : public Error {
  public:
    using Error::Error;
};

/// Encodes a picture band by band, so that no more than a band of it need be in memory.
class ImageWriter {
  public:
    virtual ~ImageWriter() = default;
    ImageWriter() = default;
    ImageWriter(const ImageWriter&) = delete;
    ImageWriter& operator=(const ImageWriter&) = delete;

    /// Bands come in order from the top, without gaps; the format `depth` needs their depths, the others
    /// their colours.
    /// \throws DomainError if a band does not follow the last one
    /// \throws EncodingError if the encoder fails
    void write(const ImageRows& rows);
    /// After the last row: what ends the file. \throws DomainError if rows are missing
    void finish();

  protected:
    explicit ImageWriter(ImageSize size) : size_(size) {}
    virtual void encode(const ImageRows& rows) = 0;
    virtual void encode_end() {}
    ImageSize size() const { return size_; }

  private:
    ImageSize size_;
    std::uint32_t next_row_ = 0;
};

/// A writer for a picture of this size. A PFM has its rows from the bottom, so its writer keeps the picture
/// until finish(); the others pass everything on at once.
/// \throws DomainError for an impossible size
std::unique_ptr<ImageWriter> make_writer(ImageFormat format, ImageSize size, ByteSink sink);

/// The same for a file that can be written at any place: of no format is more than a band kept.
std::unique_ptr<ImageWriter> make_seeking_writer(ImageFormat format, ImageSize size, PositionedSink sink);

/// The whole picture.
void write_image(const Image& image, ImageFormat format, const ByteSink& sink);

} // namespace eliminant::render

namespace eliminant {
using render::ImageFormat;
using render::write_image;
} // namespace eliminant
