// The exponents of a product as points near the origin.
#pragma once

#include "eliminant/algebra/monomial_layout.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// The monomials of two factors and of their product as points of ℕⁿ: each exponent less its minimum and
/// divided by the gcd of its differences, without variables that do not vary, and without one that does if
/// the factors are homogeneous.
class ProductBox {
  public:
    using Word = MonomialLayout::Word;

    /// The points of a factor, axes() coordinates a term, and what bounds them.
    struct Factor {
        std::vector<std::uint32_t> points;
        std::vector<std::uint32_t> bounds;
        std::uint32_t degree = 0; ///< of the largest sum of coordinates
    };

    /// For factors with these packed monomials, at least one each, and a layout that can hold the product's.
    /// nullopt if no exponent varies or a coordinate or sum of coordinates is above `max_degree`.
    static std::optional<ProductBox> of(const MonomialLayout& target, std::uint32_t max_degree,
                                        const MonomialLayout& layout_a, std::span<const Word> a,
                                        const MonomialLayout& layout_b, std::span<const Word> b);

    std::size_t axes() const { return bounds_.size(); }
    const Factor& a() const { return a_; }
    const Factor& b() const { return b_; }
    /// Of the product.
    std::span<const std::uint32_t> bounds() const { return bounds_; }
    std::uint32_t degree() const { return a_.degree + b_.degree; }

    const MonomialLayout& target() const { return *target_; }
    /// The packed monomial of the origin, and what one unit along an axis adds to it, word by word modulo
    /// 2^64.
    std::span<const Word> origin() const { return origin_; }
    std::span<const Word> step(std::size_t axis) const {
        return std::span(steps_).subspan(axis * origin_.size(), origin_.size());
    }

  private:
    explicit ProductBox(const MonomialLayout& target) : target_(&target), origin_(target.words()) {}

    const MonomialLayout* target_;
    std::vector<Word> origin_;
    std::vector<Word> steps_;
    Factor a_;
    Factor b_;
    std::vector<std::uint32_t> bounds_;
};

} // namespace eliminant::algebra
