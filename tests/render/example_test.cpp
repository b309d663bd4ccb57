// The example of the library's use draws what it says.
#include "support/process.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace eliminant::test {
namespace {

TEST(Example, DrawsASurfaceNextToTriangles) {
    const ProcessResult result = run_process({ELIMINANT_EXAMPLE});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.errors, "");
    const std::string header = "P6\n160 120\n255\n";
    ASSERT_EQ(result.output.size(), header.size() + std::size_t{160} * 120 * 3);
    ASSERT_EQ(result.output.substr(0, header.size()), header);
    int sky = 0;
    int triangles = 0;
    int surface = 0;
    for (std::size_t i = header.size(); i < result.output.size(); i += 3) {
        const std::array<int, 3> rgb{static_cast<unsigned char>(result.output[i]),
                                     static_cast<unsigned char>(result.output[i + 1]),
                                     static_cast<unsigned char>(result.output[i + 2])};
        if (rgb == std::array{255, 255, 255})
            ++sky;
        else if (rgb[0] > rgb[2])
            ++surface; // orange
        else
            ++triangles; // bluish grey
    }
    EXPECT_GT(sky, 1000);
    EXPECT_GT(triangles, 3000);
    EXPECT_GT(surface, 1500);
}

} // namespace
} // namespace eliminant::test
