#pragma once

#include "eliminant/scene/clip_region.hpp"
#include "eliminant/scene/ray.hpp"

#include "field/exact_beam.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <optional>

namespace eliminant::scene {

/// How the rays of a grid become a beam: u and v count pixels from the middle of the grid, scaled to [−1, 1],
/// and w ∈ [−1, 1] covers the part of the rays that lies in a ball. For parallel rays w is affine in t; for a
/// pencil of rays it is affine in −1/t (field::BeamForms says why).
class BeamFrame {
  public:
    /// Pictures are cut into blocks of this many pixels a side; the frame is that of whole blocks.
    static constexpr std::size_t block_size = 32;

    /// \param free_radius no point of the surface is nearer than this to the origin of a pencil of rays:
    /// where
    ///   the origin is within the ball, the beam begins at this distance
    /// \returns nothing if the rays are neither parallel nor from one point, if the grid has no extent, or if
    ///   the beam would begin too near at the origin of the pencil
    static std::optional<BeamFrame> make(const RayGrid& rays, const Ball& ball, double free_radius);

    const field::BeamForms& forms() const { return forms_; }

    mpq_class exact_u(std::size_t column) const;
    mpq_class exact_v(std::size_t row) const;
    double u(double column) const { return (column - middle_column_) / half_width_; } ///< exact for pixels
    double v(double row) const { return (row - middle_row_) / half_height_; }
    double half_width() const { return half_width_; } ///< pixels in a unit of u, a power of two
    double half_height() const { return half_height_; }

    bool is_pencil() const { return is_pencil_; }
    double middle_w() const { return middle_w_; } ///< w = 0 is −1/t, or t, there
    double radius_w() const { return radius_w_; }
    double t_from_w(double w) const {
        const double raw = middle_w_ + radius_w_ * w;
        return is_pencil_ ? -1.0 / raw : raw;
    }

    /// The gradient in space, up to a positive factor, from the partial derivatives by u, v and w at a point
    /// of the surface f = 0: on it the derivatives of the homogenised polynomial are those of f, up to powers
    /// of t.
    ///
    /// With p(u, v, t) for the point, ∇f·p_u = f_u and so on, and the dual basis of p_u, p_v, p_t solves for
    /// ∇f. For a pencil p = o + t·d(u, v) and f = t^n g(u, v, −1/t), so f_u = t^n g_u and f_t = t^(n−2) g_w.
    glm::dvec3 gradient(double u, double v, double t, double by_u, double by_v, double by_w) const {
        const double f_t = by_w / radius_w_;
        if (!is_pencil_) return f_t * u_cross_v_ + by_u * v_cross_center_ + by_v * center_cross_u_;
        const double f_u = t * by_u;
        const double f_v = t * by_v;
        return (f_t - u * f_u - v * f_v) * u_cross_v_ + f_u * v_cross_center_ + f_v * center_cross_u_;
    }

  private:
    BeamFrame() = default;
    void make_forms(const RayGrid& rays);
    std::optional<Interval> depth_range(const RayGrid& rays, const Ball& ball, glm::dvec3 center,
                                        double free_radius) const;

    field::BeamForms forms_;
    double middle_column_ = 0.0; ///< a multiple of 1/2
    double middle_row_ = 0.0;
    double half_width_ = 1.0;
    double half_height_ = 1.0;
    bool is_pencil_ = true;
    double middle_w_ = 0.0;
    double radius_w_ = 1.0;
    // Cross products of the middle ray's direction and of what moves with u and v (origins of parallel rays,
    // directions of a pencil), oriented so that their determinant is positive.
    glm::dvec3 u_cross_v_{0.0};
    glm::dvec3 v_cross_center_{0.0};
    glm::dvec3 center_cross_u_{0.0};
};

} // namespace eliminant::scene
