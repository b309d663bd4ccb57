// Evaluation and interpolation at the points of a simplex or box.
#pragma once

#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/run.hpp"

#include "exponent_set.hpp"
#include "residue_rows.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eliminant::algebra {

/// Polynomials with monomials in an ExponentSet, their coefficients in the Newton basis Π xᵢ(xᵢ − 1)…(xᵢ − kᵢ
/// + 1), and their values at the points of the set, modulo a prime.
///
/// A set that contains every divisor of its elements is unisolvent for itself: a polynomial supported in it
/// is determined by its values at it. Both changes of basis are triangular in each variable, so they work on
/// the lines of points that differ in one exponent, one axis after the other: W = Σ over the points of their
/// degrees operations each, of which those between values and Newton coefficients are additions alone
/// (differences of values at 0, 1, 2, …; J. van der Hoeven and É. Schost, Multi-point evaluation in higher
/// dimensions, AAECC 24, 2013).
class PointTransform {
  public:
    using Values = std::vector<std::uint32_t>;

    explicit PointTransform(const ExponentSet& set);

    std::size_t size() const { return set_->size(); }
    /// Where each point lies, by its rank, before a transform from monomials or from values …
    std::span<const std::uint32_t> first_positions() const { return layouts_.front().positions(); }
    /// … and before a transform from Newton coefficients.
    std::span<const std::uint32_t> newton_positions() const { return layouts_.back().positions(); }

    /// \param field whose characteristic exceeds every exponent of the set and is odd, in all of these.
    void monomials_to_newton(Values& values, const PrimeField& field, const base::Run& run) const;
    void newton_to_monomials(Values& values, const PrimeField& field, const base::Run& run) const;
    void newton_to_values(Values& values, const PrimeField& field, const base::Run& run) const;
    void values_to_newton(Values& values, const PrimeField& field, const base::Run& run) const;

  private:
    template <class AlongAxis>
    void forwards(Values& values, const AlongAxis& along_axis) const;
    template <class AlongAxis>
    void backwards(Values& values, const AlongAxis& along_axis) const;
    void move(Values& values, std::size_t from, std::size_t to) const;

    const ExponentSet* set_;
    std::vector<AxisLayout> layouts_;
    const ResidueRows* rows_;
};

} // namespace eliminant::algebra
