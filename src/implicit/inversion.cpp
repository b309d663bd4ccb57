#include "eliminant/implicit/inversion.hpp"

#include "eliminant/algebra/coefficients.hpp"
#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/base/error.hpp"
#include "implicit/closure.hpp"
#include "implicit/curve_inversion.hpp"
#include "implicit/hypersurface.hpp"
#include "implicit/map_degree.hpp"
#include "implicit/map_of.hpp"
#include "implicit/nullvector.hpp"
#include "implicit/projective_map.hpp"
#include "implicit/vanishing_polynomial.hpp"
#include "implicit/verify_map_modulo.hpp"
#include "implicit/verify_vanishing.hpp"

#include <algorithm>
#include <numeric>
#include <string>

namespace eliminant::implicit {

namespace dense = algebra::dense;
using algebra::Polynomial;
using algebra::PrimeField;
using algebra::Ring;

namespace {

using Exponents = std::span<const std::uint32_t>;

std::uint64_t degree_of(Exponents monomial) {
    return std::accumulate(monomial.begin(), monomial.end(), std::uint64_t{0});
}

bool divides(Exponents a, Exponents b) {
    return std::ranges::equal(a, b, [](std::uint32_t x, std::uint32_t y) { return x <= y; });
}

/// What t·D − N can consist of, column by column. Let m run through the monomials without t that are
/// standard, not leading monomials of equations of the image: the columns are, for e = 0, 1, …, the m of
/// degree e, then the t·m of degree e. A first dependence with t among its columns has D ≠ 0 on the image.
/// For otherwise D would itself be a dependence, and its last monomial m comes before t·m.
///
/// A first dependence without t is an equation of the image. Its last monomial, a leading one, is not
/// standard, nor are the multiples of that.
class Columns {
  public:
    /// \param coordinates how many, with t
    /// \param t which of them
    Columns(std::size_t coordinates, std::size_t t) : t_(t), leading_(coordinates) {}

    Support up_to(std::uint64_t degree) const {
        const std::vector<std::uint64_t> weights(leading_.coordinates() - 1, 1);
        std::vector<std::size_t> places(leading_.coordinates());
        std::iota(places.begin(), places.end(), std::size_t{0});
        places.erase(places.begin() + static_cast<std::ptrdiff_t>(t_));
        const Support monomials = Support::up_to(weights, degree).embedded(leading_.coordinates(), places);
        Support columns(leading_.coordinates());
        for (std::size_t first = 0, last = 0; first < monomials.size(); first = last) {
            while (last < monomials.size() && degree_of(monomials[last]) == degree_of(monomials[first]))
                ++last;
            for (const std::uint32_t power : {0U, 1U}) add(columns, monomials, first, last, power);
        }
        return columns;
    }

    bool has_t(const Support& columns, const Coefficients& dependence) const {
        for (std::size_t i = 0; i < dependence.size(); ++i)
            if (dependence[i] != 0 && columns[i][t_] != 0) return true;
        return false;
    }

    void exclude_multiples(Exponents leading) { leading_.add(leading); }

  private:
    bool is_standard(Exponents monomial) const {
        for (std::size_t i = 0; i < leading_.size(); ++i)
            if (divides(leading_[i], monomial)) return false;
        return true;
    }

    void add(Support& columns, const Support& monomials, std::size_t first, std::size_t last,
             std::uint32_t power) const {
        for (std::size_t i = first; i < last; ++i) {
            if (!is_standard(monomials[i])) continue;
            std::vector<std::uint32_t> column(monomials[i].begin(), monomials[i].end());
            column[t_] = power;
            columns.add(column);
        }
    }

    std::size_t t_;
    Support leading_; ///< monomials of equations of the image
};

/// The formula of one parameter modulo primes; the first prime tells its monomials.
class FormulaModulo {
  public:
    /// \param graph the map with t as a coordinate
    /// \param ring of the coordinates of the graph
    /// \param t which of them is the parameter
    FormulaModulo(const RationalMap& graph, const Ring& ring, std::size_t t, base::Run& run)
        : graph_(graph), ring_(ring), t_(t), columns_(graph.components.size(), t), run_(run) {}

