// fglm() over ℚ: images modulo primes, lifted and proved.
#pragma once

#include "algebra/rational_lifting.hpp"
#include "groebner/change_of_order.hpp"
#include "groebner/fglm.hpp"
#include "groebner/order_proof.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// The image of the new basis modulo a prime: by fglm_in_shape_position() or, where that is not asked for or
/// does not succeed, by fglm().
ConvertedBasis convert(QuotientAlgebra& algebra, const algebra::Ring& target,
                       std::span<const std::size_t> variables, bool try_shape, base::Run& run);

/// change_order() over ℚ.
class OrderLifting {
  public:
    OrderLifting(const Staircase& staircase, std::span<const algebra::Polynomial> basis,
                 const algebra::Ring& target, std::vector<std::size_t> variables, base::Run& run);

    ChangedOrder compute(Proof proof);

  private:
    struct Image {
        std::uint32_t prime = 0;
        ConvertedBasis basis;
    };

    std::vector<Image> next_images(std::size_t count);
    void add(const Image& image);
    void begin(const ConvertedBasis& basis);
    std::vector<std::uint32_t> residues(const ConvertedBasis& basis) const;
    bool is_shape() const { return !pattern_.numerators.empty(); }
    bool lift_and_check();
    bool is_proved();
    bool is_proved_in_shape_position();
    LiftedBasis candidate() const;
    std::vector<algebra::Polynomial> polynomials() const;

    const Staircase& staircase_;
    std::span<const algebra::Polynomial> basis_;
    algebra::Ring target_;
    std::vector<std::size_t> variables_; ///< of the target, in the ring of the basis
    base::Run& run_;
    std::uint64_t last_prime_;
    bool try_shape_;
    ConvertedBasis pattern_; ///< an image with the best standard monomials so far
    std::optional<algebra::RationalLifting> lifting_;
};

} // namespace eliminant::groebner
