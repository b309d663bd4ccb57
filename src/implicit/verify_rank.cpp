#include "implicit/verify_rank.hpp"

#include "algebra/random.hpp"
#include "eliminant/algebra/calculus.hpp"
#include "eliminant/algebra/evaluation.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::PrimeField;
using Element = PrimeField::Element;

namespace {

DifferentialRank echelon_rank(std::vector<std::vector<Element>> rows, const PrimeField& field) {
    DifferentialRank result{0, 1};
    const std::size_t columns = rows.empty() ? 0 : rows.front().size();
    for (std::size_t column = 0; column < columns && result.rank < rows.size(); ++column) {
        const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(result.rank), rows.end(),
                                        [column](const auto& row) { return row[column] != 0; });
        if (pivot == rows.end()) continue;
        std::swap(*pivot, rows[result.rank]);
        const std::vector<Element>& top = rows[result.rank];
        result.pivots = field.multiply(result.pivots, top[column]);
        const Element inverse = field.inverse(top[column]);
        for (std::size_t i = result.rank + 1; i < rows.size(); ++i) {
            const Element factor = field.multiply(rows[i][column], inverse);
            for (std::size_t j = column; factor != 0 && j < columns; ++j)
                rows[i][j] = field.subtract(rows[i][j], field.multiply(factor, top[j]));
        }
        ++result.rank;
    }
    return result;
}

} // namespace

std::optional<DifferentialRank> differential_rank(const RationalMap& map, const RankPoint& at,
                                                  base::Run& run) {
    const PrimeField field(at.prime);
    const auto value = [&](const Polynomial& f) { return evaluate(f, field, at.point, run); };
    const Element bottom = value(map.denominator);
    if (bottom == 0) return std::nullopt;
    const std::vector<Polynomial> bottom_gradient = algebra::gradient(map.denominator);
    std::vector<std::vector<Element>> rows;
    for (std::size_t i = 0; i + map.constants.size() < map.components.size(); ++i) {
        const auto& [numerator, over_denominator] = map.components[i];
        const std::vector<Polynomial> gradient = algebra::gradient(numerator);
        const Element top = value(numerator);
        auto& row = rows.emplace_back();
        for (const std::size_t parameter : map.parameters) {
            // Of N/D the row times D²: it has the same rank.
            Element entry = value(gradient[parameter]);
            if (over_denominator)
                entry = field.subtract(field.multiply(entry, bottom),
                                       field.multiply(top, value(bottom_gradient[parameter])));
            row.push_back(entry);
        }
    }
    return echelon_rank(std::move(rows), field);
}

std::optional<RankPoint> point_of_rank(const RationalMap& map, std::size_t rank, base::Run& run) {
    constexpr int attempts = 10;
    algebra::Random random(run.seed());
    std::uint64_t prime = PrimeField::max_characteristic + 1;
    for (int i = 0; i < attempts; ++i) {
        prime = algebra::previous_prime(prime);
        if (std::ranges::any_of(map.components,
                                [&](const auto& c) { return c.numerator.denominator().residue(prime) == 0; }))
            continue;
        RankPoint at{prime, std::vector<Element>(map.ring.variable_count())};
        for (Element& value : at.point) value = random.below(static_cast<Element>(prime));
        const std::optional<DifferentialRank> found = differential_rank(map, at, run);
        if (found && found->rank == rank) return at;
    }
    return std::nullopt;
}

} // namespace eliminant::implicit
