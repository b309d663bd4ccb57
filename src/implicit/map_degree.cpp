#include "implicit/map_degree.hpp"

#include "algebra/random.hpp"
#include "algebra/univariate_mod_p.hpp"
#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/ideal/zero_dimensional.hpp"
#include "implicit/verify_map_modulo.hpp"

#include <algorithm>

namespace eliminant::implicit {

namespace dense = algebra::dense;
using algebra::Polynomial;
using algebra::PrimeField;
using algebra::Ring;
using Element = PrimeField::Element;

namespace {

/// The parameters that the map depends on.
std::vector<std::size_t> occurring_parameters(const RationalMap& map) {
    std::vector<std::size_t> occurring;
    for (const std::size_t variable : map.parameters) {
        const bool occurs = map.denominator.degree(variable) > 0 ||
                            std::ranges::any_of(map.components, [&](const auto& component) {
                                return component.numerator.degree(variable) > 0;
                            });
        if (occurs) occurring.push_back(variable);
    }
    return occurring;
}

/// Equation of the fibre for one coordinate x: numerator − x·denominator, or numerator − x.
dense::Vector fibre_equation(const MapModulo& map, const MapModulo::Line& line, std::size_t coordinate,
                             Element x) {
    const dense::Vector one = {1};
    const dense::Vector& bottom = map.is_over_denominator(coordinate) ? line.denominator : one;
    dense::Vector equation = line.numerators[coordinate];
    equation.resize(std::max(equation.size(), bottom.size()), 0);
    dense::add_multiple<PrimeField>(map.field(), equation, bottom, map.field().negate(x));
    dense::trim(equation);
    return equation;
}

/// Distinct roots of f that are no roots of g.
std::uint64_t count_roots(const PrimeField& field, dense::Vector f, const dense::Vector& g, base::Run& run) {
    for (dense::Vector common = dense::gcd(field, f, g, run); common.size() > 1;
         common = dense::gcd(field, f, g, run))
        f = dense::divide(field, f, common);
    dense::Vector derivative;
    for (std::size_t i = 1; i < f.size(); ++i)
        derivative.push_back(field.multiply(f[i], static_cast<Element>(i)));
    dense::trim(derivative);
    return f.size() - dense::gcd(field, f, derivative, run).size();
}

std::optional<std::uint64_t> fibre_of_line(const MapModulo& map, std::span<const Element> point,
                                           std::span<const Element> image, std::size_t parameter,
                                           base::Run& run) {
    const MapModulo::Line line = map.restricted(point, parameter);
    dense::Vector common;
    for (std::size_t i = 0; i < image.size(); ++i)
        common = dense::gcd(map.field(), std::move(common), fibre_equation(map, line, i, image[i]), run);
    if (common.empty()) return std::nullopt;
    return count_roots(map.field(), std::move(common), line.denominator, run);
}

std::optional<std::uint64_t> fibre_of_space(const RationalMap& map, const PrimeField& field,
                                            std::span<const Element> point, std::span<const Element> image,
                                            std::span<const std::size_t> parameters, base::Run& run) {
    // The occurring parameters and 1/denominator are the unknowns; constants have the values of the point.
    std::vector<std::string> names;
    for (std::size_t i = 0; i <= parameters.size(); ++i)
        names.push_back(std::string("t").append(std::to_string(i)));
    const Ring ring(algebra::CoefficientField::prime(field.characteristic()), std::move(names));
    std::vector<Polynomial> images;
    for (const Element value : point) images.push_back(Polynomial::constant(ring, mpq_class(value)));
    for (std::size_t i = 0; i < parameters.size(); ++i) images[parameters[i]] = Polynomial::variable(ring, i);

    const Polynomial bottom = compose(map.denominator, ring, images, run);
    const Polynomial reciprocal = Polynomial::variable(ring, parameters.size());
    std::vector<Polynomial> generators = {reciprocal * bottom - Polynomial::constant(ring, 1)};
    for (std::size_t i = 0; i + map.constants.size() < map.components.size(); ++i) {
        const Polynomial top = compose(map.components[i].numerator, ring, images, run);
        const mpq_class x(image[i]);
        generators.push_back(map.components[i].over_denominator ? top - bottom.scaled(x)
                                                                : top - Polynomial::constant(ring, x));
    }
    const auto dimension = vector_space_dimension(ideal::Ideal(ring, std::move(generators)), run);
    if (!dimension) return std::nullopt;
    return dimension->get_ui();
}

/// nullopt if the fibre is infinite, or the random point was unlucky.
std::optional<std::uint64_t> fibre_size(const RationalMap& map, const PrimeField& field,
                                        std::span<const std::size_t> parameters, base::Run& run) {
    const MapModulo reduced(map, field);
    algebra::Random random(run.seed() + field.characteristic());
    const std::vector<Element> point = reduced.random_point(random);
    const auto image = reduced.image(point);
    if (!image) return std::nullopt;
    if (parameters.size() == 1) return fibre_of_line(reduced, point, *image, parameters.front(), run);
    return fibre_of_space(map, field, point, *image, parameters, run);
}

} // namespace

std::int64_t degree_of(const RationalMap& map) {
    std::int64_t degree = map.denominator.total_degree();
    for (const auto& component : map.components)
        degree = std::max(degree, component.numerator.total_degree());
    return degree;
}

std::optional<std::uint64_t> map_degree(const RationalMap& map, base::Run& run) {
    if (degree_of(map) > max_counted_degree) return std::nullopt;
    const std::vector<std::size_t> parameters = occurring_parameters(map);
    // One that does not occur has infinitely many values.
    if (parameters.empty() || parameters.size() < map.parameters.size()) return std::nullopt;
    std::optional<std::uint64_t> first;
    std::uint64_t prime = std::uint64_t{1} << 30;
    for (int i = 0; i < 2; ++i) {
        do prime = algebra::previous_prime(prime);
        while (std::ranges::any_of(
            map.components, [&](const auto& c) { return c.numerator.denominator().residue(prime) == 0; }));
        const auto size = fibre_size(map, PrimeField(prime), parameters, run);
        if (!size || (first && *size != *first)) return std::nullopt;
        first = size;
    }
    return first;
}

} // namespace eliminant::implicit