    std::optional<Polynomial> image(const PrimeField& field) {
        const bool divides_denominator = std::ranges::any_of(graph_.components, [&](const auto& c) {
            return c.numerator.denominator().residue(field.characteristic()) == 0;
        });
        if (divides_denominator) return std::nullopt;
        const MapModulo map(graph_, field);
        algebra::Random random(run_.seed() + field.characteristic());
        const PointSource points = [&] { return map.random_image(random); };
        const Ring ring = ring_.with_field(algebra::CoefficientField::prime(field.characteristic()));
        if (by_moving_lines_) return image_by_moving_lines(map, ring);
        if (support_.size() == 0) {
            if (auto f = learn(field, points, ring)) return f;
            by_moving_lines_ = true;
            return image_by_moving_lines(map, ring);
        }
        const auto dependence = first_vanishing(field, support_, points, run_);
        if (!dependence || dependence->size() != support_.size()) return std::nullopt;
        return monic_polynomial(ring, support_, *dependence);
    }

  private:
    /// Of a plane curve, up to which the least degree is looked for: of 272 columns.
    static constexpr std::uint64_t max_degree_of_curves = 15;

    bool is_graph_over_plane_curve() const {
        const Polynomial parameter = Polynomial::variable(graph_.ring, graph_.parameters.front());
        return graph_.constants.empty() && graph_.parameters.size() == 1 && graph_.components.size() == 3 &&
               graph_.components[t_].numerator == parameter && !graph_.components[t_].over_denominator;
    }

    std::optional<Polynomial> image_by_moving_lines(const MapModulo& map, const Ring& ring) const {
        const PrimeField& field = map.field();
        const std::size_t variable = graph_.parameters.front();
        const MapModulo::Line whole =
            map.restricted(std::vector<std::uint32_t>(graph_.ring.variable_count(), 0), variable);
        MovingLine forms = {whole.denominator};
        for (std::size_t i = 0, k = 1; i < 3; ++i) {
            if (i == t_) continue;
            forms[k++] = map.is_over_denominator(i)
                             ? whole.numerators[i]
                             : dense::multiply(field, whole.numerators[i], whole.denominator);
        }
        dense::Vector common;
        for (const dense::Vector& form : forms) common = dense::gcd(field, std::move(common), form, run_);
        for (dense::Vector& form : forms) form = dense::divide(field, form, common);
        return curve_inversion_modulo(field, forms, ring, t_, run_.seed() + field.characteristic(), run_);
    }

    /// nullopt if there are too many columns before a formula.
    std::optional<Polynomial> learn(const PrimeField& field, const PointSource& points, const Ring& ring) {
        const std::uint64_t last = is_graph_over_plane_curve() ? max_degree_of_curves : ~std::uint64_t{0};
        // More columns than are needed cost less than trying one degree after the other.
        for (std::uint64_t degree = 1;; degree = std::min(last, degree + (degree + 3) / 4)) {
            run_.report([&] {
                return base::Progress{"search of a formula", 0, 0, "degree " + std::to_string(degree)};
            });
            Support columns = columns_.up_to(degree);
            while (const auto dependence = first_vanishing(field, columns, points, run_)) {
                if (columns_.has_t(columns, *dependence)) {
                    support_ = columns.where_nonzero(*dependence);
                    return monic_polynomial(ring, columns, *dependence);
                }
                columns_.exclude_multiples(columns[dependence->size() - 1]);
                columns = columns_.up_to(degree);
            }
            if (degree == last) return std::nullopt;
        }
    }

