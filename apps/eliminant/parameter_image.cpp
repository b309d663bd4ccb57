#include "parameter_image.hpp"

#include "eliminant/algebra/evaluation.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace eliminant::app {

namespace {

enum class Domain { unit_interval, symmetric_interval, line };

/// The image of a grid of parameters.
class ImageSamples {
  public:
    explicit ImageSamples(const Parametrization& map, Run& run) : map_(map), run_(run) {
        std::vector<bool> is_angle(map.ring().variable_count(), false);
        for (const Rotation& rotation : map.rotations())
            is_angle[rotation.cosine] = is_angle[rotation.sine] = true;
        for (const std::size_t parameter : map.parameters())
            if (!is_angle[parameter]) numbers_.push_back(parameter);
        const std::size_t freedom = numbers_.size() + map.rotations().size();
        constexpr double most_samples = 300;
        constexpr double most_steps = 33;
        steps_ = static_cast<std::size_t>(
            std::min(most_steps, std::floor(std::pow(most_samples, 1.0 / static_cast<double>(freedom)))));
    }

    bool has_numbers() const { return !numbers_.empty(); }
    /// Too few steps show nothing.
    bool is_possible() const { return map_.relations().empty() && steps_ >= 3; }

    std::optional<Ball> ball(Domain domain) {
        points_.clear();
        has_pole_ = false;
        signs_.assign(map_.coordinates().size(), 0);
        std::vector<mpq_class> at(map_.ring().variable_count());
        sample(domain, 0, at);
        return enclosing_ball();
    }

  private:
    /// All values of the degrees of freedom from the given one on.
    void sample(Domain domain, std::size_t freedom, std::vector<mpq_class>& at) {
        const std::size_t numbers = numbers_.size();
        if (freedom == numbers + map_.rotations().size()) return add(at);
        for (std::size_t i = 0; i < (freedom < numbers ? steps_ : turns()); ++i) {
            if (freedom < numbers)
                at[numbers_[freedom]] = number(domain, i);
            else
                turn(map_.rotations()[freedom - numbers], i, at);
            sample(domain, freedom + 1, at);
        }
    }

    std::size_t turns() const { return std::max<std::size_t>(4, steps_ / 4 * 4); }

    mpq_class number(Domain domain, std::size_t i) const {
        mpq_class share(static_cast<unsigned long>(i), static_cast<unsigned long>(steps_ - 1));
        share.canonicalize();
        if (domain == Domain::unit_interval) return share;
        if (domain == Domain::symmetric_interval) return 2 * share - 1;
        mpq_class inner(static_cast<unsigned long>(2 * i + 1), static_cast<unsigned long>(steps_));
        inner.canonicalize();
        inner -= 1; // in (−1, 1), and symmetric
        return inner / (1 - inner * inner);
    }

    /// A rational point of the circle, so that what is evaluated is on it.
    void turn(const Rotation& rotation, std::size_t i, std::vector<mpq_class>& at) const {
        // Right angles are among them: at a half turn the tangent is 1.6e16, which is good enough.
        const double half = std::numbers::pi * static_cast<double>(i) / static_cast<double>(turns());
        const mpq_class tangent(std::round(64 * std::tan(half)) / 64);
        const mpq_class squared = tangent * tangent;
        at[rotation.cosine] = (1 - squared) / (1 + squared);
        at[rotation.sine] = 2 * tangent / (1 + squared);
    }

    void add(std::span<const mpq_class> at) {
        glm::dvec3 point(0.0);
        for (std::size_t i = 0; i < map_.coordinates().size(); ++i) {
            const RationalFunction& value = map_.coordinates()[i].value;
            const mpq_class denominator = evaluate(value.denominator, at, run_);
            const int sign = sgn(denominator);
            has_pole_ |= sign == 0 || sign == -signs_[i];
            if (sign == 0) return;
            signs_[i] = sign;
            const mpq_class quotient = evaluate(value.numerator, at, run_) / denominator;
            point[static_cast<int>(i)] = quotient.get_d();
        }
        points_.push_back(point);
    }

    std::optional<Ball> enclosing_ball() {
        if (points_.size() < 2) return std::nullopt;
        if (has_pole_) drop_far_points();
        glm::dvec3 lower = points_.front();
        glm::dvec3 upper = lower;
        for (const glm::dvec3& point : points_) {
            lower = glm::min(lower, point);
            upper = glm::max(upper, point);
        }
        Ball ball{0.5 * lower + 0.5 * upper, 0.0};
        for (const glm::dvec3& point : points_)
            ball.radius = std::max(ball.radius, glm::distance(ball.center, point));
        constexpr double margin = 1.05; // for what lies between the samples
        ball.radius *= margin;
        const bool is_one =
            ball.radius > 0 && std::isfinite(ball.radius) && std::isfinite(glm::length(ball.center));
        return is_one ? std::optional(ball) : std::nullopt;
    }

    /// Keeps what is at most four times as far from the median as three quarters of the points are.
    void drop_far_points() {
        const auto quantile = [](std::vector<double>& values, std::size_t quarters) {
            const auto place =
                values.begin() + static_cast<std::ptrdiff_t>(quarters * (values.size() - 1) / 4);
            std::ranges::nth_element(values, place);
            return *place;
        };
        std::vector<double> values(points_.size());
        glm::dvec3 median(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            std::ranges::transform(points_, values.begin(), [axis](const glm::dvec3& p) { return p[axis]; });
            median[axis] = quantile(values, 2);
        }
        const auto from_median = [&median](const glm::dvec3& p) { return glm::distance(p, median); };
        std::ranges::transform(points_, values.begin(), from_median);
        const double reach = 4 * quantile(values, 3);
        std::erase_if(points_, [&](const glm::dvec3& p) { return from_median(p) > reach; });
    }

    const Parametrization& map_;
    Run& run_;
    std::vector<std::size_t> numbers_; ///< the parameters that are no cosine or sine
    std::size_t steps_ = 0;            ///< values of each degree of freedom
    std::vector<glm::dvec3> points_;
    std::vector<int> signs_; ///< of the denominators met so far
    bool has_pole_ = false;
};

} // namespace

std::optional<Ball> ball_around_image(const Parametrization& map, ParameterRange range, Run& run) {
    ImageSamples samples(map, run);
    if (!samples.is_possible()) return std::nullopt;
    std::optional<Ball> best = samples.ball(Domain::unit_interval);
    if (range == ParameterRange::unit || !samples.has_numbers()) return best;
    for (const Domain domain : {Domain::symmetric_interval, Domain::line}) {
        // An odd or even map grows at most twofold from [0, 1] to [−1, 1]. A patch that was written in powers
        // of its parameters grows a lot outside of [0, 1].
        const std::optional<Ball> next = samples.ball(domain);
        if (best && !(next && next->radius < 3 * best->radius)) break;
        best = next;
    }
    return best;
}

} // namespace eliminant::app
