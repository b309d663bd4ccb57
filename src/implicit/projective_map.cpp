#include "implicit/projective_map.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/calculus.hpp"
#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/algebra/gcd.hpp"

#include <algorithm>
#include <random>
#include <utility>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::PrimeField;
using Element = PrimeField::Element;

namespace {

/// Values at which the rotations hold: on each circle the point of a random half-angle.
std::vector<Element> random_point(const Parametrization& parametrization, const PrimeField& field,
                                  std::mt19937_64& random) {
    std::vector<Element> point(parametrization.ring().variable_count());
    for (Element& value : point) value = static_cast<Element>(random() % field.characteristic());
    for (const auto& [cosine, sine] : parametrization.rotations()) {
        Element w = 0;
        Element norm = 0; // 1 + w²
        while (norm == 0) {
            w = static_cast<Element>(random() % field.characteristic());
            norm = field.add(1, field.multiply(w, w));
        }
        const Element inverse = field.inverse(norm);
        point[cosine] = field.multiply(field.subtract(2, norm), inverse);
        point[sine] = field.multiply(field.add(w, w), inverse);
    }
    return point;
}

std::size_t rank_of(std::vector<std::vector<Element>> rows, const PrimeField& field) {
    std::size_t rank = 0;
    for (std::size_t column = 0; column < rows.front().size() && rank < rows.size(); ++column) {
        const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                        [column](const auto& row) { return row[column] != 0; });
        if (pivot == rows.end()) continue;
        std::swap(*pivot, rows[rank]);
        const Element inverse = field.inverse(rows[rank][column]);
        for (std::size_t i = rank + 1; i < rows.size(); ++i) {
            const Element factor = field.multiply(rows[i][column], inverse);
            for (std::size_t j = column; factor != 0 && j < rows[i].size(); ++j)
                rows[i][j] = field.subtract(rows[i][j], field.multiply(factor, rows[rank][j]));
        }
        ++rank;
    }
    return rank;
}

/// One row a form: its value and its derivatives, by the angle where two parameters are bound.
class Differential {
  public:
    Differential(const Parametrization& parametrization, const ProjectiveMap& map)
        : parametrization_(parametrization), map_(map) {
        free_ = parametrization.parameters();
        for (const auto& [cosine, sine] : parametrization.rotations())
            std::erase_if(free_, [c = cosine, s = sine](std::size_t i) { return i == c || i == s; });
        for (const Polynomial& form : map.forms) gradients_.push_back(algebra::gradient(form));
    }

    std::vector<std::vector<Element>> at(const std::vector<Element>& point, const PrimeField& field,
                                         base::Run& run) const {
        std::vector<std::vector<Element>> rows;
        for (std::size_t i = 0; i < gradients_.size(); ++i) {
            const auto partial = [&](std::size_t variable) {
                return evaluate(gradients_[i][variable], field, point, run);
            };
            auto& row = rows.emplace_back(1, evaluate(map_.forms[i], field, point, run));
            for (const std::size_t parameter : free_) row.push_back(partial(parameter));
            for (const auto& [cosine, sine] : parametrization_.rotations()) // dc = −s dθ, ds = c dθ
                row.push_back(field.subtract(field.multiply(point[cosine], partial(sine)),
                                             field.multiply(point[sine], partial(cosine))));
        }
        return rows;
    }

  private:
    const Parametrization& parametrization_;
    const ProjectiveMap& map_;
    std::vector<std::size_t> free_;
    std::vector<std::vector<Polynomial>> gradients_;
};

} // namespace

Parts split(const Polynomial& f, std::span<const std::size_t> parameters,
            std::span<const std::size_t> constants, base::Run& run) {
    const Polynomial one = Polynomial::constant(f.ring(), 1);
    if (f.is_zero()) return {1, one, f};
    if (constants.empty()) {
        const Polynomial primitive = f.primitive_part();
        return {f.leading_coefficient() / primitive.leading_coefficient(), one, primitive};
    }
    Polynomial content = algebra::content(f, parameters, run);
    Polynomial primitive = divide_exactly(f, content, run).primitive_part();
    mpq_class unit =
        f.leading_coefficient() / (content.leading_coefficient() * primitive.leading_coefficient());
    return {std::move(unit), std::move(content), std::move(primitive)};
}

Scale quotient_of(const Parts& a, const Parts& b, base::Run& run) {
    const Polynomial common = gcd(a.content, b.content, run);
    const mpq_class unit = a.unit / b.unit;
    return {divide_exactly(a.content, common, run).scaled(mpq_class(unit.get_num())),
            divide_exactly(b.content, common, run).scaled(mpq_class(unit.get_den()))};
}

ProjectiveMap over_common_denominator(const Parametrization& parametrization, base::Run& run) {
    const std::vector<Polynomial> circles = parametrization.rotation_relations();
    const auto reduce = [&](const Polynomial& f) {
        return circles.empty() ? f : normal_form(f, circles, run);
    };

    std::vector<std::pair<Polynomial, Polynomial>> fractions;
    Polynomial denominator = Polynomial::constant(parametrization.ring(), 1);
    for (const auto& [name, value] : parametrization.coordinates()) {
        const Polynomial n = reduce(value.numerator);
        const Polynomial d = reduce(value.denominator);
        const Polynomial common = gcd(n, d, run);
        fractions.emplace_back(divide_exactly(n, common, run), divide_exactly(d, common, run));
        denominator = lcm(denominator, fractions.back().second, run);
    }
    // Fractions in lowest terms over the lcm of their denominators have no common factor.
    const Parts bottom =
        split(reduce(denominator), parametrization.parameters(), parametrization.constants(), run);
    ProjectiveMap map;
    map.forms.push_back(bottom.primitive);
    for (const auto& [n, d] : fractions) {
        const Polynomial numerator = multiply(n, divide_exactly(denominator, d, run), run);
        const Parts top =
            split(reduce(numerator), parametrization.parameters(), parametrization.constants(), run);
        map.forms.push_back(top.primitive);
        map.scales.push_back(quotient_of(top, bottom, run));
    }
    return map;
}

std::size_t dimension_at_least(const Parametrization& parametrization, const ProjectiveMap& map,
                               base::Run& run) {
    constexpr int points = 4;
    const PrimeField field(PrimeField::max_characteristic);
    const Differential differential(parametrization, map);
    const std::size_t most =
        std::min(parametrization.coordinates().size(),
                 parametrization.parameters().size() - parametrization.rotations().size());
    std::mt19937_64 random(run.seed());
    std::size_t dimension = 0;
    for (int i = 0; i < points && dimension < most; ++i) {
        run.poll();
        const std::vector<Element> point = random_point(parametrization, field, random);
        if (evaluate(map.forms.front(), field, point, run) == 0) continue;
        // With f₀ ≠ 0, row operations with the row of f₀ turn the others into f₀·d(fᵢ/f₀): one more than the
        // rank of the differential.
        dimension = std::max(dimension, rank_of(differential.at(point, field, run), field) - 1);
    }
    return dimension;
}

} // namespace eliminant::implicit
