// Pictures in memory and as files: the files are read back by decoders of their own.
#include "eliminant/base/error.hpp"
#include "eliminant/render/image.hpp"
#include "eliminant/render/image_writer.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace eliminant::render {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Image random_image(ImageSize size, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<float> number(-0.2F, 1.3F);
    Image image(size);
    for (std::uint32_t row = 0; row < size.height; ++row)
        for (std::uint32_t column = 0; column < size.width; ++column)
            image.set(column, row, {number(random), number(random), number(random)},
                      column % 3 == 0 ? infinity : number(random));
    return image;
}

std::string bytes_of(const Image& image, ImageFormat format) {
    std::string bytes;
    write_image(image, format, [&](std::string_view part) { bytes += part; });
    return bytes;
}

/// What the definition of sRGB gives.
std::uint8_t byte_by_definition(double linear) {
    const double x = std::min(1.0, std::max(0.0, linear));
    const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

std::vector<std::uint8_t> bytes_by_definition(const Image& image) {
    std::vector<std::uint8_t> bytes;
    for (const float value : image.rows().colours) bytes.push_back(byte_by_definition(value));
    return bytes;
}

/// libpng's simplified reader.
std::vector<std::uint8_t> decoded_png(const std::string& bytes, ImageSize& size) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) return {};
    image.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(image));
    size = {image.width, image.height};
    if (png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) == 0) return {};
    return pixels;
}

TEST(Srgb, BytesAreThoseOfTheDefinition) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<float> number(0, 1);
    std::vector<float> values{0, 1, -0.0F, -1, 2, 1e-40F, std::nextafter(1.0F, 0.0F), 0.0031308F};
    for (int i = 0; i < 100000; ++i) values.push_back(number(random));
    for (int i = 0; i < 1000; ++i) values.push_back(number(random) * 0.01F);
    for (int byte = 0; byte < 255; ++byte) { // both sides of every rounding
        const auto edge = static_cast<float>(linear_from_srgb((byte + 0.5) / 255));
        values.insert(values.end(), {edge, std::nextafter(edge, 0.0F), std::nextafter(edge, 1.0F)});
    }
    std::vector<std::uint8_t> bytes(values.size());
    encode_srgb(values, bytes);
    for (std::size_t i = 0; i < values.size(); ++i) {
        // At the edges the definition itself is evaluated with rounding.
        const double x = values[i];
        const bool at_edge = byte_by_definition(x * (1 + 1e-14)) != byte_by_definition(x * (1 - 1e-14));
        if (at_edge) continue;
        EXPECT_EQ(bytes[i], byte_by_definition(x)) << x;
    }
}

TEST(Srgb, OddValuesAreClamped) {
    const std::vector<float> values{std::numeric_limits<float>::quiet_NaN(),
                                    std::numeric_limits<float>::infinity(),
                                    -std::numeric_limits<float>::infinity(), 1e30F};
    std::vector<std::uint8_t> bytes(values.size());
    encode_srgb(values, bytes);
    EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0, 255, 0, 255}));
}

TEST(Srgb, TransferAndItsInverseAgree) {
    for (int i = 0; i <= 1000; ++i)
        EXPECT_NEAR(srgb_from_linear(linear_from_srgb(i / 1000.0)), i / 1000.0, 1e-7);
}

TEST(ImageFiles, PngReadsBack) {
    for (const ImageSize size : {ImageSize{1, 1}, ImageSize{17, 5}, ImageSize{3, 70}}) {
        const Image image = random_image(size, 3);
        ImageSize found{};
        EXPECT_EQ(decoded_png(bytes_of(image, ImageFormat::png), found), bytes_by_definition(image));
        EXPECT_EQ(found, size);
    }
}

TEST(ImageFiles, PngSaysThatItIsSrgb) {
    EXPECT_NE(bytes_of(random_image({4, 4}, 1), ImageFormat::png).find("sRGB"), std::string::npos);
}

TEST(ImageFiles, PpmIsHeaderAndBytes) {
    const Image image = random_image({7, 3}, 4);
    const std::vector<std::uint8_t> pixels = bytes_by_definition(image);
    EXPECT_EQ(bytes_of(image, ImageFormat::ppm),
              "P6\n7 3\n255\n" + std::string(pixels.begin(), pixels.end()));
}

