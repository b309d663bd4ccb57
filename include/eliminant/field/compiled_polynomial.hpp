/// \file
/// Polynomials made ready for fast evaluation in floating point.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/base/source_text.hpp"
#include "eliminant/field/evaluation_scheme.hpp"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

namespace eliminant::field {

/// A symmetric 3 × 3 matrix by its upper triangle.
struct SymmetricMatrix {
    double xx = 0;
    double xy = 0;
    double xz = 0;
    double yy = 0;
    double yz = 0;
    double zz = 0;

    glm::dmat3 matrix() const { return {xx, xy, xz, xy, yy, yz, xz, yz, zz}; }
    double trace() const { return xx + yy + zz; }
    /// Square root of the sum of the squares of all nine entries.
    double frobenius_norm() const;
};

/// Value, gradient and matrix of second derivatives at a point.
struct Jet {
    double value = 0;
    glm::dvec3 gradient{0};
    SymmetricMatrix hessian;
};

/// What rounding has done to a Jet at most: to the value, to the gradient in the Euclidean norm, to the
/// Hessian in the Frobenius norm. Never NaN; infinite where the evaluation overflowed.
struct JetError {
    double value = 0;
    double gradient = 0;
    double hessian = 0;
};

/// A number that is within `error` of the exact one.
struct Approximation {
    double value = 0;
    double error = 0;
};

/// Coordinates of points, one span a coordinate.
template <class Real>
struct PointArrays {
    std::span<const Real> x;
    std::span<const Real> y;
    std::span<const Real> z; ///< may be empty for a polynomial in two variables
};

/// Value, gradient (x, y, z) and Hessian (xx, xy, xz, yy, yz, zz) of many points, one span a component. They
/// do not overlap each other or the points.
template <class Real>
struct JetArrays {
    std::span<Real> value;
    std::array<std::span<Real>, 3> gradient;
    std::array<std::span<Real>, 6> hessian;
};

/// The affine map q ↦ center + scale·q.
struct Region {
    std::array<mpq_class, 3> center;
    mpq_class scale = 1;
};

/// A box with sides along the axes.
struct Box {
    glm::dvec3 lower{0};
    glm::dvec3 upper{0};
};

struct CompiledData;

/// A polynomial f over ℚ in at most three variables x, y, z as a scheme of multiplications and additions: an
/// immutable value, cheap to copy, that many threads may evaluate at once.
///
/// Coefficients are rounded once, from their exact values. Coefficients beyond about 2^±300 (floats: 2^±30)
/// would overflow: f is then multiplied by a power of two, see scale_exponent(). Surfaces, signs and
/// distances do not depend on it.
///
/// How it is evaluated is chosen here, by the operations that value, gradient and Hessian take and by the
/// digits that rounding leaves: Horner's scheme in three variables or common powers of them, in the best
/// sequence; the same in coordinates from the center of a box; or sums, products and powers of such parts, as
/// the text has them or as they are found (contents and multiple factors). schemes() tells.
/// Numbers differ by rounding between one point and batches, and between processors; error_bound() holds for
/// all of them.
class CompiledPolynomial {
  public:
    static constexpr std::int64_t max_degree = 1000; ///< Total degree.

    /// The first three variables of the ring are x, y, z.
    /// \throws DomainError over GF(p), or if another variable occurs; OverflowError if the degree is larger
    /// than
    ///   max_degree or the scheme has more than 2^24 coefficients
    explicit CompiledPolynomial(const algebra::Polynomial& f);
    /// The same for what may take longer: about 10 microseconds a term. \throws Stopped
    CompiledPolynomial(const algebra::Polynomial& f, base::Run& run);
    /// f(center + scale·q) as a polynomial in q, computed exactly: near the region of interest it loses fewer
    /// digits to cancellation. Points and derivatives are then in q.
    /// \throws the same; DomainError if the scale is 0; Stopped
    CompiledPolynomial(const algebra::Polynomial& f, const Region& region, base::Run& run);
    /// f for points of a box, or near it: its expansion at the center, computed exactly and rounded once, is
    /// used if that saves digits or operations. Points and derivatives are in the coordinates of f.
    /// \throws the same; DomainError unless the box is finite with lower ≤ upper
    CompiledPolynomial(const algebra::Polynomial& f, const Box& box, base::Run& run);
    /// The polynomial in x, y, z that a text denotes, f − g for an equation f = g, of which sums, products
    /// and powers are kept as written where that is faster. \throws the same; ParseError
    static CompiledPolynomial of_formula(const base::SourceText& text, base::Run& run);

    int degree() const; ///< Total degree; −1 for 0.
    bool is_zero() const { return degree() < 0; }
    /// The exact polynomial that is evaluated, in a ring of three variables x, y, z; not scaled.
    const algebra::Polynomial& polynomial() const;
    /// Values and derivatives are those of f·2^−scale_exponent(); 0 unless f has extreme coefficients.
    int scale_exponent() const;
    int scale_exponent_float() const; ///< The same for batches of floats.

    /// The scheme that is used, and then the others that were considered, by expected cost.
    std::span<const EvaluationScheme> schemes() const;

    /// Any point; what overflows is infinite or NaN.
    double value(const glm::dvec3& point) const;
    Jet jet(const glm::dvec3& point) const;
    /// A bound for what jet(), value() and batches of doubles at that point err. O(degree), much cheaper than
    /// the jet: from the sums of the absolute coefficients of each degree.
    JetError error_bound(const glm::dvec3& point) const;
    /// A closer bound, at about the cost of the jet: γₙ Σ |c| |x|^i |y|^j |z|^k and its derivatives (Higham
    /// 2002, §5.1).
    JetError close_error_bound(const glm::dvec3& point) const;
    /// A bound for what batches of floats err, of the numbers f·2^−scale_exponent_float(), at a point of
    /// floats; infinite where they may overflow.
    JetError error_bound_float(const glm::dvec3& point) const;

    /// All points of a batch, in vector registers. Much faster than one by one from about ten points on.
    /// \throws DomainError if the spans differ in length
    void evaluate(const PointArrays<double>& points, const JetArrays<double>& jets) const;
    void evaluate(const PointArrays<float>& points, const JetArrays<float>& jets) const;

    /// −1, 0 or 1, always right: where a double cannot decide, two doubles, 256 bits, and at last rationals
    /// do. \throws DomainError if a coordinate is not finite
    int sign(const glm::dvec3& point) const;
    /// The value with |error| ≤ 2^−30 |value|, or exactly 0, by the same means; if it is out of the range of
    /// doubles, ±infinity with infinite error, or the smallest positive double with its like.
    /// \throws DomainError if a coordinate is not finite
    Approximation reliable_value(const glm::dvec3& point) const;

    /// For the other parts of the library.
    const CompiledData& data() const { return *data_; }

  private:
    explicit CompiledPolynomial(std::shared_ptr<const CompiledData> data) : data_(std::move(data)) {}

    std::shared_ptr<const CompiledData> data_;
};

} // namespace eliminant::field

namespace eliminant {
using field::Approximation;
using field::CompiledPolynomial;
using field::Jet;
using field::JetArrays;
using field::JetError;
using field::PointArrays;
using field::Region;
using field::SymmetricMatrix;
} // namespace eliminant
