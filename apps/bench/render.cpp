// What a picture costs, part by part, one JSON object a line:
//
//     bench_render [--size N] [--repeat N] [NAME …]      surfaces of data/surfaces whose name contains a NAME
//
// Each surface is drawn from its own camera in N × N pixels (1024) by one thread. Figures are nanoseconds of
// user CPU time a pixel, medians: rays alone, rays and shading, encoding as PPM and as PNG; and how many
// times faster two threads are by the clock.
#include "eliminant/algebra/parse.hpp"
#include "eliminant/render/image_writer.hpp"
#include "eliminant/render/renderer.hpp"
#include "eliminant/scene/algebraic_surface.hpp"

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace {

using eliminant::algebraic_surface;
using eliminant::Ball;
using eliminant::Camera;
using eliminant::ClipRegion;
using eliminant::CoefficientField;
using eliminant::Hit;
using eliminant::Image;
using eliminant::ImageFormat;
using eliminant::ImageSize;
using eliminant::Lighting;
using eliminant::parse_polynomial;
using eliminant::parse_rational;
using eliminant::render_image;
using eliminant::RenderOptions;
using eliminant::Ring;
using eliminant::Run;
using eliminant::RunOptions;
using eliminant::Tile;
using eliminant::write_image;
namespace render = eliminant::render;

double user_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median_cost(int repeat, double (*clock)(), const std::function<void()>& work) {
    std::vector<double> costs;
    for (int i = 0; i < repeat; ++i) {
        const double begin = clock();
        work();
        costs.push_back(clock() - begin);
    }
    std::ranges::sort(costs);
    return costs[costs.size() / 2];
}

double number(const std::string& text) { return parse_rational(text).get_d(); }

glm::dvec3 point(const nlohmann::json& numbers) {
    return {number(numbers[0]), number(numbers[1]), number(numbers[2])};
}

void measure(const nlohmann::json& entry, ImageSize size, int repeat) {
    Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"});
    const std::string text = entry.at("expanded");
    const auto surface = algebraic_surface(parse_polynomial(ring, text, run), run);
    const auto& view = entry.at("camera");
    const Camera camera = Camera::perspective(
        {point(view.at("origin")), point(view.at("look_at")), point(view.at("up"))}, view.at("vfov_deg"));
    ClipRegion clip;
    clip.add(Ball{glm::dvec3(0), number(entry.at("clip").at("sphere_radius"))});
    const Lighting lighting = render::default_lighting(camera);
    RenderOptions options;
    options.size = size;

    const double pixels = static_cast<double>(size.pixels());
    nlohmann::ordered_json line{{"surface", entry.at("name")}, {"degree", entry.at("degree")}};
    const auto cost = [&](const char* name, const std::function<void()>& work) {
        line[name] = std::round(10 * 1e9 * median_cost(repeat, user_seconds, work) / pixels) / 10;
    };
    cost("rays", [&] {
        constexpr std::size_t side = 64;
        const auto tracer = surface->tracer(camera.rays(size), clip, run);
        std::vector<Hit> hits;
        for (std::size_t row = 0; row < size.height; row += side)
            for (std::size_t column = 0; column < size.width; column += side) {
                const Tile tile{column, row, std::min(side, size.width - column),
                                std::min(side, size.height - row)};
                hits.resize(tile.size());
                tracer->trace(tile, hits, run);
            }
    });
    const auto draw = [&](Run& with) {
        render::render(*surface, camera, clip, lighting, options, with, [](const render::ImageRows&) {});
    };
    cost("rays_and_shading", [&] { draw(run); });
    const Image image = render_image(*surface, camera, clip, lighting, options, run);
    std::size_t bytes = 0;
    const auto count = [&](std::string_view part) { bytes += part.size(); };
    cost("ppm", [&] { write_image(image, ImageFormat::ppm, count); });
    cost("png", [&] { write_image(image, ImageFormat::png, count); });

    RunOptions two_threads;
    two_threads.threads = 2;
    Run both(two_threads);
    const double one = median_cost(repeat, wall_seconds, [&] { draw(run); });
    const double two = median_cost(repeat, wall_seconds, [&] { draw(both); });
    line["two_threads"] = std::round(100 * one / two) / 100;
    std::cout << line.dump() << std::endl;
}

} // namespace

int main(int argument_count, char** arguments) {
    ImageSize size{1024, 1024};
    int repeat = 5;
    std::vector<std::string> names;
    for (int i = 1; i < argument_count; ++i) {
        const std::string word = arguments[i];
        const bool has_value = i + 1 < argument_count;
        if (word == "--size" && has_value)
            size.width = size.height = static_cast<std::uint32_t>(std::atoi(arguments[++i]));
        else if (word == "--repeat" && has_value)
            repeat = std::max(1, std::atoi(arguments[++i]));
        else
            names.push_back(word);
    }
    std::ifstream surfaces(std::string(ELIMINANT_DATA_DIR) + "/surfaces/surfaces.jsonl");
    for (std::string line; std::getline(surfaces, line);) {
        const nlohmann::json entry = nlohmann::json::parse(line);
        const std::string name = entry.at("name");
        const auto is_part = [&](const std::string& part) { return name.find(part) != std::string::npos; };
        if (names.empty() || std::ranges::any_of(names, is_part)) measure(entry, size, repeat);
    }
}
