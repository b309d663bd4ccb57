#include "implicit/map_of.hpp"

#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace eliminant::implicit {

namespace {

/// A parametrization in a ring of parameters, then constants.
struct Rearranged {
    explicit Rearranged(const Parametrization& parametrization)
        : place(parametrization.ring().variable_count()), ring(ring_for(parametrization)),
          constants(parametrization.constants().size()) {
        std::iota(constants.begin(), constants.end(), parametrization.parameters().size());
        for (const auto& [cosine, sine] : parametrization.rotations())
            rotations.emplace_back(place[cosine], place[sine]);
        for (const Coordinate& coordinate : parametrization.coordinates())
            functions.emplace_back(coordinate.value.numerator.in_ring(ring, place),
                                   coordinate.value.denominator.in_ring(ring, place));
    }

    std::vector<std::size_t> place; ///< of each variable
    algebra::Ring ring;
    std::vector<std::size_t> constants;
    std::vector<CosineSine> rotations;
    std::vector<algebra::RationalFunction> functions;

  private:
    algebra::Ring ring_for(const Parametrization& parametrization) {
        const algebra::Ring& given = parametrization.ring();
        std::vector<std::string> names;
        for (const auto* variables : {&parametrization.parameters(), &parametrization.constants()})
            for (const std::size_t i : *variables) {
                place[i] = names.size();
                names.push_back(given.names()[i]);
            }
        return {given.field(), std::move(names)};
    }
};

RationalMap map_with(const Parametrization& parametrization, std::optional<std::size_t> parameter,
                     base::Run& run) {
    Rearranged parts(parametrization);
    if (parameter)
        parts.functions.emplace_back(algebra::Polynomial::variable(parts.ring, parts.place[*parameter]));
    return rational_map(parts.ring, parts.constants, parts.rotations, parts.functions, run);
}

} // namespace

RationalMap map_of(const Parametrization& parametrization, base::Run& run) {
    return map_with(parametrization, std::nullopt, run);
}

RationalMap graph_of(const Parametrization& parametrization, std::size_t parameter, base::Run& run) {
    return map_with(parametrization, parameter, run);
}

DomainMap domain_of(const Parametrization& parametrization, base::Run& run) {
    const Rearranged parts(parametrization);
    std::vector<algebra::Polynomial> relations;
    for (const algebra::Polynomial& f : parametrization.relations())
        relations.push_back(f.in_ring(parts.ring, parts.place));
    return domain_map(parts.ring, parametrization.parameters().size(), parts.rotations, relations,
                      parts.functions, run);
}

} // namespace eliminant::implicit