TEST(ImageFiles, PfmIsLinearAndFromTheBottom) {
    const Image image = random_image({4, 3}, 5);
    const std::string bytes = bytes_of(image, ImageFormat::pfm);
    const std::string header = "PF\n4 3\n-1.0\n";
    ASSERT_EQ(bytes.size(), header.size() + 4 * 3 * 3 * sizeof(float));
    EXPECT_EQ(bytes.substr(0, header.size()), header);
    if constexpr (std::endian::native == std::endian::little) {
        std::array<float, 3> pixel{};
        std::memcpy(pixel.data(), bytes.data() + header.size(), sizeof pixel);
        EXPECT_EQ(pixel, image.colour(0, 2));
        std::memcpy(pixel.data(), bytes.data() + bytes.size() - sizeof pixel, sizeof pixel);
        EXPECT_EQ(pixel, image.colour(3, 0));
    }
}

TEST(ImageFiles, DepthIsDoublesFromTheTop) {
    const Image image = random_image({4, 3}, 6);
    const std::string bytes = bytes_of(image, ImageFormat::depth);
    ASSERT_EQ(bytes.size(), 12 * sizeof(double));
    for (std::size_t i = 0; i < 12; ++i) {
        std::uint64_t word = 0;
        for (std::size_t byte = 0; byte < 8; ++byte)
            word |= std::uint64_t{static_cast<unsigned char>(bytes[8 * i + byte])} << (8 * byte);
        EXPECT_EQ(std::bit_cast<double>(word),
                  image.depth(static_cast<std::uint32_t>(i % 4), static_cast<std::uint32_t>(i / 4)));
    }
}

TEST(ImageFiles, BandsGiveTheSameFileAsTheWhole) {
    const Image image = random_image({9, 40}, 7);
    const ImageRows all = image.rows();
    for (const ImageFormat format :
         {ImageFormat::png, ImageFormat::ppm, ImageFormat::pfm, ImageFormat::depth}) {
        std::string bytes;
        const auto writer = make_writer(format, {9, 40}, [&](std::string_view part) { bytes += part; });
        for (const auto& [first, count] : {std::pair{0U, 1U}, {1U, 0U}, {1U, 20U}, {21U, 19U}})
            writer->write({9, first, count, all.colours.subspan(27 * first, 27 * count),
                           all.depths.subspan(9 * first, 9 * count)});
        writer->finish();
        EXPECT_EQ(bytes, bytes_of(image, format));
        std::string placed;
        const auto seeking =
            make_seeking_writer(format, {9, 40}, [&](std::uint64_t offset, std::string_view part) {
                placed.resize(std::max<std::size_t>(placed.size(), offset + part.size()));
                placed.replace(offset, part.size(), part);
            });
        for (const auto& [first, count] : {std::pair{0U, 5U}, {5U, 35U}})
            seeking->write({9, first, count, all.colours.subspan(27 * first, 27 * count),
                            all.depths.subspan(9 * first, 9 * count)});
        seeking->finish();
        EXPECT_EQ(placed, bytes);
    }
}

TEST(ImageFiles, RowsOutOfOrderAreRefused) {
    const Image image = random_image({2, 4}, 8);
    const ImageRows all = image.rows();
    const auto writer = make_writer(ImageFormat::png, {2, 4}, [](std::string_view) {});
    EXPECT_THROW(writer->write({2, 1, 1, all.colours.first(6), {}}), DomainError);
    EXPECT_THROW(writer->write({3, 0, 1, all.colours.first(9), {}}), DomainError);
    EXPECT_THROW(writer->write({2, 0, 5, all.colours, {}}), DomainError);
    EXPECT_THROW(writer->finish(), DomainError);
    writer->write(all);
    writer->finish();
}

TEST(ImageFiles, WhatTheSinkThrowsArrives) {
    struct Full {};
    const Image image = random_image({200, 200}, 9);
    for (const ImageFormat format :
         {ImageFormat::png, ImageFormat::ppm, ImageFormat::pfm, ImageFormat::depth})
        for (const std::size_t room : {0U, 10U, 20000U}) {
            std::size_t written = 0;
            EXPECT_THROW(write_image(image, format,
                                     [&](std::string_view part) {
                                         written += part.size();
                                         if (written > room) throw Full{};
                                     }),
                         Full);
        }
}

TEST(ImageFiles, ImpossibleSizesAreRefused) {
    for (const ImageSize size : {ImageSize{0, 5}, ImageSize{5, 0}, ImageSize{most_pixels_a_side + 1, 1}}) {
        EXPECT_THROW(check_size(size), DomainError);
        EXPECT_THROW(Image{size}, DomainError);
        EXPECT_THROW(make_writer(ImageFormat::png, size, [](std::string_view) {}), DomainError);
    }
}

} // namespace
} // namespace eliminant::render
