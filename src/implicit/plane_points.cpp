#include "implicit/plane_points.hpp"

#include "implicit/roots_modulo.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::implicit {

namespace dense = algebra::dense;
using algebra::PrimeField;

PlanePoints::PlanePoints(const MapModulo& map, const FixedCoordinates& fixed,
                         std::vector<Element> constant_values, Element value, std::uint64_t seed,
                         base::Run& run)
    : map_(map), fixed_(fixed), constant_values_(std::move(constant_values)), value_(value), random_(seed),
      run_(run) {}

std::vector<PlanePoints::Element> PlanePoints::random_parameters() {
    std::vector<Element> point = map_.random_point(random_);
    for (std::size_t i = 0; i < constant_values_.size(); ++i)
        point[fixed_.constant_variables[i]] = constant_values_[i];
    return point;
}

std::optional<std::vector<PlanePoints::Element>> PlanePoints::solve() {
    const PrimeField& field = map_.field();
    const std::size_t coordinate = *fixed_.coordinate;
    const MapModulo::Line line = map_.restricted(random_parameters(), fixed_.variable);
    // numerator − value·denominator
    dense::Vector equation = line.numerators[coordinate];
    if (map_.is_over_denominator(coordinate)) {
        equation.resize(std::max(equation.size(), line.denominator.size()), 0);
        dense::add_multiple<PrimeField>(field, equation, line.denominator, field.negate(value_));
    } else {
        equation.resize(std::max<std::size_t>(equation.size(), 1), 0);
        equation[0] = field.subtract(equation[0], value_);
    }
    dense::trim(equation);
    if (equation.empty()) return std::nullopt;
    // Roots for the same other parameters are no general points to each other: where the map has a symmetry,
    // as Henneberg's surface, their images are equal, or have equal squares.
    for (const Element root : roots(field, std::move(equation), random_, run_))
        if (auto image = map_.image(line, root)) return image;
    return std::nullopt;
}

std::optional<std::vector<PlanePoints::Element>> PlanePoints::next() {
    constexpr int attempts = 200;
    for (int i = 0; i < attempts; ++i)
        if (auto image = fixed_.coordinate ? solve() : map_.image(random_parameters())) return image;
    return std::nullopt;
}

} // namespace eliminant::implicit
