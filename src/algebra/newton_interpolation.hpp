#pragma once

#include "univariate_mod_p.hpp"

#include <cstddef>
#include <span>
#include <utility>

namespace eliminant::algebra {

/// Interpolation of many univariate polynomials of bounded degree through values at common points, one point
/// at a time, by Newton's scheme: H ← H + (value − H(b))/M(b)·M, M ← M·(x − b).
template <class Field>
class NewtonInterpolation {
  public:
    NewtonInterpolation(const Field& field, std::size_t polynomials, std::size_t degree_bound)
        : field_(&field), extent_(degree_bound + 1), columns_(polynomials * extent_, 0) {}

    std::size_t points() const { return master_.size() - 1; }
    /// Whether there are as many points as the degree bound asks for.
    bool complete() const { return points() == extent_; }

    /// Takes the values at one more point, each times `factor`. Returns whether a polynomial changed; if none
    /// did, they are probably all known.
    bool add(dense::Element point, std::span<const dense::Element> values, dense::Element factor = 1) {
        const Field& field = *field_;
        const dense::Element inverse = field.inverse(dense::evaluate<Field>(field, master_, point));
        const dense::Vector powers = dense::powers(field, point, points());
        bool changed = false;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::span<dense::Element> column = std::span(columns_).subspan(i * extent_, extent_);
            const dense::Element gap = field.subtract(field.multiply(values[i], factor),
                                                      dense::dot(field, column.first(points()), powers));
            if (gap == 0) continue;
            changed = true;
            dense::add_multiple<Field>(field, column, master_, field.multiply(gap, inverse));
        }
        dense::multiply_by_root(field, master_, point);
        return changed;
    }

    /// Coefficients, degree_bound + 1 for each polynomial.
    const dense::Vector& columns() const { return columns_; }
    std::span<const dense::Element> column(std::size_t i) const {
        return std::span(columns_).subspan(i * extent_, extent_);
    }

  private:
    const Field* field_;
    std::size_t extent_;
    dense::Vector columns_;
    dense::Vector master_ = {1};
};

} // namespace eliminant::algebra
