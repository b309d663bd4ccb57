// A polynomial from its restrictions to parallel lines.
#pragma once

#include "implicit/quotient_algebra.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace eliminant::implicit {

/// A polynomial F of degree d in n = 2 or 3 variables, without its constant factor, from F on the lines
/// { (b + ατ, τ) } of one direction over a simplex of base points b. On each of them F has degree d in τ and
/// the leading coefficient c = F_d(α, 1), F_d being its form of degree d; so given are monic polynomials:
///
///     F(b + ατ, τ)/c = τᵈ + h₁(b)τᵈ⁻¹ + … + h_d(b),        deg h_l ≤ l.
///
/// Each h_l is interpolated from (d+n−1 choose n−1) base points by Newton's scheme; then (b, τ) = (x − αz, z)
/// leads back to F. O(d^(n+1)) products.
class LineInterpolation {
  public:
    /// \param direction α; one residue, or two
    /// \param corner the first base point; the others are corner + (i, j) with i + j ≤ degree
    LineInterpolation(const algebra::PrimeField& field, std::size_t degree, Residues direction,
                      Residues corner);

    std::size_t line_count() const { return lines_.size(); }
    Residues base(std::size_t line) const; ///< The base point of a line.
    /// \param restriction monic, of the degree of the polynomial
    void set(std::size_t line, std::span<const Residue> restriction);

    /// The coefficients of F/c, all lines being set.
    struct Term {
        std::vector<std::uint64_t> exponents; ///< one a variable
        Residue coefficient;                  ///< not zero
    };
    std::vector<Term> terms();

  private:
    struct Line {
        std::size_t i;
        std::size_t j;
    };
    /// Coefficient, or value, for b₁ⁱ b₂ʲ τᵉ.
    Residue& at(std::size_t i, std::size_t j, std::size_t e) {
        return cells_[(e * columns_ + j) * (degree_ + 1) + i];
    }
    template <class Cell>
    void differences(std::size_t count, const Cell& cell) const;
    template <class Cell>
    void to_powers(std::size_t count, Residue first_node, const Cell& cell) const;
    template <class Cell>
    void shift(std::size_t count, Residue by, const Cell& cell) const;
    void interpolate_coefficient(std::size_t l);
    void undo_shear();

    const algebra::PrimeField& field_;
    std::size_t degree_;
    Residues direction_;
    Residues corner_;
    std::size_t columns_; ///< values of j: 1 for plane curves
    std::vector<Line> lines_;
    Residues cells_;
    Residues reciprocals_; ///< 1/i
};

} // namespace eliminant::implicit
