// Sets of exponent vectors that contain every divisor of their elements.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// The exponent vectors e ∈ ℕⁿ with eᵢ ≤ boundᵢ and Σ eᵢ ≤ degree, in lexicographic sequence: a box, a
/// simplex, or the part of a box below a plane.
class ExponentSet {
  public:
    /// What a set has, known before anything is built of its size.
    struct Census {
        double points = 0;
        double degrees = 0; ///< Σ over the points of Σ eᵢ
    };
    /// O(n · degree).
    static Census census(std::span<const std::uint32_t> bounds, std::uint32_t degree);

    /// \param bounds one an axis; there may be no axis, and one point \param degree of a set of fewer than
    /// 2^32 points. O(n · degree).
    ExponentSet(std::vector<std::uint32_t> bounds, std::uint32_t degree);

    std::size_t axes() const { return bounds_.size(); }
    std::size_t size() const { return up_to(0, degree_); }
    std::uint32_t bound(std::size_t axis) const { return bounds_[axis]; }
    std::uint32_t degree() const { return degree_; }

    /// How many points come before this one; O(n).
    std::size_t rank(std::span<const std::uint32_t> exponents) const {
        std::size_t before = 0;
        std::size_t left = degree_;
        for (std::size_t axis = 0; axis < axes(); ++axis) {
            // Σ over x < e of the points that further axes add to x.
            before += sums(axis + 1)[left + 1] - sums(axis + 1)[left + 1 - exponents[axis]];
            left -= exponents[axis];
        }
        return before;
    }

    /// Calls visit(exponents, run) for the points in sequence, all those at once that differ in the last
    /// exponent alone: `exponents`, with 0 there, are those of the first of `run` points. At least one axis.
    template <class Visit>
    void for_each_run(Visit&& visit) const {
        std::vector<std::uint32_t> e(axes(), 0);
        std::uint32_t left = degree_; // degree − Σ eᵢ
        for (;;) {
            visit(std::span<const std::uint32_t>(e), std::min(left, bounds_.back()) + 1);
            std::size_t axis = axes() - 1;
            for (;;) {
                if (axis == 0) return;
                --axis;
                if (left > 0 && e[axis] < bounds_[axis]) break;
                left += e[axis];
                e[axis] = 0;
            }
            ++e[axis];
            --left;
        }
    }

  private:
    /// Points of the axes from `axis` on of degree at most d.
    std::size_t up_to(std::size_t axis, std::size_t d) const { return sums(axis)[d + 1] - sums(axis)[d]; }
    /// At d + 1: up_to(axis, 0) + … + up_to(axis, d).
    const std::size_t* sums(std::size_t axis) const {
        return sums_.data() + axis * (degree_ + std::size_t{2});
    }

    std::vector<std::uint32_t> bounds_;
    std::uint32_t degree_;
    std::vector<std::size_t> sums_;
};

/// How values at the points of a set are stored for work along one axis. Row k holds the points with eᵢ = k,
/// in a sequence of increasing Σ_{j≠i} eⱼ that is the same for all rows. So a line of points that differ in
/// eᵢ alone is a column, and every row is as long as the next or longer:
///
///     row 0   | 0 0 0 | 0 0 1 | 0 1 0 | 0 0 2 | 0 1 1 | 0 2 0 |
///     row 1   | 1 0 0 | 1 0 1 | 1 1 0 |                              axis 0 of n = 3, degree 2
///     row 2   | 2 0 0 |
class AxisLayout {
  public:
    /// O(n · points of the set).
    AxisLayout(const ExponentSet& set, std::size_t axis);

    std::size_t rows() const { return begins_.size() - 1; }
    std::size_t row_begin(std::size_t row) const { return begins_[row]; }
    std::size_t row_size(std::size_t row) const { return begins_[row + 1] - begins_[row]; }
    /// Where each point of the set, by its rank, is stored.
    std::span<const std::uint32_t> positions() const { return positions_; }

  private:
    std::vector<std::size_t> begins_; ///< of the rows, and their end
    std::vector<std::uint32_t> positions_;
};

} // namespace eliminant::algebra
