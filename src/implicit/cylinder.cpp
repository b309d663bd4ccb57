#include "implicit/cylinder.hpp"

#include "eliminant/algebra/calculus.hpp"
#include "eliminant/algebra/evaluation.hpp"

#include <algorithm>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::Ring;

namespace {

/// The derivatives of the coordinates by a parameter, if they are all constant and not all zero.
std::optional<std::vector<mpq_class>> constant_direction(const RationalMap& map, std::size_t parameter) {
    if (map.denominator.degree(parameter) > 0) return std::nullopt;
    std::vector<mpq_class> direction;
    for (const auto& [numerator, over_denominator] : map.components) {
        const Polynomial slope = derivative(numerator, parameter);
        if (!slope.is_constant() || (over_denominator && !slope.is_zero())) return std::nullopt;
        direction.push_back(slope.is_zero() ? mpq_class(0) : slope.leading_coefficient());
    }
    if (std::ranges::all_of(direction, [](const mpq_class& a) { return a == 0; })) return std::nullopt;
    return direction;
}

} // namespace

std::optional<Cylinder> as_cylinder(const RationalMap& map) {
    if (map.components.size() - map.constants.size() < 3) return std::nullopt; // points are no base
    for (const std::size_t parameter : map.parameters) {
        auto direction = constant_direction(map, parameter);
        if (!direction) continue;
        const auto last = std::ranges::find_if(direction->rbegin(), direction->rend(),
                                               [](const mpq_class& a) { return a != 0; });
        Cylinder cylinder{map, static_cast<std::size_t>(direction->rend() - last) - 1, std::move(*direction)};
        const mpq_class length = cylinder.slope[cylinder.removed];
        auto& components = cylinder.base.components;
        for (std::size_t i = 0; i < components.size(); ++i) {
            cylinder.slope[i] /= length;
            if (i != cylinder.removed && cylinder.slope[i] != 0)
                components[i].numerator -=
                    map.components[cylinder.removed].numerator.scaled(cylinder.slope[i]);
        }
        components.erase(components.begin() + static_cast<std::ptrdiff_t>(cylinder.removed));
        std::erase(cylinder.base.parameters, parameter);
        return cylinder;
    }
    return std::nullopt;
}

Ring base_ring(const Cylinder& cylinder, const Ring& ring) {
    std::vector<std::string> names = ring.names();
    names.erase(names.begin() + static_cast<std::ptrdiff_t>(cylinder.removed));
    const std::size_t constants = cylinder.base.constants.size();
    if (constants == 0) return {ring.field(), std::move(names)};
    std::vector<std::size_t> coordinates(names.size() - constants);
    for (std::size_t i = 0; i < coordinates.size(); ++i) coordinates[i] = i;
    return {ring.field(), std::move(names), algebra::MonomialOrder::blocks({std::move(coordinates)})};
}

Polynomial lifted(const Cylinder& cylinder, const Polynomial& equation, const Ring& ring, base::Run& run) {
    const Polynomial removed = Polynomial::variable(ring, cylinder.removed);
    std::vector<Polynomial> images;
    for (std::size_t i = 0; i < ring.variable_count(); ++i)
        if (i != cylinder.removed)
            images.push_back(Polynomial::variable(ring, i) - removed.scaled(cylinder.slope[i]));
    return compose(equation, ring, images, run).primitive_part();
}

} // namespace eliminant::implicit