    const RationalMap& graph_;
    const Ring& ring_;
    std::size_t t_;
    Columns columns_;
    base::Run& run_;
    Support support_{0};
    bool by_moving_lines_ = false;
};

/// Whether f is not zero as a function of the parameters: it is not at a point modulo a prime.
bool is_nonzero_on_image(const RationalMap& map, const Polynomial& f, base::Run& run) {
    constexpr int attempts = 5;
    std::uint64_t prime = PrimeField::max_characteristic;
    while (std::ranges::any_of(map.components,
                               [&](const auto& c) { return c.numerator.denominator().residue(prime) == 0; }))
        prime = algebra::previous_prime(prime);
    const PrimeField field(prime);
    const MapModulo reduced(map, field);
    algebra::Random random(run.seed());
    for (int i = 0; i < attempts; ++i) {
        const auto point = reduced.random_image(random);
        if (point && algebra::evaluate(f, field, *point, run) != 0) return true;
    }
    return false;
}

/// t·D − N, proved, in the ring of the coordinates of the graph.
Polynomial formula_of_graph(const RationalMap& graph, const Ring& ring, std::size_t t, base::Run& run) {
    // That the first prime of all is one of the few that mislead is next to impossible.
    constexpr int attempts = 4;
    std::uint64_t prime_bound = Echelon::prime_bound;
    for (int i = 0; i < attempts; ++i, prime_bound -= prime_bound / 8) {
        FormulaModulo formula(graph, ring, t, run);
        const auto found = equation_from_images(
            ring, prime_bound, [&](const PrimeField& field) { return formula.image(field); }, run);
        if (found && is_nonzero_on_image(graph, coefficient(found->equation, t, 1), run) &&
            vanishes(graph, found->equation, vanishing_claim(graph, found->equation), run))
            return found->equation;
    }
    throw DomainError("inversion: formulas were found modulo primes that do not hold over QQ");
}

bool has_finite_fibres(const Parametrization& parametrization, const RationalMap& map, base::Run& run) {
    return dimension_at_least(parametrization, over_common_denominator(parametrization, run), run) ==
           map.parameters.size();
}

Coordinate formula_of(const Parametrization& parametrization, std::size_t parameter, const Ring& target,
                      base::Run& run) {
    const std::size_t t = parametrization.coordinates().size();
    std::vector<std::string> names = target.names();
    const std::string& name = parametrization.ring().names()[parameter];
    names.insert(names.begin() + static_cast<std::ptrdiff_t>(t), name);
    const Ring ring(target.field(), std::move(names));
    const Polynomial f = formula_of_graph(graph_of(parametrization, parameter, run), ring, t, run);
    Polynomial denominator = coefficient(f, t, 1).in_ring(target);
    Polynomial numerator = -coefficient(f, t, 0).in_ring(target);
    if (denominator.leading_coefficient() < 0) {
        denominator = -denominator;
        numerator = -numerator;
    }
    return {name, algebra::RationalFunction(std::move(numerator), std::move(denominator))};
}

} // namespace

Inversion inversion(const Parametrization& parametrization, base::Run& run) {
    if (!parametrization.relations().empty())
        throw DomainError("inversion: the parametrization has relations between its parameters");
    Inversion result{closure_ring(parametrization, algebra::MonomialOrder::degrevlex()), 1, {}};
    if (parametrization.parameters().empty()) return result;
    const RationalMap map = map_of(parametrization, run);
    if (degree_of(map) > max_counted_degree)
        throw DomainError("inversion: expected a parametrization of degree at most " +
                          std::to_string(max_counted_degree) + ", found one of degree " +
                          std::to_string(degree_of(map)));
    result.parametrization_degree = map_degree(map, run);
    // Fibres that are finite, but did not agree, say nothing: formulas do, if there are any.
    if (!result.parametrization_degree && has_finite_fibres(parametrization, map, run))
        result.parametrization_degree = 1;
    if (result.parametrization_degree != 1) return result;
    for (const std::size_t parameter : parametrization.parameters())
        result.parameters.push_back(formula_of(parametrization, parameter, result.ring, run));
    return result;
}

} // namespace eliminant::implicit
