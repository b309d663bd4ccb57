#pragma once

#include "beam_layout.hpp"

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <vector>

namespace eliminant::field {

/// constant + u·(…) + v·(…) + w·(…).
struct LinearForm {
    mpq_class constant;
    mpq_class u;
    mpq_class v;
    mpq_class w;
};

/// Homogeneous coordinates (x : y : z : t) of the points of a beam of rays: (u, v) chooses the ray and w the
/// point on it.
///
/// For parallel rays w is the parameter along the ray and t = 1. A pencil of rays o + s·d(u, v) becomes
/// parallel by a projective map that sends o to infinity: with w = −1/s the point is (d(u, v) − w·o : −w),
/// which is linear in u, v and w, and w increases along the ray. So in both cases the polynomial on the beam
/// has total degree n, n³/6 coefficients instead of n⁴/12, and the coefficient of w^k has degree n − k in (u,
/// v).
using BeamForms = std::array<LinearForm, 4>;

/// A polynomial on a beam: a positive multiple of its homogenisation at the forms, with integer coefficients.
class ExactBeam {
  public:
    /// At most three variables; variables that the ring lacks do not occur. Horner's scheme in three
    /// variables: O(n⁶/180) multiplications of integers by those of the forms (n⁴/24 for a ray). The forms' t
    /// must be positive on the beam.
    ExactBeam(const algebra::Polynomial& f, const BeamForms& forms, base::Run& run);

    const BeamLayout& layout() const { return layout_; }
    const std::vector<mpz_class>& coefficients() const { return coefficients_; }
    bool is_zero() const;

    /// The polynomial in w on the ray (u, v), times a positive number.
    std::vector<mpz_class> on_ray(const mpq_class& u, const mpq_class& v) const;

  private:
    struct IntegerForm {
        mpz_class constant, u, v, w;
    };
    void multiply(std::vector<mpz_class>& p, std::size_t degree, const IntegerForm& form) const;

    BeamLayout layout_;
    std::vector<mpz_class> coefficients_;
};

} // namespace eliminant::field
