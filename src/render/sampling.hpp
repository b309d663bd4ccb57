/// \file
/// Directions that look random and are decided by a seed, a place and a number.
#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace eliminant::render {

/// A point of the unit square as directions use it: the first coordinate is an angle in turns.
struct Sample {
    double cosine = 1; ///< of the angle
    double sine = 0;
    double y = 0; ///< the second coordinate, in [0, 1)
};

/// A Hammersley set.
class SamplePattern {
  public:
    explicit SamplePattern(std::uint32_t count);

    std::uint32_t size() const { return static_cast<std::uint32_t>(samples_.size()); }
    const Sample& operator[](std::uint32_t index) const { return samples_[index]; }

  private:
    std::vector<Sample> samples_;
};

/// The samples of one pixel for one purpose: the pattern, shifted around the torus by two numbers that the
/// seed, the pixel and the purpose decide. Neighbouring pixels so have unrelated noise, each pixel's own
/// samples are spread evenly, and no order of computation matters. The pattern must outlive it.
class SampleSet {
  public:
    SampleSet(const SamplePattern& pattern, std::uint64_t seed, std::uint64_t column, std::uint64_t row,
              std::uint64_t purpose);

    /// The sample of this index below the pattern's size. A shift of the angle is a rotation.
    Sample operator[](std::uint32_t index) const {
        const Sample& s = pattern_[index];
        const double y = s.y + shift_.y;
        return {s.cosine * shift_.cosine - s.sine * shift_.sine,
                s.sine * shift_.cosine + s.cosine * shift_.sine, y < 1 ? y : y - 1};
    }

  private:
    const SamplePattern& pattern_;
    Sample shift_;
};

/// A right-handed frame around an axis of length 1.
class Frame {
  public:
    explicit Frame(const glm::dvec3& axis);

    /// A unit vector, uniform over the cone of directions around the axis whose cosine with it is at least
    /// `least_cosine`.
    glm::dvec3 in_cone(double least_cosine, const Sample& sample) const {
        // By Archimedes, heights on the sphere are uniform.
        const double height = 1 - sample.y * (1 - least_cosine);
        return from_local(std::sqrt(std::max(0.0, 1 - height * height)), sample, height);
    }
    /// A unit vector on the rim of that cone; y has no meaning.
    glm::dvec3 on_rim(double least_cosine, Sample sample) const {
        sample.y = 1;
        return in_cone(least_cosine, sample);
    }
    /// A unit vector over the hemisphere around the axis, with a density proportional to the cosine.
    glm::dvec3 by_cosine(const Sample& sample) const {
        // Malley: uniform in the disc, projected up to the hemisphere.
        return from_local(std::sqrt(sample.y), sample, std::sqrt(1 - sample.y));
    }

  private:
    glm::dvec3 from_local(double radius, const Sample& sample, double height) const {
        return radius * sample.cosine * first_ + radius * sample.sine * second_ + height * axis_;
    }

    glm::dvec3 first_;
    glm::dvec3 second_;
    glm::dvec3 axis_;
};

} // namespace eliminant::render
