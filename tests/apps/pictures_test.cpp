// Pictures look as those of data/pictures, which were looked at. Small differences of rounding between
// compilers and processors are none.
#include "program.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace eliminant::test {
namespace {

struct Picture {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> bytes; ///< r g b, sRGB
};

Picture read_png(const std::string& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    Picture picture;
    if (png_image_begin_read_from_file(&image, file.c_str()) == 0) return picture;
    image.format = PNG_FORMAT_RGB;
    picture = {image.width, image.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
    if (png_image_finish_read(&image, nullptr, picture.bytes.data(), 0, nullptr) == 0) return {};
    return picture;
}

/// What an eye at some distance tells apart: channels of 4 × 4 blocks, averaged.
double largest_block_difference(const Picture& a, const Picture& b) {
    constexpr std::uint32_t side = 4;
    double largest = 0;
    for (std::uint32_t row = 0; row + side <= a.height; row += side)
        for (std::uint32_t column = 0; column + side <= a.width; column += side)
            for (std::uint32_t channel = 0; channel < 3; ++channel) {
                double sum = 0;
                for (std::uint32_t i = 0; i < side * side; ++i) {
                    const std::size_t at =
                        3 * ((row + i / side) * std::size_t{a.width} + column + i % side) + channel;
                    sum += static_cast<double>(a.bytes[at]) - static_cast<double>(b.bytes[at]);
                }
                largest = std::max(largest, std::abs(sum) / (side * side));
            }
    return largest;
}

const std::string barth =
    "4*(2.6180339887498948482*x^2-y^2)*(2.6180339887498948482*y^2-z^2)*(2.6180339887498948482*z^2-x^2)"
    "-4.2360679774997896964*(x^2+y^2+z^2-1)^2";

struct Golden {
    std::string file;
    std::vector<std::string> arguments;
};

const std::vector<Golden>& goldens() {
    static const std::string data = ELIMINANT_DATA_DIR;
    static const std::vector<Golden> all = {
        {"barth_cut.png",
         {barth, "--clip", "sphere:2", "--clip", "halfspace:0,0,1,1/2", "--orthographic", "4.2",
          "--antialias", "3"}},
        {"cubic_lit.png",
         {"x^3+y^3+z^3+1 = (x+y+z+1)^3",
          "--clip",
          "box:-3,-3,-3,3,3,3",
          "--camera",
          "-7,5,8",
          "--look-at",
          "0,0,0",
          "--fov",
          "40",
          "--light",
          "1,3,2;#ffd8a0;4",
          "--light",
          "-2,1,1;#6080ff",
          "--ambient",
          "0.2",
          "--background",
          "#203040",
          "--outside",
          "0.9,0.9,0.9",
          "--inside",
          "#c04040",
          "--shininess",
          "20",
          "--specular",
          "0.3",
          "--shadows",
          "--antialias",
          "2"}},
        {"enneper.png",
         {data + "/implicit/enneper.par", "--clip", "sphere:12", "--shadows", "--ambient-occlusion",
          "--antialias", "3"}},
        {"tanglecube_curvature.png",
         {"x^4+y^4+z^4-5*(x^2+y^2+z^2)+11.8", "--colouring", "gaussian-curvature", "--antialias", "2"}},
        {"torus_normals.png",
         {"(x^2+y^2+z^2+3)^2 = 16*(x^2+y^2)", "--colouring", "normal", "--antialias", "4"}},
        {"whitney.png", {"x^2 = y^2*z", "--clip", "sphere:2", "--shadows", "--antialias", "3"}},
    };
    return all;
}

TEST(Pictures, LookAsTheyShould) {
    const ScratchDirectory scratch;
    // Set to a folder, the variable says where to put new pictures instead of comparing.
    const char* update = std::getenv("ELIMINANT_NEW_PICTURES");
    for (const Golden& golden : goldens()) {
        const std::string file =
            update != nullptr ? std::string(update) + "/" + golden.file : scratch.path(golden.file);
        std::vector<std::string> arguments{"render"};
        arguments.insert(arguments.end(), golden.arguments.begin(), golden.arguments.end());
        arguments.insert(arguments.end(), {"--size", "120x90", "-o", file});
        const ProcessResult result = run(arguments);
        EXPECT_EQ(result.status, 0) << result.errors;
        const Picture found = read_png(file);
        const Picture expected = read_png(std::string(ELIMINANT_DATA_DIR) + "/pictures/" + golden.file);
        ASSERT_EQ(expected.bytes.size(), 3U * 120 * 90) << golden.file;
        ASSERT_EQ(found.bytes.size(), expected.bytes.size()) << golden.file;
        EXPECT_LE(largest_block_difference(found, expected), 6) << golden.file;
    }
}

TEST(Pictures, DifferencesAreSeen) {
    Picture a{8, 8, std::vector<std::uint8_t>(192, 100)};
    Picture b = a;
    EXPECT_EQ(largest_block_difference(a, b), 0);
    for (std::size_t i = 0; i < 3 * 4; ++i) b.bytes[i] = 130; // a row of a block
    EXPECT_EQ(largest_block_difference(a, b), 7.5);
}

} // namespace
} // namespace eliminant::test
