// The standard monomials of a zero-dimensional ideal and their neighbours.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// The combinatorics of K[x₁, …, xₙ]/I for an ideal I of dimension zero, from the supports of a reduced
/// Groebner basis: the standard monomials b₀ < b₁ < … < b_{D−1}, a basis of the vector space, and the border,
/// the products xᵢ·b that are not standard, ascending. It is the same modulo every prime that divides no
/// leading coefficient.
class Staircase {
  public:
    /// nullopt if there are more than `limit` standard monomials, or infinitely many. O(n²·D) look-ups.
    static std::optional<Staircase> of(std::span<const algebra::Polynomial> reduced_basis, std::size_t limit,
                                       base::Run& run);

    std::size_t variable_count() const { return products_.size(); }
    std::size_t size() const { return size_; } ///< D
    std::size_t border_size() const { return border_.size(); }

    /// x_variable·b: the index of a standard monomial, or size() + the index of a border monomial.
    std::uint32_t product(std::size_t variable, std::size_t b) const { return products_[variable][b]; }

    /// How the normal form of a border monomial is known.
    struct Border {
        /// The element of the basis whose leading monomial it is, or `none`.
        std::uint32_t element;
        /// Otherwise it is x_variable times border monomial `below`, a smaller one.
        std::uint32_t variable;
        std::uint32_t below;
    };
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    const Border& border(std::size_t i) const { return border_[i]; }

    /// The standard monomials in the terms of an element of the basis after the leading one, in its sequence.
    std::span<const std::uint32_t> tail(std::size_t element) const { return tails_[element]; }

    /// The index of a standard monomial, or `none`; exponents in the variables of the ring.
    std::uint32_t index_of(std::span<const std::uint64_t> exponents) const;

  private:
    using Exponents = std::vector<std::uint64_t>;
    class Builder;
    Staircase() = default;

    std::size_t size_ = 0;
    std::vector<std::vector<std::uint32_t>> products_; ///< for each variable
    std::vector<Border> border_;
    std::vector<std::vector<std::uint32_t>> tails_;
    std::vector<Exponents> by_exponents_; ///< standard monomials in lexicographic sequence, for index_of
    std::vector<std::uint32_t> index_by_exponents_;
};

} // namespace eliminant::groebner
