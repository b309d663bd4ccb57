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
        result.minor = field.multiply(result.minor, top[column]);
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

std::optional<DifferentialRank> differential_rank(const RationalMap& map, const PrimeField& field,
                                                  std::span<const Element> point, base::Run& run) {
    const auto value = [&](const Polynomial& f) { return evaluate(f, field, point, run); };
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

namespace {

bool divides_a_denominator(std::uint64_t p, const RationalMap& map) {
    return std::ranges::any_of(map.components,
                               [p](const auto& c) { return c.numerator.denominator().residue(p) == 0; });
}

} // namespace

std::optional<RankClaim> rank_claim(const RationalMap& map, std::uint64_t rank, base::Run& run) {
    constexpr int attempts = 10;
    algebra::Random random(run.seed());
    RankClaim claim;
    claim.prime = PrimeField::max_characteristic + 1;
    for (int i = 0; i < attempts; ++i) {
        claim.prime = algebra::previous_prime(claim.prime);
        if (divides_a_denominator(claim.prime, map)) continue;
        claim.point.resize(map.ring.variable_count());
        for (Element& value : claim.point) value = random.below(static_cast<Element>(claim.prime));
        const auto found = differential_rank(map, PrimeField(claim.prime), claim.point, run);
        if (!found || found->rank < rank) continue;
        claim.rank = found->rank;
        claim.minor = found->minor;
        return claim;
    }
    return std::nullopt;
}

bool holds(const RationalMap& map, const RankClaim& claim, base::Run& run) {
    if (claim.prime > PrimeField::max_characteristic || !algebra::is_prime(claim.prime)) return false;
    if (divides_a_denominator(claim.prime, map) || claim.point.size() != map.ring.variable_count())
        return false;
    if (std::ranges::any_of(claim.point, [&](Element value) { return value >= claim.prime; })) return false;
    const auto found = differential_rank(map, PrimeField(claim.prime), claim.point, run);
    return found && found->rank == claim.rank && found->minor == claim.minor;
}

} // namespace eliminant::implicit
