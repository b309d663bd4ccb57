#include "scene_text.hpp"

#include "common_options.hpp"
#include "option_set.hpp"

#include "eliminant/algebra/parse.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <string>

namespace eliminant::app {

namespace {

[[noreturn]] void fail(const SourceText& text, std::string_view expected) {
    throw UsageError(text.name(), expected, "'" + std::string(text.text()) + "'");
}

/// GMP rounds towards zero.
double nearest_double(const mpq_class& exact) {
    const double low = exact.get_d();
    if (!std::isfinite(low)) return low;
    const double high = std::nextafter(low, exact < 0 ? -std::numeric_limits<double>::infinity()
                                                      : std::numeric_limits<double>::infinity());
    if (!std::isfinite(high)) return low;
    const mpq_class middle = (mpq_class(low) + mpq_class(high)) / 2;
    return abs(exact) > abs(middle) ? high : low;
}

std::vector<SourceText> parts_of(const SourceText& text, char separator) {
    std::vector<SourceText> parts;
    for (std::size_t begin = 0;;) {
        const std::size_t end = std::min(text.text().find(separator, begin), text.size());
        parts.push_back(text.section(begin, end));
        if (end == text.size()) return parts;
        begin = end + 1;
    }
}

/// `#rgb` or `#rrggbb` as three values from 0 to 1.
std::array<double, 3> read_web_colour(const SourceText& text) {
    const std::string_view digits = text.text().substr(1);
    const auto is_digit = [](unsigned char c) { return std::isxdigit(c) != 0; };
    if ((digits.size() != 3 && digits.size() != 6) || !std::all_of(digits.begin(), digits.end(), is_digit))
        fail(text, "a colour as #e8a33d or #fff");
    const std::size_t length = digits.size() / 3;
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string channel(digits.substr(i * length, length));
        values[i] = std::stoi(channel, nullptr, 16) / (length == 1 ? 15.0 : 255.0);
    }
    return values;
}

} // namespace

double read_number(const SourceText& text) {
    const double value = nearest_double(parse_rational(text));
    if (!std::isfinite(value)) fail(text, "a number that floating point can hold");
    return value;
}

double read_number_in(const SourceText& text, double least, double most, std::string_view expected) {
    const double value = read_number(text);
    if (!(value >= least && value <= most)) fail(text, expected);
    return value;
}

std::vector<double> read_numbers(const SourceText& text, std::size_t count) {
    const std::vector<SourceText> parts = parts_of(text, ',');
    if (parts.size() != count) fail(text, std::to_string(count) + " numbers separated by commas");
    std::vector<double> numbers;
    for (const SourceText& part : parts)
        numbers.push_back(
            read_number_in(part, -most_coordinate, most_coordinate, "numbers from -1e100 to 1e100"));
    return numbers;
}

glm::dvec3 read_point(const SourceText& text) {
    const std::vector<double> numbers = read_numbers(text, 3);
    return {numbers[0], numbers[1], numbers[2]};
}

glm::dvec3 read_direction(const SourceText& text) {
    const glm::dvec3 direction = read_point(text);
    if (direction == glm::dvec3(0)) fail(text, "a direction other than 0,0,0");
    return direction;
}

ImageSize read_size(std::string_view text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos)
        throw Error("expected WIDTHxHEIGHT, as 640x480, found '" + std::string(text) + "'");
    const auto side = [](std::string_view digits) {
        return static_cast<std::uint32_t>(read_whole_number(digits, 1, render::most_pixels_a_side));
    };
    return {side(text.substr(0, cross)), side(text.substr(cross + 1))};
}

render::Colour read_colour(const SourceText& text) {
    std::array<double, 3> stored{};
    if (text.text().starts_with('#')) {
        stored = read_web_colour(text);
    } else if (text.text().find(',') == std::string_view::npos) {
        stored.fill(read_number(text));
    } else {
        const std::vector<double> numbers = read_numbers(text, 3);
        std::copy(numbers.begin(), numbers.end(), stored.begin());
    }
    render::Colour colour{};
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(stored[i] >= 0 && stored[i] <= 1)) fail(text, "a colour with channels from 0 to 1");
        colour[i] = static_cast<float>(render::linear_from_srgb(stored[i]));
    }
    return colour;
}

void add_region(ClipRegion& region, const SourceText& text) {
    const std::size_t colon = std::min(text.text().find(':'), text.size());
    const std::string_view kind = text.text().substr(0, colon);
    const SourceText rest = text.section(std::min(colon + 1, text.size()), text.size());
    if (kind == "sphere") {
        region.add(Ball{glm::dvec3(0), read_number_in(rest, 0, most_coordinate, "a radius from 0 to 1e100")});
    } else if (kind == "box") {
        const std::vector<double> b = read_numbers(rest, 6);
        if (b[0] > b[3] || b[1] > b[4] || b[2] > b[5])
            fail(text, "the lower corner of a box before the upper one");
        region.add(Box{{b[0], b[1], b[2]}, {b[3], b[4], b[5]}});
    } else if (kind == "halfspace") {
        const std::vector<double> h = read_numbers(rest, 4);
        if (h[0] == 0 && h[1] == 0 && h[2] == 0) fail(text, "a half-space with a normal other than 0,0,0");
        region.add(HalfSpace{{h[0], h[1], h[2]}, h[3]});
    } else {
        fail(text, "sphere:R, box:x0,y0,z0,x1,y1,z1 or halfspace:a,b,c,d");
    }
}

DirectionalLight read_light(const SourceText& text) {
    const std::vector<SourceText> parts = parts_of(text, ';');
    if (parts.size() > 3) fail(text, "x,y,z or x,y,z;COLOUR or x,y,z;COLOUR;DEGREES");
    DirectionalLight light;
    light.towards = read_direction(parts[0]);
    if (parts.size() > 1) light.colour = read_colour(parts[1]);
    if (parts.size() > 2)
        light.angular_radius = read_number_in(parts[2], 0, 45, "an angle from 0 to 45 degrees");
    return light;
}

} // namespace eliminant::app
