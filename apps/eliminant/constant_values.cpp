#include "constant_values.hpp"

#include "suggestion.hpp"

#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/algebra/parse.hpp"

#include <algorithm>

namespace eliminant::app {

namespace {

[[noreturn]] void reject_without_value(const std::string& name, std::string_view owner) {
    std::string message = "--set: expected a value for the constant '";
    message.append(name).append("' of ").append(owner);
    throw UsageError(message.append(", as --set ").append(name).append("=2, found none"));
}

} // namespace

void ConstantValues::declare(OptionSet& options) {
    options.values("set", "NAME=VALUE", "the value of a constant, as r=2 or r=1/3; once for each constant",
                   [this](std::string_view text) { set(text); });
}

void ConstantValues::set(std::string_view text) {
    const std::size_t sign = text.find('=');
    std::string name(text.substr(0, sign));
    name.erase(0, name.find_first_not_of(' '));
    name.erase(name.find_last_not_of(' ') + 1);
    if (sign == std::string_view::npos || !algebra::is_identifier(name))
        throw Error("expected NAME=VALUE, as r=2, found '" + std::string(text) + "'");
    Value value{name, parse_rational(SourceText(text.substr(sign + 1), "--set " + name))};
    const auto earlier = std::ranges::find(values_, name, &Value::name);
    if (earlier == values_.end())
        values_.push_back(std::move(value));
    else
        *earlier = std::move(value); // the last of several wins, as with every option
}

std::vector<mpq_class> ConstantValues::of(const Ring& ring, std::span<const std::size_t> constants,
                                          std::string_view owner) const {
    std::vector<mpq_class> result;
    std::vector<std::string_view> names;
    for (const std::size_t variable : constants) {
        const std::string& name = ring.names()[variable];
        names.push_back(name);
        const auto found = std::ranges::find(values_, name, &Value::name);
        if (found == values_.end()) reject_without_value(name, owner);
        result.push_back(found->value);
    }
    for (const Value& value : values_)
        if (std::ranges::find(names, value.name) == names.end())
            throw UsageError("--set: expected a constant of " + std::string(owner) + ", found '" +
                             value.name + "'" + did_you_mean(value.name, names));
    return result;
}

Parametrization ConstantValues::put_into(const Parametrization& parametrization, std::string_view owner,
                                         Run& run) const {
    const Ring& given = parametrization.ring();
    const std::vector<mpq_class> values = of(given, parametrization.constants(), owner);
    std::vector<std::string> names;
    std::vector<std::size_t> place(given.variable_count(), Polynomial::dropped);
    for (const std::size_t parameter : parametrization.parameters()) {
        place[parameter] = names.size();
        names.push_back(given.names()[parameter]);
    }
    const Ring ring(given.field(), std::move(names));
    const auto specialised = [&](const Polynomial& f) {
        return evaluate(f, parametrization.constants(), values, run).in_ring(ring, place);
    };
    std::vector<Coordinate> coordinates;
    for (const auto& [name, value] : parametrization.coordinates()) {
        const RationalFunction f(specialised(value.numerator), specialised(value.denominator));
        coordinates.push_back({name, in_lowest_terms(f, run)});
    }
    std::vector<Rotation> rotations;
    for (const auto& [cosine, sine] : parametrization.rotations())
        rotations.push_back({place[cosine], place[sine]});
    std::vector<Polynomial> relations;
    for (const Polynomial& relation : parametrization.relations()) relations.push_back(specialised(relation));
    return {ring,
            {},
            std::move(coordinates),
            std::move(rotations),
            std::move(relations),
            parametrization.warnings()};
}

} // namespace eliminant::app
