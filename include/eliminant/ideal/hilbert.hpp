/// \file
/// Hilbert series, Hilbert polynomial and degree of an ideal.
#pragma once

#include "eliminant/ideal/ideal.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>

namespace eliminant::ideal {

/// The generating function Σ H(d)·t^d of a Hilbert function H, kept as N(t)/(1 − t)^e with an integer
/// polynomial N, which may have the factor 1 − t.
class HilbertSeries {
  public:
    /// `numerator` is N, with integer coefficients, of a ring over ℚ in one variable.
    HilbertSeries(algebra::Polynomial numerator, std::size_t denominator_exponent);

    const algebra::Polynomial& numerator() const { return numerator_; } ///< N
    std::size_t denominator_exponent() const { return exponent_; }      ///< e

    /// The same series in lowest terms: then N(1) is the multiplicity, and e the order of the pole at 1. Over
    /// 1 for a series that is a polynomial. O(deg N) terms may appear where N had few.
    HilbertSeries reduced(base::Run& run) const;
    /// The order of the pole at t = 1, which is the Krull dimension of the ring that H belongs to; −1 for H =
    /// 0.
    std::int64_t pole_order() const;
    /// N(1) for the numerator in lowest terms; 0 for H = 0.
    mpz_class multiplicity() const;

    /// H(d).
    mpz_class value(std::uint64_t d) const;
    /// The polynomial P in ℚ[d] with H(d) = P(d) for all d ≥ regularity_index(): the Hilbert polynomial.
    algebra::Polynomial hilbert_polynomial() const;
    /// The least integer r with H(d) = P(d) for all integers d ≥ r, where H(d) = 0 for d < 0; so it may be
    /// negative. 0 for H = 0. \throws OverflowError if it does not fit
    std::int64_t regularity_index() const;

    friend bool operator==(const HilbertSeries&, const HilbertSeries&) = default;

  private:
    /// The coefficient of (t − 1)^k in N.
    mpz_class taylor_coefficient(std::size_t k) const;

    algebra::Polynomial numerator_;
    std::size_t exponent_;
};

/// The Hilbert series of K[x₁, …, xₙ]/I for homogeneous I, over (1 − t)ⁿ: H(d) is the dimension over K of the
/// forms of degree d modulo those in I.
///
/// It is that of the leading ideal (Macaulay 1927), found by pivoting on powers of variables:
/// N(I) = N(I + (p)) + t^deg(p)·N(I : p) (Bayer and Stillman 1992; Bigatti 1997).
/// \throws DomainError if I is not homogeneous by total degree
HilbertSeries hilbert_series(const Ideal& I, base::Run& run);

/// The affine Hilbert series of any ideal I, over (1 − t)^(n + 1): H(d) is the dimension over K of the
/// polynomials of degree at most d modulo those in I. It is the series of the homogenised ideal, that is of
/// the closure of the variety in projective space (Cox, Little, O'Shea, §9.3, Theorem 12).
HilbertSeries affine_hilbert_series(const Ideal& I, base::Run& run);

/// The degree of the variety of I counted with multiplicities, that is the number of its points on a general
/// linear space of complementary dimension: components of less than full dimension do not count. For ideals
/// of dimension zero the vector space dimension of K[x]/I; 0 for the unit ideal.
mpz_class degree(const Ideal& I, base::Run& run);

} // namespace eliminant::ideal

namespace eliminant {
using ideal::affine_hilbert_series;
using ideal::degree;
using ideal::hilbert_series;
using ideal::HilbertSeries;
} // namespace eliminant
