// Points of an image in which some coordinates have given values.
#pragma once

#include "implicit/verify_map_modulo.hpp"

#include <optional>
#include <vector>

namespace eliminant::implicit {

/// Coordinates that can be given values: constants, which are so by themselves, and at most one of the
/// others.
struct FixedCoordinates {
    std::vector<std::size_t> constants;          ///< components that are a constant each
    std::vector<std::size_t> constant_variables; ///< the variables of those, in the map's ring
    std::optional<std::size_t> coordinate;       ///< a component
    std::size_t variable = 0;                    ///< for which the coordinate's equation is solved
};

/// General points of a section of the image: all parameters but one are chosen at random, and for that one an
/// equation in one variable is solved. It has one root in the field on average.
class PlanePoints {
  public:
    using Element = MapModulo::Element;

    /// \param constant_values, value what the fixed coordinates are; `value` is not used without a coordinate
    PlanePoints(const MapModulo& map, const FixedCoordinates& fixed, std::vector<Element> constant_values,
                Element value, std::uint64_t seed, base::Run& run);

    /// All coordinates of the next point; nullopt if none was found for long.
    std::optional<std::vector<Element>> next();

  private:
    std::vector<Element> random_parameters();
    std::optional<std::vector<Element>> solve();

    const MapModulo& map_;
    const FixedCoordinates& fixed_;
    std::vector<Element> constant_values_;
    Element value_;
    algebra::Random random_;
    base::Run& run_;
};

} // namespace eliminant::implicit
