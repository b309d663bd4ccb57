/// \file
/// How far a point is from the surface f = 0: estimates, and a bound that is proven.
#pragma once

#include "eliminant/field/compiled_polynomial.hpp"

#include <glm/vec3.hpp>
#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace eliminant::field {

/// What is computed. With F_k the part of order k of f(p + q) as a polynomial in q, so that |F_1(q)| ≤ |∇f|
/// |q| and F_2 has the matrix ½ Hess f:
enum class DistanceLevel {
    /// |f| / ‖∇f‖, an estimate: it may be larger or smaller than the distance, and is +∞ where ∇f = 0.
    first_order,
    /// The root ρ of |f| = ‖∇f‖ ρ + ½ m ρ² for the spectral norm m of the Hessian, an estimate that is never
    /// above
    /// the first; +∞ where both derivatives are 0.
    second_order,
    /// The same for the Frobenius norm, which is cheaper and never larger than the other.
    second_order_frobenius,
    /// A lower bound of the distance, proven and rounded down: the smallest positive root ρ of
    /// |f| = ‖∇f‖ ρ + m ρ² + Σ_{k ≥ 3} ‖F_k‖ ρ^k, where m is the largest eigenvalue of −½ sign(f) Hess f (how
    /// fast f can
    /// turn towards 0; it may be negative) and ‖F_k‖ is Bombieri's norm, which bounds |F_k| on the unit
    /// sphere (Taubin
    /// 1994, with these norms). No point nearer than ρ is on the surface; +∞ only if there is no surface at
    /// all.
    guaranteed,
};

/// `first_order`, `second_order`, `second_order_frobenius`, `guaranteed`.
std::string_view to_string(DistanceLevel level);

/// A distance without sign, and the sign of f there: by convention f < 0 is the inside.
///
/// On the surface both are 0. For the polynomial 0 they are 0 everywhere. At a point that is not finite the
/// sign is 0, estimates are NaN, and the bound is 0, which is true of any point.
struct Distance {
    double value = 0;
    int sign = 0;
};

struct DistanceData;

/// A compiled polynomial that is asked for distances from its zeros: an immutable value, cheap to copy, that
/// many threads may ask at once.
class DistanceField {
  public:
    /// O(degree · coefficients) besides the compilation.
    explicit DistanceField(CompiledPolynomial f);
    explicit DistanceField(const algebra::Polynomial& f) : DistanceField(CompiledPolynomial(f)) {}

    const CompiledPolynomial& polynomial() const { return f_; }
    /// For the other parts of the library.
    const DistanceData& data() const { return *data_; }

  private:
    CompiledPolynomial f_;
    std::shared_ptr<const DistanceData> data_;
};

/// At a point given in doubles, exactly these. Where doubles cannot tell value or derivatives from 0, near
/// the surface of a polynomial with large coefficients, near singular points and very far away, more precise
/// numbers are used until they can: the sign is always right, estimates are so to about eight digits at
/// least, and the bound is a bound.
///
/// Estimates take one evaluation of the jet, the bound O(degree · coefficients) for the Taylor expansion.
Distance distance(const DistanceField& field, const glm::dvec3& point, DistanceLevel level);

/// Distances and signs of many points, one span each.
struct DistanceArrays {
    std::span<double> value;
    std::span<std::int8_t> sign;
};

/// The same for a batch, value, derivatives and expansions being computed in vector registers. Signs are
/// those of single points; distances differ from theirs by rounding, and the bound is one. \throws
/// DomainError if the spans differ in length; z may be empty for a polynomial in two variables
void distances(const DistanceField& field, const PointArrays<double>& points, DistanceLevel level,
               const DistanceArrays& result);

/// The same at an exact point, by exact arithmetic and 256 bits: estimates are correctly rounded, the bound
/// is rounded down. Milliseconds for large polynomials.
///
/// The first three variables of the ring of f are x, y, z.
/// \throws what CompiledPolynomial throws; Stopped
Distance distance(const algebra::Polynomial& f, const std::array<mpq_class, 3>& point, DistanceLevel level,
                  base::Run& run);

/// The same for several levels, which costs no more than one of them.
std::vector<Distance> distances(const algebra::Polynomial& f, const std::array<mpq_class, 3>& point,
                                std::span<const DistanceLevel> levels, base::Run& run);

/// A lower bound of the distance of every point of a ball: no point of it is nearer to the surface, rounded
/// down. 0 if that cannot be shown. It is the guaranteed distance of the center minus the radius, as a
/// distance has Lipschitz constant 1: positive exactly if the Taylor bound shows f ≠ 0 on the ball. \throws
/// DomainError if the radius is negative or NaN
double distance_from_ball(const DistanceField& field, const glm::dvec3& center, double radius);

/// The same for a box with sides along the axes, by the ball around it.
/// \throws DomainError unless lower ≤ upper in each coordinate
double distance_from_box(const DistanceField& field, const glm::dvec3& lower, const glm::dvec3& upper);

} // namespace eliminant::field

namespace eliminant {
using field::Distance;
using field::distance;
using field::distance_from_ball;
using field::distance_from_box;
using field::DistanceArrays;
using field::DistanceField;
using field::DistanceLevel;
using field::distances;
} // namespace eliminant
