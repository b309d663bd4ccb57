#pragma once

#include "random.hpp"
#include "univariate_mod_p.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// A polynomial in n variables over a finite field as the array of all coefficients up to given degrees, the
/// last variable running fastest:
///
///     | x₁⁰x₂⁰ | x₁⁰x₂¹ | … | x₁¹x₂⁰ | x₁¹x₂¹ | …          a column is a polynomial in the last variable
///
/// So the last nonzero entry is the leading one for lex with x₁ > x₂ > …, and evaluation at a value of the
/// last variable is a dot product a column.
struct DenseBox {
    std::vector<std::size_t> extents; ///< degree + 1 in each variable; at least one variable
    dense::Vector values;             ///< the product of the extents

    std::size_t columns() const { return values.size() / extents.back(); }
    std::span<const dense::Element> column(std::size_t i) const {
        return std::span(values).subspan(i * extents.back(), extents.back());
    }
    std::span<dense::Element> column(std::size_t i) {
        return std::span(values).subspan(i * extents.back(), extents.back());
    }
};

/// gcd over a finite field by dense evaluation and interpolation, one variable after the other (Brown 1971).
///
/// Every answer is a guess: random points may be unlucky. It is the gcd if it divides both arguments, for an
/// image of the gcd divides the gcd of the images.
template <class Field>
class DenseGcd {
  public:
    /// `bounds` are upper bounds of the degrees of the gcd, one a variable.
    DenseGcd(const Field& field, std::vector<std::size_t> bounds, Random& random, base::Run& run)
        : field_(field), bounds_(std::move(bounds)), random_(random), run_(run) {}

    /// gcd of two nonzero polynomials with leading coefficient 1, in a box of extents bounds + 1; nothing if
    /// the points were unlucky or the field has too few.
    std::optional<DenseBox> operator()(DenseBox f, DenseBox g);

  private:
    std::optional<DenseBox> univariate(const DenseBox& f, const DenseBox& g);
    std::optional<DenseBox> interpolated(const DenseBox& f, const DenseBox& g, const dense::Vector& gamma,
                                         std::size_t bound);
    std::optional<DenseBox> finished(DenseBox h, const dense::Vector& content_of_gcd);
    DenseBox at(const DenseBox& f, dense::Element point);
    dense::Vector content(const DenseBox& f);
    DenseBox divided(DenseBox f, const dense::Vector& divisor);

    const Field& field_;
    std::vector<std::size_t> bounds_;
    Random& random_;
    base::Run& run_;
};

} // namespace eliminant::algebra
