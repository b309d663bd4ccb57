#include "eliminant/render/image_writer.hpp"

#include "render/png_encoder.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace eliminant::render {
namespace {

/// How much of a band is turned into bytes at a time.
constexpr std::size_t block_rows = 16;

std::string header(const char* magic, ImageSize size, const char* range) {
    return std::string(magic) + '\n' + std::to_string(size.width) + ' ' + std::to_string(size.height) + '\n' +
           range + '\n';
}

std::string_view text_of(std::span<const std::uint8_t> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The bytes of a number, the lowest first.
template <class Word>
void append_little_endian(std::string& text, Word word) {
    for (std::size_t i = 0; i < sizeof word; ++i) text += static_cast<char>((word >> (8 * i)) & 0xff);
}

/// Rows as sRGB bytes, a block at a time.
class ByteRows {
  public:
    explicit ByteRows(ImageSize size) : buffer_(block_rows * 3 * size.width) {}

    template <class Use>
    void for_each_block(std::span<const float> colours, const Use& use) {
        while (!colours.empty()) {
            const std::size_t count = std::min(buffer_.size(), colours.size());
            const std::span<std::uint8_t> bytes = std::span(buffer_).first(count);
            encode_srgb(colours.first(count), bytes);
            use(std::span<const std::uint8_t>(bytes));
            colours = colours.subspan(count);
        }
    }

  private:
    std::vector<std::uint8_t> buffer_;
};

class PpmWriter : public ImageWriter {
  public:
    PpmWriter(ImageSize size, ByteSink sink) : ImageWriter(size), sink_(std::move(sink)), bytes_(size) {
        sink_(header("P6", size, "255"));
    }

  private:
    void encode(const ImageRows& rows) override {
        bytes_.for_each_block(rows.colours,
                              [&](std::span<const std::uint8_t> bytes) { sink_(text_of(bytes)); });
    }

    ByteSink sink_;
    ByteRows bytes_;
};

class PngWriter : public ImageWriter {
  public:
    PngWriter(ImageSize size, ByteSink sink)
        : ImageWriter(size), encoder_(size, std::move(sink)), bytes_(size) {}

  private:
    void encode(const ImageRows& rows) override {
        bytes_.for_each_block(rows.colours,
                              [&](std::span<const std::uint8_t> bytes) { encoder_.write_rows(bytes); });
    }
    void encode_end() override { encoder_.finish(); }

    PngEncoder encoder_;
    ByteRows bytes_;
};

class PfmWriter : public ImageWriter {
  public:
    PfmWriter(ImageSize size, PositionedSink sink)
        : ImageWriter(size), sink_(std::move(sink)), header_(header("PF", size, "-1.0")) { // little-endian
        sink_(0, header_);
    }

  private:
    void encode(const ImageRows& rows) override {
        const std::size_t values = 3 * std::size_t{rows.width};
        std::string bytes;
        for (std::uint32_t row = 0; row < rows.count; ++row) {
            bytes.clear();
            for (const float value : rows.colours.subspan(row * values, values))
                append_little_endian(bytes, std::bit_cast<std::uint32_t>(value));
            const std::uint64_t rows_below = size().height - 1 - (rows.first + row);
            sink_(header_.size() + rows_below * bytes.size(), bytes);
        }
    }

    PositionedSink sink_;
    std::string header_;
};

/// Keeps a PFM for those who take it only from its beginning.
class KeptPfmWriter : public ImageWriter {
  public:
    KeptPfmWriter(ImageSize size, ByteSink sink)
        : ImageWriter(size), sink_(std::move(sink)),
          writer_(size, [this](std::uint64_t offset, std::string_view bytes) {
              file_.resize(std::max<std::size_t>(file_.size(), offset + bytes.size()));
              file_.replace(offset, bytes.size(), bytes);
          }) {}

  private:
    void encode(const ImageRows& rows) override { writer_.write(rows); }
    void encode_end() override { sink_(file_); }

    ByteSink sink_;
    std::string file_;
    PfmWriter writer_;
};

class DepthWriter : public ImageWriter {
  public:
    DepthWriter(ImageSize size, ByteSink sink) : ImageWriter(size), sink_(std::move(sink)) {}

  private:
    void encode(const ImageRows& rows) override {
        std::string bytes;
        for (std::uint32_t row = 0; row < rows.count; ++row) {
            bytes.clear();
            for (const double depth : rows.depths.subspan(std::size_t{row} * rows.width, rows.width))
                append_little_endian(bytes, std::bit_cast<std::uint64_t>(depth));
            sink_(bytes);
        }
    }

    ByteSink sink_;
};

} // namespace

void ImageWriter::write(const ImageRows& rows) {
    if (rows.first != next_row_ || rows.width != size_.width || rows.count > size_.height - next_row_)
        throw DomainError("picture: expected the rows from " + std::to_string(next_row_) + ", found " +
                          std::to_string(rows.count) + " rows from " + std::to_string(rows.first));
    encode(rows);
    next_row_ += rows.count;
}

void ImageWriter::finish() {
    if (next_row_ != size_.height)
        throw DomainError("picture: expected " + std::to_string(size_.height) + " rows, found " +
                          std::to_string(next_row_));
    encode_end();
}

std::unique_ptr<ImageWriter> make_writer(ImageFormat format, ImageSize size, ByteSink sink) {
    check_size(size);
    switch (format) {
    case ImageFormat::png:
        return std::make_unique<PngWriter>(size, std::move(sink));
    case ImageFormat::ppm:
        return std::make_unique<PpmWriter>(size, std::move(sink));
    case ImageFormat::pfm:
        return std::make_unique<KeptPfmWriter>(size, std::move(sink));
    case ImageFormat::depth:
        break;
    }
    return std::make_unique<DepthWriter>(size, std::move(sink));
}

std::unique_ptr<ImageWriter> make_seeking_writer(ImageFormat format, ImageSize size, PositionedSink sink) {
    check_size(size);
    if (format == ImageFormat::pfm) return std::make_unique<PfmWriter>(size, std::move(sink));
    return make_writer(format, size,
                       [sink = std::move(sink), offset = std::uint64_t{0}](std::string_view bytes) mutable {
                           sink(offset, bytes);
                           offset += bytes.size();
                       });
}

void write_image(const Image& image, ImageFormat format, const ByteSink& sink) {
    const std::unique_ptr<ImageWriter> writer = make_writer(format, image.size(), sink);
    writer->write(image.rows());
    writer->finish();
}

} // namespace eliminant::render
