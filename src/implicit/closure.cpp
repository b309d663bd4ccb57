#include "implicit/closure.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/coefficients.hpp"
#include "eliminant/algebra/gcd.hpp"
#include "eliminant/groebner/groebner_basis.hpp"
#include "eliminant/ideal/dimension.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

namespace eliminant::implicit {

using algebra::CoefficientTerm;
using algebra::MonomialOrder;
using algebra::Polynomial;
using algebra::Ring;

namespace {

std::vector<std::size_t> indices_below(std::size_t count) {
    std::vector<std::size_t> indices(count);
    std::iota(indices.begin(), indices.end(), std::size_t{0});
    return indices;
}

std::vector<std::string> coordinate_names(const Parametrization& parametrization) {
    std::vector<std::string> names;
    for (const Coordinate& coordinate : parametrization.coordinates()) names.push_back(coordinate.name);
    return names;
}

/// The keys of `order` on variables [first, first + count) as rows on all of them.
void append_rows(std::vector<std::vector<std::int64_t>>& rows, const MonomialOrder& order, std::size_t first,
                 std::size_t count, std::size_t variable_count) {
    for (const MonomialOrder::Key& key : order.keys(count)) {
        auto& row = rows.emplace_back(variable_count, 0);
        for (std::size_t i = 0; i < count; ++i) {
            const auto weight = static_cast<std::int64_t>(key.weights[i]);
            row[first + i] = key.reversed ? -weight : weight;
        }
    }
}

MonomialOrder product_with_degrevlex(const MonomialOrder& order, std::size_t coordinates,
                                     std::size_t constants) {
    order.check(coordinates);
    if (constants == 0) return order;
    if (order.kind() == MonomialOrder::Kind::degrevlex)
        return MonomialOrder::blocks({indices_below(coordinates)});
    std::vector<std::vector<std::int64_t>> rows;
    append_rows(rows, order, 0, coordinates, coordinates + constants);
    append_rows(rows, MonomialOrder::degrevlex(), coordinates, constants, coordinates + constants);
    return MonomialOrder::matrix(std::move(rows));
}

/// The powers of one element, each made once.
class Powers {
  public:
    explicit Powers(const Polynomial& base) : powers_{Polynomial::constant(base.ring(), 1), base} {}

    const Polynomial& operator()(std::uint64_t exponent) {
        while (powers_.size() <= exponent) powers_.push_back(powers_.back() * powers_[1]);
        return powers_[exponent];
    }

  private:
    std::vector<Polynomial> powers_;
};

Polynomial normalized(const Polynomial& f, std::span<const std::size_t> coordinates, base::Run& run) {
    return coordinates.size() == f.ring().variable_count() ? f.primitive_part()
                                                           : primitive_part(f, coordinates, run);
}

bool divides(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
    return std::ranges::equal(a, b, std::less_equal());
}

/// A polynomial over ℤ[constants] with its leading term in the coordinates.
struct Element {
    Polynomial polynomial;
    std::vector<std::uint64_t> head;
    Polynomial head_coefficient;

