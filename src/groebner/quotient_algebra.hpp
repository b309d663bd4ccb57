// Computing in GF(p)[x₁, …, xₙ]/I, I of dimension zero.
#pragma once

#include "eliminant/algebra/prime_field.hpp"
#include "groebner/residue_kernels.hpp"
#include "groebner/staircase.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// The residue class ring of a zero-dimensional ideal modulo a prime, with the standard monomials as basis;
/// elements are vectors of D residues. Normal forms of border monomials are found when first needed, as in
/// the first half of FGLM (Faugère, Gianni, Lazard, Mora, J. Symb. Comp. 16 (1993)); each is a vector, so all
/// of them take 4·D·border_size() bytes. Not thread-safe.
class QuotientAlgebra {
  public:
    using Residue = algebra::PrimeField::Element;
    using Vector = std::vector<Residue>;

    /// `basis` is the reduced basis that the staircase is of, over GF(p) or over ℚ with p dividing none of
    /// the leading coefficients. All arguments must outlive it.
    QuotientAlgebra(const Staircase& staircase, std::span<const algebra::Polynomial> basis,
                    const algebra::PrimeField& field, base::Run& run);

    /// Whether the images modulo p of the elements, over ℚ, have the same leading monomials.
    static bool has_good_reduction(std::span<const algebra::Polynomial> basis,
                                   const algebra::PrimeField& field);

    const algebra::PrimeField& field() const { return field_; }
    const Staircase& staircase() const { return staircase_; }
    std::size_t size() const { return staircase_.size(); }

    /// The standard monomial b.
    Vector unit(std::uint32_t b) const;
    /// x_variable times an element. O(D) for each of its border products, each D long.
    Vector times_variable(std::size_t variable, const Vector& element);
    /// The linear form element ↦ form(x_variable·element); a form is given by its values on the standard
    /// monomials.
    Vector pull_back(std::size_t variable, const Vector& form);
    /// The value of a form.
    Residue apply(const Vector& form, const Vector& element) const;

  private:
    const Vector& border_normal_form(std::uint32_t i);
    Vector tail_normal_form(std::uint32_t element) const;

    const Staircase& staircase_;
    std::span<const algebra::Polynomial> basis_;
    algebra::PrimeField field_;
    base::Run& run_;
    const ResidueKernels& kernels_;
    std::vector<Vector> border_; ///< empty while unknown
};

} // namespace eliminant::groebner
