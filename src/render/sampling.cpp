#include "render/sampling.hpp"

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

/// Cosine and sine of a number of turns.
Sample at_angle(double turns, double y) {
    const double angle = 2 * std::numbers::pi * turns;
    return {std::cos(angle), std::sin(angle), y};
}

} // namespace

SamplePattern::SamplePattern(std::uint32_t count) {
    samples_.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i)
        samples_.push_back(at_angle((i + 0.5) / count, radical_inverse(i)));
}

SampleSet::SampleSet(const SamplePattern& pattern, std::uint64_t seed, std::uint64_t column,
                     std::uint64_t row, std::uint64_t purpose)
    : pattern_(pattern) {
    const std::uint64_t place = mixed(mixed(mixed(mixed(seed) ^ column) ^ row) ^ purpose);
    shift_ = at_angle(unit_from(place), unit_from(mixed(place)));
}

Frame::Frame(const glm::dvec3& axis) : axis_(axis) {
    // The frame of Duff, Burgess, Christensen, Hery, Kensler, Liani and Villemin (JCGT 2017): no case fails.
    const double sign = std::copysign(1.0, axis.z);
    const double a = -1 / (sign + axis.z);
    const double b = axis.x * axis.y * a;
    first_ = {1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
    second_ = {b, sign + axis.y * axis.y * a, -axis.y};
}

} // namespace eliminant::render
