#include "implicit/verify_grid.hpp"

#include <algorithm>
#include <limits>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::PrimeField;

namespace {

constexpr std::size_t lanes = ValuesModulo::lanes;

/// \returns for each coordinate whether it is constant along lines in this direction
std::vector<bool> constant_coordinates(const RationalMap& map, std::size_t direction) {
    const auto varies = [direction](const Polynomial& g) {
        return direction < g.ring().variable_count() && g.degree(direction) > 0;
    };
    std::vector<bool> constant;
    for (const auto& [numerator, over_denominator] : map.components)
        constant.push_back(!varies(numerator) && !(over_denominator && varies(map.denominator)));
    return constant;
}

std::vector<bool> all_but(std::size_t direction, std::size_t count) {
    std::vector<bool> fixed(count, true);
    if (direction < count) fixed[direction] = false;
    return fixed;
}

/// The direction with the least work a point: the terms left on a line, and a share of all terms.
std::size_t best_direction(const RationalMap& map, const Polynomial& f,
                           const std::vector<std::uint64_t>& degrees) {
    if (std::ranges::count_if(degrees, [](std::uint64_t d) { return d > 0; }) < 2) return degrees.size();
    std::size_t best = degrees.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        if (degrees[i] == 0) continue;
        const std::vector<bool> constant = constant_coordinates(map, i);
        std::size_t left = f.size();
        if (std::ranges::find(constant, true) != constant.end()) {
            const ExponentTree tree(f, constant);
            left = tree.node_count(tree.cut());
        }
        const double work =
            static_cast<double>(left) + static_cast<double>(f.size()) / static_cast<double>(degrees[i] + 1);
        if (work >= least) continue;
        least = work;
        best = i;
    }
    return best;
}

} // namespace

GridLines::GridLines(const RationalMap& map, const Polynomial& f, const std::vector<std::uint64_t>& degrees)
    : direction(best_direction(map, f, degrees)), constant(constant_coordinates(map, direction)),
      equation(f, constant), denominator(map.denominator, all_but(direction, degrees.size())) {
    for (const RationalMap::Component& component : map.components)
        numerators.emplace_back(component.numerator, all_but(direction, degrees.size()));
}

Grid::Grid(const GridLines& lines, const RationalMap& map, const Polynomial& f, const VanishingClaim& bounds,
           const PrimeField& field, base::Run& run)
    : lines_(lines), bounds_(bounds), field_(field), run_(run),
      has_denominator_(!map.denominator.is_constant()), equation_(lines.equation, f, field),
      denominator_(lines.denominator, map.denominator, field), exponents_(bounds.degrees.size(), 0),
      points_(bounds.degrees.size()), coordinates_(map.components.size()) {
    for (std::size_t i = 0; i < map.components.size(); ++i) {
        numerators_.emplace_back(lines.numerators[i], map.components[i].numerator, field);
        over_denominator_.push_back(map.components[i].over_denominator);
    }
    for (std::size_t i = 0; i < bounds.degrees.size(); ++i)
        if (i != lines.direction) across_.push_back(i);
    capacity_.assign(across_.size() + 1, 0);
    for (std::size_t i = across_.size(); i-- > 0;)
        capacity_[i] = capacity_[i + 1] + bounds.degrees[across_[i]];
}

bool Grid::is_zero() {
    // A denominator that is zero at a point of one grid is not so on most others: it has few zeros.
    for (std::uint32_t start = 1000;;
         start = static_cast<std::uint32_t>(start * std::uint64_t{48271} % 1000000007)) {
        const Found found = values_from(start);
        if (found != Found::pole) return found == Found::zero;
    }
}

/// Lines by ascending sum of exponents, so that those treated together are of about the same length.
Grid::Found Grid::values_from(std::uint32_t start) {
    start_ = start;
    waiting_ = 0;
    for (std::uint64_t sum = 0; sum <= std::min(bounds_.total_degree, capacity_.front()); ++sum) {
        const Found found = visit_lines(0, sum);
        if (found != Found::zero) return found;
    }
    return waiting_ == 0 ? Found::zero : values_on_waiting_lines();
}

