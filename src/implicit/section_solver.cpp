#include "implicit/section_solver.hpp"

#include "base/parallel.hpp"
#include "implicit/rational_interpolation.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace eliminant::implicit {

namespace dense = algebra::dense;
using algebra::PrimeField;

SectionSolver::SectionSolver(const RationalMap& map, std::vector<std::uint64_t> weights,
                             std::size_t max_terms)
    : weights_(std::move(weights)), max_terms_(max_terms) {
    const std::size_t coordinates = map.components.size() - map.constants.size();
    for (std::size_t i = 0; i < map.constants.size(); ++i) {
        fixed_.constants.push_back(coordinates + i);
        fixed_.constant_variables.push_back(map.constants[i]);
        levels_.emplace_back(coordinates + i);
    }
    choose_coordinate(map);
    if (fixed_.coordinate) levels_.emplace_back(*fixed_.coordinate);
}

/// The coordinate of least weight: in it the equation has the highest degree, so the sections are smallest;
/// among equal ones that with the simplest equation in one parameter.
void SectionSolver::choose_coordinate(const RationalMap& map) {
    const std::size_t coordinates = map.components.size() - map.constants.size();
    if (coordinates < 3) return; // a section of a curve is points, mostly not over the prime field
    std::pair<std::uint64_t, std::int64_t> best{~std::uint64_t{0}, 0};
    for (std::size_t i = 0; i < coordinates; ++i)
        for (const std::size_t variable : map.parameters) {
            std::int64_t degree = map.components[i].numerator.degree(variable);
            if (map.components[i].over_denominator)
                degree = std::max(degree, map.denominator.degree(variable));
            const std::pair candidate(weights_[i], degree);
            if (degree < 1 || candidate >= best) continue;
            best = candidate;
            fixed_.coordinate = i;
            fixed_.variable = variable;
        }
}

std::optional<SparseImage> SectionSolver::image(const MapModulo& map, base::Run& run) {
    auto coefficients = solve(0, {}, map, run);
    if (!coefficients) return std::nullopt;
    return SparseImage{levels_.front().result, std::move(*coefficients)};
}

std::string SectionSolver::describe() const {
    std::string text = "sections of " + std::to_string(section_.size()) + " terms";
    for (const Level& level : levels_) text += ", " + std::to_string(level.planes) + " planes";
    return text;
}

const Support& SectionSolver::support_below(std::size_t level) const {
    return level + 1 == levels_.size() ? section_ : levels_[level + 1].result;
}

std::optional<Coefficients> SectionSolver::solve_section(const Values& values, const MapModulo& map,
                                                         base::Run& run) {
    const std::size_t constants = fixed_.constants.size();
    std::uint64_t seed = run.seed() + map.field().characteristic();
    for (const Element value : values) seed = seed * 0x9e3779b97f4a7c15 + value;
    PlanePoints plane(map, fixed_, {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(constants)},
                      fixed_.coordinate ? values.back() : 0, seed, run);
    const PointSource points = [&] { return plane.next(); };
    if (section_.size() == 0) return learn_section(map.field(), points, run);
    auto coefficients = first_vanishing(map.field(), section_, points, run);
    if (!coefficients || coefficients->size() != section_.size()) return std::nullopt;
    return coefficients;
}

/// Those that have no values in a section.
std::vector<std::size_t> SectionSolver::free_coordinates() const {
    std::vector<std::size_t> free(weights_.size());
    std::iota(free.begin(), free.end(), std::size_t{0});
    for (const Level& level : levels_) std::erase(free, level.coordinate);
    return free;
}

std::vector<std::uint64_t> SectionSolver::weights_at(std::span<const std::size_t> coordinates) const {
    std::vector<std::uint64_t> weights;
    for (const std::size_t i : coordinates) weights.push_back(weights_[i]);
    return weights;
}

std::size_t SectionSolver::predicted_terms(std::uint64_t weighted_degree, std::size_t limit) const {
    return Support::count_up_to(weights_at(free_coordinates()), weighted_degree, limit);
}

std::size_t SectionSolver::root_degree(const RationalMap& map) const {
    if (!fixed_.coordinate) return 0;
    const RationalMap::Component& component = map.components[*fixed_.coordinate];
    std::int64_t degree = component.numerator.degree(fixed_.variable);
    if (component.over_denominator) degree = std::max(degree, map.denominator.degree(fixed_.variable));
    return static_cast<std::size_t>(degree);
}

