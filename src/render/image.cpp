#include "eliminant/render/image.hpp"

#include "eliminant/base/error.hpp"

#include <algorithm>
#include <limits>
#include <string>

namespace eliminant::render {

void check_size(ImageSize size) {
    const auto possible = [](std::uint32_t side) { return side > 0 && side <= most_pixels_a_side; };
    if (!possible(size.width) || !possible(size.height))
        throw DomainError("picture: expected sides of 1 to " + std::to_string(most_pixels_a_side) +
                          " pixels, found " + std::to_string(size.width) + "x" + std::to_string(size.height));
}

Image::Image(ImageSize size) : size_(size) {
    check_size(size);
    colours_.resize(3 * size.pixels());
    depths_.resize(size.pixels(), std::numeric_limits<double>::infinity());
}

Colour Image::colour(std::uint32_t column, std::uint32_t row) const {
    const float* rgb = &colours_[3 * index(column, row)];
    return {rgb[0], rgb[1], rgb[2]};
}

void Image::set(std::uint32_t column, std::uint32_t row, Colour colour, double depth) {
    std::copy(colour.begin(), colour.end(), &colours_[3 * index(column, row)]);
    depths_[index(column, row)] = depth;
}

ImageRows Image::rows() const { return {size_.width, 0, size_.height, colours_, depths_}; }

void Image::assign(const ImageRows& rows) {
    if (rows.width != size_.width || rows.first > size_.height || rows.count > size_.height - rows.first)
        throw DomainError("picture: a band of rows does not fit it");
    const auto begin = static_cast<std::ptrdiff_t>(index(0, rows.first));
    std::copy(rows.colours.begin(), rows.colours.end(), colours_.begin() + 3 * begin);
    std::copy(rows.depths.begin(), rows.depths.end(), depths_.begin() + begin);
}

} // namespace eliminant::render
