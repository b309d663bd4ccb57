#include "implicit/linear_method.hpp"

#include "implicit/nullvector.hpp"
#include "implicit/section_solver.hpp"

#include <algorithm>
#include <numeric>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::PrimeField;

namespace {

constexpr std::size_t max_terms = 6000;
/// Where sections are possible: they pay from about here on.
constexpr std::size_t max_terms_at_once = 200;
/// Of the map in a parameter: of more, tables of powers would be the smallest of the problems.
constexpr std::int64_t max_degree = 5000;

/// The degree of a coordinate as a map of parameter space: how fast it grows.
std::uint64_t weight_of(const RationalMap& map, const RationalMap::Component& component) {
    std::int64_t degree = component.numerator.total_degree();
    if (component.over_denominator) degree = std::max(degree, map.denominator.total_degree());
    return static_cast<std::uint64_t>(std::max<std::int64_t>(degree, 1));
}

std::vector<std::uint64_t> weights_of(const RationalMap& map) {
    std::vector<std::uint64_t> weights;
    std::uint64_t common = 0;
    for (const RationalMap::Component& component : map.components) {
        weights.push_back(weight_of(map, component));
        common = std::gcd(common, weights.back());
    }
    for (std::uint64_t& weight : weights) weight /= common;
    return weights;
}

/// All coefficients at once where they are few, from sections otherwise.
class LinearMethod {
  public:
    LinearMethod(const HypersurfaceProblem& problem, base::Run& run)
        : problem_(problem), run_(run), weights_(weights_of(problem.map)),
          sections_(problem.map, weights_, max_terms) {}

    std::optional<Polynomial> image(const PrimeField& field) {
        const MapModulo map(problem_.map, field);
        const algebra::Ring ring =
            problem_.ring.with_field(algebra::CoefficientField::prime(field.characteristic()));
        if (by_sections_) return image_by_sections(map, ring);
        algebra::Random random(run_.seed() + field.characteristic());
        const PointSource points = [&] { return map.random_image(random); };
        if (support_.size() == 0) {
            if (auto f = learn(field, points, ring)) return f;
            by_sections_ = sections_.is_applicable();
            return by_sections_ ? image_by_sections(map, ring) : std::nullopt;
        }
        const auto coefficients = first_vanishing(field, support_, points, run_);
        if (!coefficients || coefficients->size() != support_.size()) return std::nullopt;
        return monic_polynomial(ring, support_, *coefficients);
    }

    std::string describe() const {
        return by_sections_ ? sections_.describe()
                            : std::to_string(support_.size()) + " coefficients at once";
    }

  private:
    std::optional<Polynomial> image_by_sections(const MapModulo& map, const algebra::Ring& ring) {
        const auto image = sections_.image(map, run_);
        if (!image) return std::nullopt;
        return monic_polynomial(ring, image->support, image->coefficients);
    }

    /// Tries the monomials of ascending degree.
    std::optional<Polynomial> learn(const PrimeField& field, const PointSource& points,
                                    const algebra::Ring& ring) {
        const std::size_t limit = sections_.is_applicable() ? max_terms_at_once : max_terms;
        std::size_t size = 0;
        for (std::uint64_t degree = 1; size < limit; degree += (degree + 3) / 4) {
            const std::size_t next = Support::count_up_to(weights_, degree, limit);
            if (next == size) continue;
            size = next;
            const Support candidates = Support::up_to(weights_, degree);
            const auto coefficients = first_vanishing(field, candidates, points, run_);
            if (!coefficients) continue;
            support_ = candidates.where_nonzero(*coefficients);
            return monic_polynomial(ring, candidates, *coefficients);
        }
        return std::nullopt;
    }

    const HypersurfaceProblem& problem_;
    base::Run& run_;
    std::vector<std::uint64_t> weights_;
    SectionSolver sections_;
    bool by_sections_ = false;
    Support support_{0};
};

} // namespace

std::optional<HypersurfaceEquation> equation_by_linear_algebra(const HypersurfaceProblem& problem,
                                                               base::Run& run) {
    for (const RationalMap::Component& component : problem.map.components)
        if (component.numerator.total_degree() > max_degree) return std::nullopt;
    if (problem.map.denominator.total_degree() > max_degree) return std::nullopt;
    LinearMethod method(problem, run);
    auto equation = equation_from_images(
        problem.ring, Echelon::prime_bound, [&](const PrimeField& field) { return method.image(field); },
        run);
    if (equation) equation->how = method.describe();
    return equation;
}

} // namespace eliminant::implicit
