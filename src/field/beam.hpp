#pragma once

#include "beam_layout.hpp"
#include "double_double.hpp"
#include "exact_beam.hpp"

#include <cstddef>
#include <vector>

namespace eliminant::field {

/// An affine change of one coordinate: x = center + radius·x', for x' in [−1, 1].
struct Span {
    double center = 0.0;
    double radius = 1.0;
};

/// A polynomial on a box of rays, in doubles. Coordinates are those of the box: u, v, w ∈ [−1, 1].
///
/// One number accounts for all rounding: `error` bounds the sum of the absolute errors of the coefficients,
/// and so the error of the value anywhere in the box. It survives every affine change of coordinates into the
/// box (a monomial becomes a sum whose coefficients' absolute values add up to at most 1), restriction to a
/// ray, and the change to the Bernstein basis of [−1, 1], whose matrix has entries of at most 1.
struct Beam {
    std::vector<double> coefficients; ///< as BeamLayout says
    double magnitude = 0.0;           ///< at least the sum of the absolute values of the coefficients
    double error = 0.0;

    /// Whether the constant outweighs everything else: then no ray has a zero in the box.
    bool has_no_zero() const;
    /// The coefficients of u^a·w^k on the row v, at [k·(degree + 1) + a], and their derivatives by v.
    void collapse_rows(const BeamLayout& layout, double v, double* row, double* v_derivative) const;
};

/// The same in twice the precision: what boxes are cut from.
class WideBeam {
  public:
    /// The exact polynomial divided by a power of two, so that the largest coefficient is about 1.
    explicit WideBeam(const ExactBeam& exact);

    const BeamLayout& layout() const { return layout_; }

    /// On the part u ∈ u.center ± u.radius, v ∈ v.center ± v.radius, which lies in the box.
    WideBeam part(Span u, Span v) const;
    /// On the part w ∈ w.center ± w.radius, rounded to doubles.
    Beam slab(Span w) const;
    /// The polynomial in w on one ray; `error` is set to a bound of the sum of its coefficients' errors.
    std::vector<DoubleDouble> on_ray(double u, double v, double& error) const;

  private:
    WideBeam() : layout_(0, true) {}
    void measure();

    BeamLayout layout_;
    std::vector<DoubleDouble> coefficients_;
    double magnitude_ = 0.0;
    double error_ = 0.0;
};

} // namespace eliminant::field
