#include "render/sampling.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eliminant::render {
namespace {

/// The finaliser of SplitMix64 (Steele, Lea and Flood 2014): every bit of the result depends on every bit of
/// x.
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

/// The top 53 bits as a number in [0, 1).
double unit_from(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

/// The binary digits of the index mirrored at the point, a number in [0, 1).
double radical_inverse(std::uint32_t index) {
    std::uint32_t mirrored = 0;
    for (int bit = 0; bit < 32; ++bit) mirrored |= ((index >> bit) & 1U) << (31 - bit);
    return mirrored * 0x1p-32;
}

double wrapped(double x) { return x < 1 ? x : x - 1; }

/// `local` in a right-handed frame whose third axis is `axis`.
glm::dvec3 around(const glm::dvec3& axis, const glm::dvec3& local) {
    // The frame of Duff, Burgess, Christensen, Hery, Kensler, Liani and Villemin (JCGT 2017): no case fails.
    const double sign = std::copysign(1.0, axis.z);
    const double a = -1 / (sign + axis.z);
    const double b = axis.x * axis.y * a;
    const glm::dvec3 first(1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x);
    const glm::dvec3 second(b, sign + axis.y * axis.y * a, -axis.y);
    return glm::normalize(local.x * first + local.y * second + local.z * axis);
}

glm::dvec3 on_circle(double radius, double turn, double height) {
    const double angle = 2 * std::numbers::pi * turn;
    return {radius * std::cos(angle), radius * std::sin(angle), height};
}

} // namespace

SampleSet::SampleSet(std::uint64_t seed, std::uint64_t column, std::uint64_t row, std::uint64_t purpose,
                     std::uint32_t count)
    : count_(count) {
    const std::uint64_t place = mixed(mixed(mixed(mixed(seed) ^ column) ^ row) ^ purpose);
    shift_ = {unit_from(place), unit_from(mixed(place))};
}

SampleSet::Point SampleSet::operator[](std::uint32_t index) const {
    return {wrapped((index + 0.5) / count_ + shift_.x), wrapped(radical_inverse(index) + shift_.y)};
}

glm::dvec3 direction_in_cone(const glm::dvec3& axis, double least_cosine, SampleSet::Point sample) {
    // By Archimedes, heights on the sphere are uniform.
    const double height = 1 - sample.y * (1 - least_cosine);
    return around(axis, on_circle(std::sqrt(std::max(0.0, 1 - height * height)), sample.x, height));
}

glm::dvec3 direction_by_cosine(const glm::dvec3& normal, SampleSet::Point sample) {
    // Malley: uniform in the disc, projected up to the hemisphere.
    return around(normal, on_circle(std::sqrt(sample.y), sample.x, std::sqrt(1 - sample.y)));
}

} // namespace eliminant::render
