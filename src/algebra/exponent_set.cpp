#include "exponent_set.hpp"

namespace eliminant::algebra {

ExponentSet::Census ExponentSet::census(std::span<const std::uint32_t> bounds, std::uint32_t degree) {
    std::vector<double> points(degree + std::size_t{1}, 0); // of each degree
    points[0] = 1;
    for (const std::uint32_t bound : bounds) {
        std::vector<double> longer(points.size(), 0);
        double sum = 0; // of points[d − bound], …, points[d]
        for (std::size_t d = 0; d < points.size(); ++d) {
            sum += points[d];
            if (d > bound) sum -= points[d - bound - 1];
            longer[d] = sum;
        }
        points = std::move(longer);
    }
    Census census;
    for (std::size_t d = 0; d < points.size(); ++d) {
        census.points += points[d];
        census.degrees += points[d] * static_cast<double>(d);
    }
    return census;
}

ExponentSet::ExponentSet(std::vector<std::uint32_t> bounds, std::uint32_t degree)
    : bounds_(std::move(bounds)), degree_(degree), sums_((axes() + 1) * (degree_ + std::size_t{2}), 0) {
    for (std::size_t axis = axes() + 1; axis-- > 0;) {
        std::size_t* const here = sums_.data() + axis * (degree_ + std::size_t{2});
        for (std::size_t d = 0; d <= degree_; ++d) {
            std::size_t points = 1;
            if (axis < axes()) {
                const std::size_t* const next = sums(axis + 1);
                points = next[d + 1] - (d > bounds_[axis] ? next[d - bounds_[axis]] : 0);
            }
            here[d + 1] = here[d] + points;
        }
    }
}

namespace {

/// The numbers that the points of a set get when sorted by degree, by rank, and how many points there are of
/// degree at most d.
struct GradedSequence {
    std::vector<std::uint32_t> places;
    std::vector<std::size_t> up_to;
};

GradedSequence graded_sequence(const ExponentSet& set) {
    if (set.axes() == 0) return {{0}, std::vector<std::size_t>(set.degree() + std::size_t{1}, 1)};
    const auto for_each_degree = [&](auto&& visit) {
        set.for_each_run([&](std::span<const std::uint32_t> e, std::uint32_t run) {
            std::size_t degree = 0;
            for (const std::uint32_t exponent : e) degree += exponent;
            for (std::uint32_t t = 0; t < run; ++t) visit(degree + t);
        });
    };
    GradedSequence result{{}, std::vector<std::size_t>(set.degree() + std::size_t{1}, 0)};
    for_each_degree([&](std::size_t degree) { ++result.up_to[degree]; });
    std::vector<std::uint32_t> next(result.up_to.size());
    std::size_t sum = 0;
    for (std::size_t d = 0; d < next.size(); ++d) {
        next[d] = static_cast<std::uint32_t>(sum);
        sum = result.up_to[d] += sum;
    }
    result.places.reserve(set.size());
    for_each_degree([&](std::size_t degree) { result.places.push_back(next[degree]++); });
    return result;
}

} // namespace

AxisLayout::AxisLayout(const ExponentSet& set, std::size_t axis) {
    std::vector<std::uint32_t> other_bounds;
    for (std::size_t j = 0; j < set.axes(); ++j) {
        if (j != axis) other_bounds.push_back(set.bound(j));
    }
    const ExponentSet others(std::move(other_bounds), set.degree());
    const GradedSequence sequence = graded_sequence(others);
    begins_.push_back(0);
    for (std::size_t k = 0; k <= std::min(set.bound(axis), set.degree()); ++k)
        begins_.push_back(begins_.back() + sequence.up_to[set.degree() - k]);

    positions_.reserve(set.size());
    const bool is_last = axis + 1 == set.axes();
    std::vector<std::uint32_t> rest(others.axes());
    set.for_each_run([&](std::span<const std::uint32_t> e, std::uint32_t run) {
        std::size_t used = 0;
        for (std::size_t j = 0; j < e.size(); ++j) {
            if (j != axis) rest[used++] = e[j];
        }
        const std::size_t rank = others.rank(rest);
        for (std::uint32_t t = 0; t < run; ++t) {
            const std::size_t row = is_last ? t : e[axis];
            positions_.push_back(
                static_cast<std::uint32_t>(begins_[row] + sequence.places[is_last ? rank : rank + t]));
        }
    });
}

} // namespace eliminant::algebra