    Element(Polynomial f, std::span<const std::size_t> coordinates)
        : polynomial(std::move(f)), head(coordinates.size()), head_coefficient(polynomial.ring()) {
        for (const std::size_t i : coordinates) head[i] = polynomial.exponent(0, i);
        for (CoefficientTerm& term : coefficients(polynomial, coordinates))
            if (term.exponents == head) head_coefficient = std::move(term.coefficient);
    }
};

/// f − (c/lc g)·x^a·g, cleared of denominators, for a term c·x^a·(head of g) of f.
Polynomial reduced_once(const Polynomial& f, const CoefficientTerm& term, const Element& g,
                        std::span<const std::size_t> coordinates, base::Run& run) {
    const Polynomial common = gcd(term.coefficient, g.head_coefficient, run);
    std::vector<std::uint64_t> shift(f.ring().variable_count(), 0);
    for (const std::size_t i : coordinates) shift[i] = term.exponents[i] - g.head[i];
    const Polynomial multiple = multiply(divide_exactly(term.coefficient, common, run), g.polynomial, run)
                                    .times_term(Monomial(f.ring(), shift), 1);
    const Polynomial rest = multiply(divide_exactly(g.head_coefficient, common, run), f, run) - multiple;
    return normalized(rest, coordinates, run);
}

/// Reduces the tails over the field ℚ(constants); heads do not divide each other.
void reduce_tails(std::vector<Element>& elements, std::span<const std::size_t> coordinates, base::Run& run) {
    for (Element& f : elements) {
        bool changed = true;
        while (changed) {
            changed = false;
            for (const CoefficientTerm& term : coefficients(f.polynomial, coordinates)) {
                if (term.exponents == f.head) continue;
                const auto reducer = std::ranges::find_if(
                    elements, [&](const Element& g) { return divides(g.head, term.exponents); });
                if (reducer == elements.end()) continue;
                f = Element(reduced_once(f.polynomial, term, *reducer, coordinates, run), coordinates);
                changed = true;
                break;
            }
        }
    }
}

} // namespace

Ring closure_ring(const Parametrization& parametrization, const MonomialOrder& order) {
    std::vector<std::string> names = coordinate_names(parametrization);
    const std::size_t coordinates = names.size();
    for (const std::size_t i : parametrization.constants())
        names.push_back(parametrization.ring().names()[i]);
    const MonomialOrder product =
        product_with_degrevlex(order, coordinates, parametrization.constants().size());
    return {algebra::CoefficientField::rationals(), std::move(names), product};
}

Polynomial with_scales(const Polynomial& f, std::span<const Scale> scales, base::Run& run) {
    const Ring& ring = f.ring();
    const std::vector<std::size_t> coordinates = indices_below(scales.size());
    // A coordinate x is n/d times the one of f, so x·d/n takes its place.
    std::vector<Powers> numerators;
    std::vector<Powers> denominators;
    for (const Scale& scale : scales) {
        numerators.emplace_back(scale.numerator.in_ring(ring));
        denominators.emplace_back(scale.denominator.in_ring(ring));
    }
    std::vector<CoefficientTerm> terms = coefficients(f, coordinates);
    for (CoefficientTerm& term : terms) {
        run.poll();
        for (const std::size_t j : coordinates) {
            const std::uint64_t exponent = term.exponents[j];
            const auto degree = static_cast<std::uint64_t>(f.degree(j));
            term.coefficient *= denominators[j](exponent) * numerators[j](degree - exponent);
        }
    }
    return normalized(from_coefficients(ring, coordinates, terms), coordinates, run);
}

std::vector<Polynomial> dehomogenized(const ProjectiveMap& map, const GradedMap& graded,
                                      std::span<const Polynomial> kernel, const Ring& ring, base::Run& run) {
    const std::size_t coordinates = map.scales.size();
    std::vector<Polynomial> result;
    for (const Polynomial& f : kernel) {
        algebra::PolynomialBuilder builder(ring);
        for (std::size_t i = 0; i < f.size(); ++i) {
            run.poll();
            std::vector<std::uint64_t> exponents(ring.variable_count(), 0);
            for (std::size_t j = 0; j < coordinates; ++j) exponents[j] = f.exponent(i, graded.images[j + 1]);
            for (std::size_t j = 0; j < graded.constants.size(); ++j)
                exponents[coordinates + j] = f.exponent(i, graded.constants[j]);
            builder.add(f.integer_terms().coefficients[i], exponents);
        }
        result.push_back(with_scales(builder.build(), map.scales, run));
    }
    return result;
}

std::vector<Polynomial> reduced_closure_basis(const Parametrization& parametrization, const Ring& ring,
                                              std::span<const Polynomial> generators, base::Run& run) {
    std::vector<Polynomial> basis = groebner::groebner_basis(ring, generators, {}, run).elements;
    if (parametrization.constants().empty()) return basis;
    // A basis in a product order with the constants last is one over ℚ(constants) as well (Becker and
    // Weispfenning, Groebner Bases, Lemma 8.93); there it is neither minimal nor reduced.
    const std::vector<std::size_t> coordinates = indices_below(parametrization.coordinates().size());
    std::vector<Element> elements;
    for (Polynomial& f : basis) {
        Element element(normalized(f, coordinates, run), coordinates);
        const auto superfluous = [&](const Element& g) { return divides(g.head, element.head); };
        if (std::ranges::none_of(elements, superfluous)) elements.push_back(std::move(element));
    }
    reduce_tails(elements, coordinates, run);
    basis.clear();
    for (Element& element : elements) basis.push_back(std::move(element.polynomial));
    return basis;
}

std::size_t closure_codimension(const Parametrization& parametrization, std::span<const Polynomial> basis,
                                base::Run& run) {
    const Ring ring(algebra::CoefficientField::rationals(), coordinate_names(parametrization));
    std::vector<Polynomial> heads;
    for (const Polynomial& f : basis) {
        std::vector<std::uint64_t> exponents(ring.variable_count());
        for (std::size_t i = 0; i < exponents.size(); ++i) exponents[i] = f.exponent(0, i);
        heads.push_back(Polynomial::term(Monomial(ring, exponents), 1));
    }
    return static_cast<std::size_t>(ideal::codimension(ideal::Ideal(ring, std::move(heads)), run));
}

} // namespace eliminant::implicit
