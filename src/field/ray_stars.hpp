/// \file
/// Many rays from few points: whether they meet the zero set at all.
#pragma once

#include "field/first_root.hpp"

#include "base/vector_unit.hpp"
#include "eliminant/field/distance.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eliminant::field {

/// Points, and from each of them the same number of rays.
struct StarRays {
    /// `count` is a multiple of this.
    static constexpr std::size_t padding = 8;

    std::size_t count = 0;
    std::size_t rays = 0;          ///< from each point
    const double* origin[3];       ///< [point]
    const double* direction[3];    ///< [ray·count + point], and so for the rest
    const double* lower = nullptr; ///< of the ray's parameter, at least 0
    const double* upper = nullptr; ///< less than `lower` for no ray at all
    /// The answers: `root` means that there is at least one.
    RayState* state = nullptr;
};

/// A polynomial as the kernels take it: TaylorScheme's data, without its containers.
struct StarPolynomial {
    struct Line {
        std::uint32_t first, count, i, j; ///< TaylorScheme::FilledLine, or ::Line without i and j
    };
    struct Step {
        std::uint32_t to, from, count, level; ///< TaylorScheme::Step
    };
    std::size_t degree = 0;
    std::size_t size = 0;         ///< number of entries
    int coordinates[3];           ///< which of x, y, z are u, v, w
    const double* high = nullptr; ///< the entries in doubles
    const double* low = nullptr;  ///< what they lack
    const Line* lines = nullptr;  ///< to be shifted along w
    std::size_t line_count = 0;
    const Step* steps = nullptr; ///< along v and u
    std::size_t step_count = 0;
    const Line* filled = nullptr; ///< all entries
    std::size_t filled_count = 0;
    const double* majorant = nullptr; ///< [m] at least the sum of |c| over the terms of degree m
    const double* bernstein = nullptr;
};

/// Answers for rays from the points [first, first + lanes).
struct StarSolver {
    /// `workspace` holds 3 · lanes · size doubles.
    void (*solve)(const StarPolynomial& f, const StarRays& rays, std::size_t first, double* workspace);
    std::size_t lanes; ///< divides StarRays::padding
};
/// Defined for each unit by ray_stars_per_unit.cpp.
template <base::VectorUnit unit>
StarSolver star_solver_of();

inline StarSolver star_solver(base::VectorUnit unit) {
    return base::with_unit(unit, [](auto u) { return star_solver_of<u()>(); });
}

/// A polynomial that answers for stars of rays: its Taylor expansion at a point serves all rays from there.
///
/// The expansion costs O(n⁴/8) operations, a ray then n³/3, where restricting f to a ray anew takes about
/// n⁴/12.
class StarRoots {
  public:
    explicit StarRoots(const DistanceField& f);
    StarRoots(const StarRoots&) = delete;
    StarRoots& operator=(const StarRoots&) = delete;

    /// Not for a degree beyond the kernels, nor where there is no expansion.
    bool is_possible() const { return polynomial_.size > 0; }
    /// Certified answers, or `undecided`. In vector registers, a lane a point.
    void solve(base::VectorUnit unit, const StarRays& rays, base::Run& run) const;

  private:
    std::vector<double> high_;
    std::vector<double> low_;
    std::vector<StarPolynomial::Line> lines_;
    std::vector<StarPolynomial::Step> steps_;
    std::vector<StarPolynomial::Line> filled_;
    std::vector<double> majorant_;
    StarPolynomial polynomial_; ///< of all these
};

} // namespace eliminant::field
