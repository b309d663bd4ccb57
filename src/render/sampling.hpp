/// \file
/// Directions that look random and are decided by a seed, a place and a number.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

namespace eliminant::render {

/// The samples of one pixel for one purpose: a Hammersley set in the unit square, shifted around the torus by
/// two numbers that the seed, the pixel and the purpose decide. Neighbouring pixels so have unrelated noise,
/// each pixel's own samples are spread evenly, and no order of computation matters.
class SampleSet {
  public:
    SampleSet(std::uint64_t seed, std::uint64_t column, std::uint64_t row, std::uint64_t purpose,
              std::uint32_t count);

    struct Point {
        double x = 0; ///< in [0, 1)
        double y = 0; ///< in [0, 1)
    };
    /// The sample of this index below `count`.
    Point operator[](std::uint32_t index) const;

  private:
    std::uint32_t count_;
    Point shift_;
};

/// A unit vector, uniform over the cone of directions around `axis` (of length 1) whose cosine with it is at
/// least `least_cosine`.
glm::dvec3 direction_in_cone(const glm::dvec3& axis, double least_cosine, SampleSet::Point sample);

/// A unit vector over the hemisphere around `normal` (of length 1), with a density proportional to the
/// cosine.
glm::dvec3 direction_by_cosine(const glm::dvec3& normal, SampleSet::Point sample);

} // namespace eliminant::render