std::optional<Coefficients> SectionSolver::learn_section(const PrimeField& field, const PointSource& points,
                                                         base::Run& run) {
    const std::vector<std::size_t> free = free_coordinates();
    const std::vector<std::uint64_t> weights = weights_at(free);
    std::size_t size = 0;
    for (std::uint64_t degree = 1; size < max_terms_; degree += (degree + 5) / 6) {
        run.poll();
        const std::size_t next = Support::count_up_to(weights, degree, max_terms_);
        if (next == size) continue;
        size = next;
        const Support candidates = Support::up_to(weights, degree).embedded(weights_.size(), free);
        auto coefficients = first_vanishing(field, candidates, points, run);
        if (!coefficients) continue;
        section_ = candidates.where_nonzero(*coefficients);
        std::erase(*coefficients, 0);
        return coefficients;
    }
    return std::nullopt;
}

std::vector<std::optional<Coefficients>> SectionSolver::sections_at(std::size_t level, const Values& values,
                                                                    std::span<const Element> heights,
                                                                    const MapModulo& map, base::Run& run) {
    std::vector<std::optional<Coefficients>> sections(heights.size());
    const auto compute = [&](std::size_t i, std::size_t) {
        Values inner = values;
        inner.push_back(heights[i]);
        sections[i] = solve(level + 1, inner, map, run);
    };
    const bool first_learns = section_.size() == 0;
    if (first_learns) compute(0, 0);
    if (first_learns && !sections[0]) return sections;
    const std::size_t done = first_learns ? 1 : 0;
    base::parallel_for(run, heights.size() - done,
                       [&](std::size_t i, std::size_t w) { compute(i + done, w); });
    return sections;
}

namespace {

/// Distinct values, the same for a seed.
std::vector<std::uint32_t> random_heights(std::size_t count, const PrimeField& field, std::uint64_t seed) {
    algebra::Random random(seed);
    std::vector<std::uint32_t> heights;
    while (heights.size() < count) {
        const std::uint32_t height = 1 + random.below(field.characteristic() - 1);
        if (std::ranges::find(heights, height) == heights.end()) heights.push_back(height);
    }
    return heights;
}

using Sections = std::vector<std::optional<Coefficients>>;

/// A random combination of the coefficients of each section: a rational function of the height with the
/// denominator that all have in common, as far as it does not cancel.
Coefficients random_combination(const Sections& sections, const Coefficients& factors,
                                const PrimeField& field) {
    algebra::Random random(1);
    Coefficients values(sections.size(), 0);
    for (std::size_t i = 0; i < sections.front()->size(); ++i) {
        const std::uint32_t weight = random.below(field.characteristic());
        for (std::size_t j = 0; j < sections.size(); ++j)
            values[j] = field.add(values[j], field.multiply(weight, (*sections[j])[i]));
    }
    for (std::size_t j = 0; j < values.size(); ++j) values[j] = field.multiply(values[j], factors[j]);
    return values;
}

/// Finds the denominator of sections that are multiples of values of polynomials, up to these factors, and
/// puts it into the factors.
bool multiply_by_denominator(const Sections& sections, std::span<const std::uint32_t> heights,
                             const PrimeField& field, std::size_t redundancy, Coefficients& factors,
                             base::Run& run) {
    const auto f =
        rational_interpolant(field, heights, random_combination(sections, factors, field), redundancy, run);
    if (!f) return false;
    for (std::size_t j = 0; j < factors.size(); ++j)
        factors[j] =
            field.multiply(factors[j], dense::evaluate<PrimeField>(field, f->denominator, heights[j]));
    return true;
}

bool are_distinct(std::vector<std::uint32_t> values) {
    std::ranges::sort(values);
    return std::ranges::adjacent_find(values) == values.end();
}

} // namespace

