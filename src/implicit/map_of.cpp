#include "implicit/map_of.hpp"

#include <numeric>
#include <optional>

namespace eliminant::implicit {

namespace {

RationalMap map_with(const Parametrization& parametrization, std::optional<std::size_t> parameter,
                     base::Run& run) {
    const algebra::Ring& given = parametrization.ring();
    std::vector<std::string> names;
    std::vector<std::size_t> place(given.variable_count());
    const auto take = [&](std::size_t i) {
        place[i] = names.size();
        names.push_back(given.names()[i]);
    };
    for (const std::size_t i : parametrization.parameters()) take(i);
    for (const std::size_t i : parametrization.constants()) take(i);
    const algebra::Ring ring(given.field(), std::move(names));

    std::vector<std::size_t> constants(parametrization.constants().size());
    std::iota(constants.begin(), constants.end(), parametrization.parameters().size());
    std::vector<CosineSine> rotations;
    for (const auto& [cosine, sine] : parametrization.rotations())
        rotations.emplace_back(place[cosine], place[sine]);
    std::vector<algebra::RationalFunction> functions;
    for (const Coordinate& coordinate : parametrization.coordinates())
        functions.emplace_back(coordinate.value.numerator.in_ring(ring, place),
                               coordinate.value.denominator.in_ring(ring, place));
    if (parameter) functions.emplace_back(algebra::Polynomial::variable(ring, place[*parameter]));
    return rational_map(ring, constants, rotations, functions, run);
}

} // namespace

RationalMap map_of(const Parametrization& parametrization, base::Run& run) {
    return map_with(parametrization, std::nullopt, run);
}

RationalMap graph_of(const Parametrization& parametrization, std::size_t parameter, base::Run& run) {
    return map_with(parametrization, parameter, run);
}

} // namespace eliminant::implicit
