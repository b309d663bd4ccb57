#include "eliminant/implicit/preimages.hpp"

#include "algebra/random.hpp"
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

/// How many zeros of a zero-dimensional radical ideal are real. A linear form with as many values as there
/// are zeros is real at a zero if and only if the zero is: conjugate zeros have conjugate values.
std::size_t count_real_points(const Ideal& I, base::Run& run) {
    const auto count = vector_space_dimension(I, run);
    for (unsigned long slope = 0;; ++slope) {
        run.poll();
        Polynomial form(I.ring());
        mpz_class factor = 1;
        for (std::size_t i = 0; i < I.ring().variable_count(); ++i) {
            form += Polynomial::variable(I.ring(), i).scaled(mpq_class(factor));
            factor *= slope;
        }
        const Polynomial minimal = minimal_polynomial(I, form, run);
        if (minimal.total_degree() == count->get_si()) return count_real_zeros(minimal, run);
    }
}

/// Whether a variety of positive dimension has real points outside of the zeros of some polynomials: it is
/// cut with a few linear spaces. nullopt if none was met.
std::optional<bool> meets_real_points(const Ideal& I, std::span<const Polynomial> excluded, base::Run& run) {
    constexpr int attempts = 6;
    const std::size_t variables = I.ring().variable_count();
    algebra::Random random(run.seed());
    for (int attempt = 0; attempt < attempts; ++attempt) {
        Ideal section = I;
        for (std::size_t i = 0; i < variables && dimension(section, run) > 0; ++i) {
            const auto value = static_cast<int>(random.below(2 * attempts)) - attempts;
            section = sum(section, Ideal(I.ring(), {Polynomial::variable(I.ring(), i) -
                                                    Polynomial::constant(I.ring(), value)}));
        }
        for (const Polynomial& f : excluded) section = saturate(section, f, run);
        if (dimension(section, run) == 0 && count_real_points(radical(section, run), run) > 0) return true;
    }
    return std::nullopt;
}

/// The limits of the coordinates for t → ∞ are read off leading coefficients.
bool tends_to(const Parametrization& parametrization, std::span<const mpq_class> point) {
    if (parametrization.ring().variable_count() != 1) return false;
    for (std::size_t i = 0; i < point.size(); ++i) {
        const auto& [numerator, denominator] = parametrization.coordinates()[i].value;
        if (numerator.is_zero() ? point[i] != 0 : numerator.total_degree() > denominator.total_degree())
            return false;
        const bool is_zero = numerator.is_zero() || numerator.total_degree() < denominator.total_degree();
        const mpq_class limit =
            is_zero ? mpq_class(0) : mpq_class(numerator.coefficient(0) / denominator.coefficient(0));
        if (limit != point[i]) return false;
    }
    return true;
}

} // namespace

Preimages preimages(const Parametrization& parametrization, std::span<const mpq_class> point,
                    base::Run& run) {
    require_coordinates(point.size(), parametrization.coordinates().size());
    if (!parametrization.constants().empty())
        throw DomainError("preimages: the constants of the parametrization have no values");
    Preimages result{parametrization.ring(), -1, mpz_class(0), {}, {}};
    result.real_count = 0;
    result.is_limit_at_infinity = tends_to(parametrization, point);
    const Ideal fibre = fibre_ideal(parametrization, point, run);
    result.dimension = ideal::dimension(fibre, run);
    if (result.dimension < 0) return result;
    const Ideal reduced = radical(fibre, run);
    if (result.dimension > 0) {
        result.count = std::nullopt;
        result.real_count = std::nullopt;
        result.components.push_back(reduced);
        for (const Coordinate& coordinate : parametrization.coordinates()) {
            const Polynomial denominator = squarefree_part(coordinate.value.denominator, run);
            const bool is_known = std::ranges::find(result.excluded, denominator) != result.excluded.end();
            if (denominator.is_constant() || is_known) continue;
            const Ideal there = sum(reduced, Ideal(result.ring, {denominator}));
            if (ideal::dimension(there, run) >= 0) result.excluded.push_back(denominator);
        }
        result.has_real = meets_real_points(reduced, result.excluded, run);
        return result;
    }
    result.count = vector_space_dimension(reduced, run);
    Splitting(result, run).split(reduced, {});
    *result.real_count = static_cast<unsigned long>(result.rational.size());
    for (const Ideal& component : result.components)
        *result.real_count += static_cast<unsigned long>(count_real_points(component, run));
    result.has_real = *result.real_count > 0;
    return result;
}

bool closure_contains(const ImplicitResult& result, std::span<const mpq_class> point, base::Run& run) {
    require_coordinates(point.size(), result.ring.variable_count());
    return std::ranges::all_of(result.equations,
                               [&](const Polynomial& f) { return evaluate(f, point, run) == 0; });
}

} // namespace eliminant::implicit