std::optional<Coefficients> SectionSolver::solve(std::size_t level, const Values& values,
                                                 const MapModulo& map, base::Run& run) {
    if (level == levels_.size()) return solve_section(values, map, run);
    const Level& plan = levels_[level];
    if (!plan.known) return learn_level(level, values, map, run);

    const PrimeField& field = map.field();
    const auto heights = random_heights(plan.planes, field, values.empty() ? 1 : values.back());
    const auto sections = sections_at(level, values, heights, map, run);
    if (!std::ranges::all_of(sections, [](const auto& section) { return section.has_value(); }))
        return std::nullopt;
    Coefficients factors; // by which the sections become sections of one polynomial
    for (const auto& section : sections) {
        const Element reference = (*section)[plan.reference];
        if (reference == 0) return std::nullopt;
        factors.push_back(field.inverse(reference));
    }
    if (plan.reference_exponent)
        for (std::size_t j = 0; j < heights.size(); ++j)
            factors[j] = field.multiply(factors[j], field.power(heights[j], *plan.reference_exponent));
    else if (!multiply_by_denominator(sections, heights, field, 0, factors, run))
        return std::nullopt;

    Coefficients result(plan.result.size());
    Coefficients nodes(heights.size());
    Coefficients column(heights.size());
    for (std::size_t i = 0; i < plan.sections.size(); ++i) {
        const auto& [least, stride, count] = plan.exponents[i];
        for (std::size_t j = 0; j < count; ++j) {
            nodes[j] = field.power(heights[j], stride);
            const Element shift = least == 0 ? 1 : field.inverse(field.power(heights[j], least));
            column[j] = field.multiply(field.multiply((*sections[j])[i], factors[j]), shift);
        }
        if (stride > 1 && !are_distinct({nodes.begin(), nodes.begin() + count})) return std::nullopt;
        const dense::Vector f = dense::interpolate<PrimeField>(field, std::span(nodes).first(count),
                                                               std::span(column).first(count));
        for (std::size_t term = plan.begin[i]; term < plan.begin[i + 1]; ++term) {
            const std::size_t k = (plan.result[term][plan.coordinate] - least) / stride;
            result[term] = k < f.size() ? f[k] : 0;
        }
    }
    return result;
}

std::optional<Coefficients> SectionSolver::learn_level(std::size_t level, const Values& values,
                                                       const MapModulo& map, base::Run& run) {
    // More and more sections, until the functions of their height are determined.
    constexpr std::size_t max_planes = 2000;
    const PrimeField& field = map.field();
    Sections sections;
    std::vector<Element> heights;
    for (std::size_t count = 3; count < max_planes; count += 1 + count / 4) {
        const auto all = random_heights(count, field, values.empty() ? 1 : values.back());
        const auto fresh = std::span(all).subspan(heights.size());
        for (auto& section : sections_at(level, values, fresh, map, run)) {
            if (!section || section->back() == 0) return std::nullopt;
            sections.push_back(std::move(section));
        }
        heights = all;
        Coefficients factors;
        for (const auto& section : sections) factors.push_back(field.inverse(section->back()));
        if (!multiply_by_denominator(sections, heights, field, 1, factors, run)) continue;

        std::vector<Coefficients> columns;
        for (std::size_t i = 0; i < sections.front()->size(); ++i) {
            Coefficients column;
            for (std::size_t j = 0; j < sections.size(); ++j)
                column.push_back(field.multiply((*sections[j])[i], factors[j]));
            columns.push_back(dense::interpolate<PrimeField>(field, heights, column));
        }
        return record(level, columns);
    }
    return std::nullopt;
}

/// Takes down which powers of the height occur where; returns the coefficients of the result.
Coefficients SectionSolver::record(std::size_t level, const std::vector<Coefficients>& columns) {
    Level& plan = levels_[level];
    plan.sections = support_below(level);
    plan.result = Support(weights_.size());
    plan.reference = columns.size() - 1;
    Coefficients result;
    std::size_t degree = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        plan.begin.push_back(result.size());
        const Coefficients& f = columns[i];
        std::vector<std::uint32_t> monomial(plan.sections[i].begin(), plan.sections[i].end());
        Progression exponents{0, 0, 0};
        std::size_t terms = 0;
        for (std::uint32_t e = 0; e < f.size(); ++e) {
            if (f[e] == 0) continue;
            if (terms++ == 0) exponents.least = e;
            exponents.stride = std::gcd(exponents.stride, e - exponents.least);
            exponents.count = e - exponents.least;
            monomial[plan.coordinate] = e;
            plan.result.add(monomial);
            result.push_back(f[e]);
        }
        exponents.stride = std::max<std::uint32_t>(exponents.stride, 1);
        exponents.count = exponents.count / exponents.stride + 1;
        plan.exponents.push_back(exponents);
        plan.planes = std::max<std::size_t>(plan.planes, exponents.count);
        degree = std::max(degree, f.size());
        if (terms == 1 && !plan.reference_exponent) {
            plan.reference = i;
            plan.reference_exponent = exponents.least;
        }
    }
    plan.begin.push_back(result.size());
    // Without such a reference, a denominator of the degree of the last coefficient is to be found as well.
    if (!plan.reference_exponent) plan.planes = degree + columns.back().size();
    plan.known = true;
    return result;
}

} // namespace eliminant::implicit
