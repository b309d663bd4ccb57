#include "eliminant/implicit/preimages.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/algebra/gcd.hpp"
#include "eliminant/ideal/dimension.hpp"
#include "eliminant/ideal/operations.hpp"
#include "eliminant/ideal/radical.hpp"
#include "eliminant/ideal/zero_dimensional.hpp"
#include "implicit/rational_zeros.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace eliminant::implicit {

using algebra::Polynomial;
using ideal::Ideal;

namespace {

void require_coordinates(std::size_t found, std::size_t expected) {
    if (found != expected)
        throw DomainError("point: it has " + std::to_string(found) + " coordinates where " +
                          std::to_string(expected) + " are needed");
}

/// The equations of the fibre, as they stand.
std::vector<Polynomial> equations_of(const Parametrization& parametrization,
                                     std::span<const mpq_class> point) {
    std::vector<Polynomial> equations = parametrization.relations();
    for (Polynomial& circle : parametrization.rotation_relations()) equations.push_back(std::move(circle));
    for (std::size_t i = 0; i < point.size(); ++i) {
        const auto& [numerator, denominator] = parametrization.coordinates()[i].value;
        equations.push_back(numerator - denominator.scaled(point[i]));
    }
    return equations;
}

Ideal fibre_ideal(const Parametrization& parametrization, std::span<const mpq_class> point, base::Run& run) {
    std::vector<Polynomial> equations = equations_of(parametrization, point);
    // In one variable the ideal is principal, and Euclid's algorithm modulo primes finds its generator.
    if (parametrization.ring().variable_count() == 1) equations = {gcd(equations, run)};
    Ideal fibre(parametrization.ring(), std::move(equations));
    for (const Coordinate& coordinate : parametrization.coordinates()) {
        const Polynomial& denominator = coordinate.value.denominator;
        if (!denominator.is_constant()) fibre = saturate(fibre, denominator, run);
    }
    return fibre;
}

/// Splits a finite set of points, the zeros of a radical ideal, into its rational points and the rest, one
/// variable after the other.
class Splitting {
  public:
    Splitting(Preimages& result, base::Run& run) : result_(result), run_(run) {}

    /// \param values of the first variables, which are rational numbers on all of I
    void split(const Ideal& I, std::vector<mpq_class> values) {
        const std::size_t index = values.size();
        if (index == result_.ring.variable_count()) {
            result_.rational.push_back(std::move(values));
            return;
        }
        const Polynomial x = Polynomial::variable(result_.ring, index);
        const Polynomial minimal = minimal_polynomial(I, x, run_);
        Polynomial rest = minimal;
        for (const mpq_class& zero : rational_zeros(minimal, run_)) {
            const Polynomial t = Polynomial::variable(minimal.ring(), 0);
            rest = divide_exactly(rest, t - Polynomial::constant(minimal.ring(), zero), run_);
            values.push_back(zero);
            split(sum(I, Ideal(result_.ring, {x - Polynomial::constant(result_.ring, zero)})), values);
            values.pop_back();
        }
        if (rest.is_constant()) return;
        const Polynomial equation = compose(rest, result_.ring, std::span(&x, 1), run_);
        result_.components.push_back(sum(I, Ideal(result_.ring, {equation})));
    }

  private:
    Preimages& result_;
    base::Run& run_;
};

} // namespace

Preimages preimages(const Parametrization& parametrization, std::span<const mpq_class> point,
                    base::Run& run) {
    require_coordinates(point.size(), parametrization.coordinates().size());
    if (!parametrization.constants().empty())
        throw DomainError("preimages: the constants of the parametrization have no values");
    Preimages result{parametrization.ring(), -1, mpz_class(0), {}, {}};
    const Ideal fibre = fibre_ideal(parametrization, point, run);
    result.dimension = ideal::dimension(fibre, run);
    if (result.dimension < 0) return result;
    const Ideal reduced = radical(fibre, run);
    if (result.dimension > 0) {
        result.count = std::nullopt;
        result.components.push_back(reduced);
        return result;
    }
    result.count = vector_space_dimension(reduced, run);
    Splitting(result, run).split(reduced, {});
    return result;
}

bool closure_contains(const ImplicitResult& result, std::span<const mpq_class> point, base::Run& run) {
    require_coordinates(point.size(), result.ring.variable_count());
    return std::ranges::all_of(result.equations,
                               [&](const Polynomial& f) { return evaluate(f, point, run) == 0; });
}

} // namespace eliminant::implicit
