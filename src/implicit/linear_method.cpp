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

class PointMatrices : public LinearMethod {
  public:
    PointMatrices(const HypersurfaceProblem& problem, base::Run& run)
        : problem_(problem), run_(run), weights_(weights_of(problem.map)),
          sections_(problem.map, weights_, max_terms) {}

    Method name() const override { return Method::linear; }

    std::optional<HypersurfaceEquation> equation() override {
        auto equation = equation_from_images(
            problem_.ring, Echelon::prime_bound, [this](const PrimeField& field) { return image(field); },
            run_);
        if (equation) equation->how = describe();
        return equation;
    }

    std::optional<LinearSizes> sizes(std::size_t degree) const override {
        const std::uint64_t weighted = weighted_degree(degree);
        const std::size_t terms = Support::count_up_to(weights_, weighted, max_terms);
        LinearSizes result{degree, terms, 1, 0};
        if (sections_.is_applicable() && terms >= max_terms_at_once) {
            result.terms = sections_.predicted_terms(weighted, max_terms);
            result.planes = degree + 1;
            result.root_degree = sections_.root_degree(problem_.map);
        }
        if (result.terms >= max_terms) return std::nullopt;
        return result;
    }

    std::optional<LinearSizes> small_sizes(std::size_t max_count) override {
        const PrimeField field(algebra::previous_prime(Echelon::prime_bound));
        if (!learned_) learned_ = learn(field, MapModulo(problem_.map, field), max_count);
        if (!learned_) return std::nullopt;
        return LinearSizes{static_cast<std::size_t>(learned_->total_degree()), support_.size(), 1, 0};
    }

  private:
    /// Of an equation of a degree. A curve's has the highest power of the coordinate of least weight. So have
    /// surfaces without base points at infinity; with them the weighted degree tends to be greater.
    std::uint64_t weighted_degree(std::size_t degree) const {
        if (weights_.size() == 2) return degree * std::ranges::min(weights_);
        return degree * std::accumulate(weights_.begin(), weights_.end(), std::uint64_t{0}) / weights_.size();
    }

    algebra::Ring ring_modulo(const PrimeField& field) const {
        return problem_.ring.with_field(algebra::CoefficientField::prime(field.characteristic()));
    }

    std::string describe() const {
        return by_sections_ ? sections_.describe()
                            : std::to_string(support_.size()) + " coefficients at once";
    }

    std::optional<Polynomial> image(const PrimeField& field) {
        if (learned_ && learned_->ring().field().characteristic() == field.characteristic()) return learned_;
        const MapModulo map(problem_.map, field);
        const algebra::Ring ring = ring_modulo(field);
        if (by_sections_) return image_by_sections(map, ring);
        if (support_.size() == 0) {
            const std::size_t limit = sections_.is_applicable() ? max_terms_at_once : max_terms;
            learned_ = learn(field, map, limit);
            if (learned_) return learned_;
            by_sections_ = sections_.is_applicable();
            return by_sections_ ? image_by_sections(map, ring) : std::nullopt;
        }
        algebra::Random random(run_.seed() + field.characteristic());
        const PointSource points = [&] { return map.random_image(random); };
        const auto coefficients = first_vanishing(field, support_, points, run_);
        if (!coefficients || coefficients->size() != support_.size()) return std::nullopt;
        return monic_polynomial(ring, support_, *coefficients);
    }

    std::optional<Polynomial> image_by_sections(const MapModulo& map, const algebra::Ring& ring) {
        const auto image = sections_.image(map, run_);
        if (!image) return std::nullopt;
        return monic_polynomial(ring, image->support, image->coefficients);
    }

    /// Tries the monomials of ascending degree, up to `limit` of them.
    std::optional<Polynomial> learn(const PrimeField& field, const MapModulo& map, std::size_t limit) {
        algebra::Random random(run_.seed() + field.characteristic());
        const PointSource points = [&] { return map.random_image(random); };
        std::size_t size = 0;
        for (std::uint64_t degree = 1; size < limit; degree += (degree + 3) / 4) {
            const std::size_t next = Support::count_up_to(weights_, degree, limit);
            if (next == size) continue;
            size = next;
            const Support candidates = Support::up_to(weights_, degree);
            const auto coefficients = first_vanishing(field, candidates, points, run_);
            if (!coefficients) continue;
            support_ = candidates.where_nonzero(*coefficients);
            return monic_polynomial(ring_modulo(field), candidates, *coefficients);
        }
        return std::nullopt;
    }

    const HypersurfaceProblem& problem_;
    base::Run& run_;
    std::vector<std::uint64_t> weights_;
    SectionSolver sections_;
    bool by_sections_ = false;
    Support support_{0};
    std::optional<Polynomial> learned_; ///< the first image, where it was found all at once
};

bool is_made_for(const HypersurfaceProblem& problem) {
    return problem.map.denominator.total_degree() <= max_degree &&
           std::ranges::all_of(problem.map.components, [](const RationalMap::Component& component) {
               return component.numerator.total_degree() <= max_degree;
           });
}

} // namespace

std::unique_ptr<LinearMethod> linear_method(const HypersurfaceProblem& problem, base::Run& run) {
    if (!is_made_for(problem)) return nullptr;
    return std::make_unique<PointMatrices>(problem, run);
}

} // namespace eliminant::implicit
