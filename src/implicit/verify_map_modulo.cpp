#include "implicit/verify_map_modulo.hpp"

#include <algorithm>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::PrimeField;
namespace dense = algebra::dense;

MapModulo::MapModulo(const RationalMap& map, const PrimeField& field)
    : field_(field), variable_count_(map.ring.variable_count()), degrees_(variable_count_, 0) {
    const auto note_degrees = [this](const Polynomial& f) {
        for (std::size_t i = 0; i < variable_count_ && !f.is_zero(); ++i)
            degrees_[i] = std::max(degrees_[i], static_cast<std::uint64_t>(f.degree(i)));
    };
    note_degrees(map.denominator);
    for (const RationalMap::Component& component : map.components) {
        note_degrees(component.numerator);
        numerators_.push_back(terms_of(component.numerator));
        over_denominator_.push_back(component.over_denominator);
    }
    denominator_ = terms_of(map.denominator);
}

MapModulo::Terms MapModulo::terms_of(const Polynomial& f) const {
    Terms terms;
    for (std::size_t i = 0; i < f.size(); ++i) {
        terms.coefficients.push_back(
            field_.from_fraction(f.integer_terms().coefficients[i], f.denominator()));
        for (std::size_t j = 0; j < variable_count_; ++j) terms.exponents.push_back(f.exponent(i, j));
    }
    return terms;
}

std::vector<std::vector<MapModulo::Element>> MapModulo::powers_of(std::span<const Element> point) const {
    std::vector<std::vector<Element>> powers;
    for (std::size_t i = 0; i < variable_count_; ++i)
        powers.push_back(dense::powers(field_, point[i], degrees_[i] + 1));
    return powers;
}

void MapModulo::restrict_to(const Terms& f, std::span<const std::vector<Element>> powers,
                            std::size_t variable, Univariate& target) const {
    target.assign(variable < variable_count_ ? degrees_[variable] + 1 : 1, 0);
    for (std::size_t i = 0; i < f.coefficients.size(); ++i) {
        const std::uint64_t* const exponents =
            f.exponents.data() + i * variable_count_; // none without parameters
        Element value = f.coefficients[i];
        for (std::size_t j = 0; j < variable_count_; ++j)
            if (j != variable && exponents[j] != 0) value = field_.multiply(value, powers[j][exponents[j]]);
        Element& sum = target[variable < variable_count_ ? exponents[variable] : 0];
        sum = field_.add(sum, value);
    }
    dense::trim(target);
}

MapModulo::Line MapModulo::restricted(std::span<const Element> point, std::size_t variable) const {
    const auto powers = powers_of(point);
    Line line;
    line.numerators.resize(numerators_.size());
    for (std::size_t i = 0; i < numerators_.size(); ++i)
        restrict_to(numerators_[i], powers, variable, line.numerators[i]);
    restrict_to(denominator_, powers, variable, line.denominator);
    return line;
}

std::optional<std::vector<MapModulo::Element>> MapModulo::image(const Line& line, Element parameter) const {
    const Element bottom = dense::evaluate<PrimeField>(field_, line.denominator, parameter);
    if (bottom == 0) return std::nullopt;
    const Element inverse = bottom == 1 ? 1 : field_.inverse(bottom);
    std::vector<Element> coordinates(numerators_.size());
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        coordinates[i] = dense::evaluate<PrimeField>(field_, line.numerators[i], parameter);
        if (over_denominator_[i]) coordinates[i] = field_.multiply(coordinates[i], inverse);
    }
    return coordinates;
}

std::optional<std::vector<MapModulo::Element>> MapModulo::image(std::span<const Element> point) const {
    return image(restricted(point, variable_count_), 0);
}

std::vector<MapModulo::Element> MapModulo::random_point(algebra::Random& random) const {
    std::vector<Element> point(variable_count_);
    for (Element& value : point) value = random.below(field_.characteristic());
    return point;
}

std::optional<std::vector<MapModulo::Element>> MapModulo::random_image(algebra::Random& random) const {
    constexpr int attempts = 50;
    for (int i = 0; i < attempts; ++i)
        if (auto coordinates = image(random_point(random))) return coordinates;
    return std::nullopt;
}

} // namespace eliminant::implicit
