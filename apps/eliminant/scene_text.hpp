/// \file
/// Numbers, points, colours, regions and lights as they are written on the command line.
#pragma once

#include "eliminant/base/source_text.hpp"
#include "eliminant/render/image.hpp"
#include "eliminant/render/lighting.hpp"
#include "eliminant/scene/clip_region.hpp"

#include <glm/vec3.hpp>

#include <string_view>
#include <vector>

namespace eliminant::app {

/// An integer, decimal or fraction, as `2`, `-0.5`, `1e-3`, `216/65`: the double nearest to it.
/// \throws ParseError, and UsageError if no double is that large
double read_number(const SourceText& text);

/// The same within bounds, which `expected` names. \throws UsageError if it is not, too
double read_number_in(const SourceText& text, double least, double most, std::string_view expected);

/// So many numbers, separated by commas. \throws ParseError, UsageError
std::vector<double> read_numbers(const SourceText& text, std::size_t count);

/// `x,y,z`, none of them beyond most_coordinate. \throws ParseError, UsageError
glm::dvec3 read_point(const SourceText& text);

/// The same other than 0,0,0. \throws ParseError, UsageError
glm::dvec3 read_direction(const SourceText& text);

/// Squares and cubes of coordinates up to here are finite.
inline constexpr double most_coordinate = 1e100;

/// A picture's size, as `640x480`. \throws UsageError
ImageSize read_size(std::string_view text);

/// `#rrggbb` or `#rgb` as on the web, three numbers `r,g,b` from 0 to 1, or one number for a grey; all of
/// them sRGB, as they are stored. The result is linear. \throws ParseError, UsageError
render::Colour read_colour(const SourceText& text);

/// Adds what `sphere:R`, `box:x0,y0,z0,x1,y1,z1` or `halfspace:a,b,c,d` (ax + by + cz ≤ d) stands for.
/// \throws ParseError, UsageError
void add_region(ClipRegion& region, const SourceText& text);

/// `x,y,z[;COLOUR[;DEGREES]]`: where the light is, its colour, and how large it looks.
/// \throws ParseError, UsageError
DirectionalLight read_light(const SourceText& text);

} // namespace eliminant::app