Grid::Found Grid::visit_lines(std::size_t index, std::uint64_t sum) {
    if (index < across_.size()) {
        const std::size_t variable = across_[index];
        const std::uint64_t rest = capacity_[index + 1];
        for (std::uint64_t e = sum > rest ? sum - rest : 0; e <= std::min(sum, bounds_.degrees[variable]);
             ++e) {
            exponents_[variable] = static_cast<std::uint32_t>(e);
            const Found found = visit_lines(index + 1, sum - e);
            if (found != Found::zero) return found;
        }
        return Found::zero;
    }
    if (waiting_ == 0) {
        least_sum_ = 0;
        for (const std::size_t variable : across_) least_sum_ += exponents_[variable];
        // Lanes that are not filled repeat the first one.
        for (const std::size_t variable : across_) points_[variable].fill(start_ + exponents_[variable]);
    }
    for (const std::size_t variable : across_) points_[variable][waiting_] = start_ + exponents_[variable];
    return ++waiting_ < lanes ? Found::zero : values_on_waiting_lines();
}

Grid::Found Grid::values_on_waiting_lines() {
    waiting_ = 0;
    const bool single = lines_.direction == points_.size();
    const std::uint64_t degree =
        single ? 0 : std::min(bounds_.total_degree - least_sum_, bounds_.degrees[lines_.direction]);
    for (ValuesModulo& numerator : numerators_) numerator.fix(points_);
    if (has_denominator_ && !invert_denominators(degree)) return Found::pole;
    for (std::uint64_t e = 0; e <= degree; ++e) {
        run_.poll();
        if (!single) points_[lines_.direction].fill(start_ + static_cast<std::uint32_t>(e));
        set_coordinates(e);
        if (e == 0) equation_.fix(coordinates_);
        for (const std::uint32_t value : equation_(coordinates_))
            if (value != 0) return Found::not_zero;
    }
    return Found::zero;
}

/// \returns whether none is zero
bool Grid::invert_denominators(std::uint64_t degree) {
    denominator_.fix(points_);
    inverse_denominators_.resize(degree + 1);
    // All by one inverse: that of their product, from which they are taken one after the other.
    std::vector<std::uint32_t> products;
    std::uint32_t product = 1;
    for (std::uint64_t e = 0; e <= degree; ++e) {
        if (lines_.direction < points_.size())
            points_[lines_.direction].fill(start_ + static_cast<std::uint32_t>(e));
        inverse_denominators_[e] = denominator_(points_);
        for (const std::uint32_t value : inverse_denominators_[e]) {
            products.push_back(product);
            product = field_.multiply(product, value);
        }
    }
    if (product == 0) return false;
    std::uint32_t inverse = field_.inverse(product);
    for (std::size_t i = products.size(); i-- > 0;) {
        std::uint32_t& value = inverse_denominators_[i / lanes][i % lanes];
        const std::uint32_t inverse_of_value = field_.multiply(inverse, products[i]);
        inverse = field_.multiply(inverse, value);
        value = inverse_of_value;
    }
    return true;
}

/// At this position on the lines. Coordinates that are constant there were set at the first.
void Grid::set_coordinates(std::size_t position) {
    for (std::size_t i = 0; i < coordinates_.size(); ++i) {
        if (position > 0 && lines_.constant[i]) continue;
        coordinates_[i] = numerators_[i](points_);
        if (!over_denominator_[i]) continue;
        for (std::size_t lane = 0; lane < lanes; ++lane)
            coordinates_[i][lane] =
                field_.multiply(coordinates_[i][lane], inverse_denominators_[position][lane]);
    }
}

} // namespace eliminant::implicit
