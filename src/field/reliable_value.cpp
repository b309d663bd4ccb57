/// \file
/// The sign and value of a polynomial whatever it takes: double, two doubles, 256 bits, rationals.
#include "eliminant/field/compiled_polynomial.hpp"

#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/base/error.hpp"

#include "field/arithmetic.hpp"
#include "field/compiled_data.hpp"
#include "field/wide_float.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eliminant::field {

namespace {

constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Number>
Number value_of(const CompiledData& data, const std::vector<Number>& coefficients, const glm::dvec3& point) {
    const Number coordinates[3] = {Number(point.x), Number(point.y), Number(point.z)};
    return NestedHorner<PointArithmetic<Number>>::value(data.view, coefficients.data(), coordinates);
}

/// The bound for any arithmetic of that unit roundoff, from the one for doubles.
double scaled_factor(const CompiledData& data, double unit) { return data.error_factor * (unit / 0x1p-53); }

/// How precision rises at one point, until `accept` is content with the approximation.
class Escalation {
  public:
    Escalation(const CompiledData& data, const glm::dvec3& point)
        : data_(data), point_(point), magnitude_(glm::abs(point)),
          r_(std::max({magnitude_.x, magnitude_.y, magnitude_.z})) {}

    template <class Accept>
    Approximation run(const Accept& accept) const {
        const double sum = with_underflow(value_of(data_, data_.magnitudes, magnitude_), r_, data_.degree);
        if (std::isfinite(sum)) { // else something may overflow
            const Approximation in_double{value_of(data_, data_.coefficients, point_),
                                          data_.error_factor * sum};
            if (accept(in_double)) return in_double;
            const DoubleDouble value = value_of(data_, data_.double_doubles, point_);
            const double underflow = data_.error_factor * with_underflow(0, r_, data_.degree);
            const Approximation in_two{value.high, scaled_factor(data_, DoubleDouble::unit) * sum +
                                                       underflow + std::abs(value.high) * 0x1p-52};
            if (accept(in_two)) return in_two;
        }
        if (const Approximation wide = in_wide(); accept(wide)) return wide;
        return exactly();
    }

  private:
    Approximation in_wide() const;
    Approximation exactly() const;

    const CompiledData& data_;
    glm::dvec3 point_;
    glm::dvec3 magnitude_;
    double r_;
};

Approximation Escalation::in_wide() const {
    const Wide value = value_of(data_, data_.wide.values, point_);
    const Wide error = scaled_factor(data_, wide_unit) * value_of(data_, data_.wide.magnitudes, magnitude_);
    constexpr double largest = std::numeric_limits<double>::max();
    if (abs(value) > largest || error > largest) return {0, infinity};
    const auto rounded = value.convert_to<double>();
    return {rounded, error.convert_to<double>() * (1 + 0x1p-50) + std::abs(rounded) * 0x1p-52 + smallest};
}

Approximation Escalation::exactly() const {
    const mpq_class coordinates[] = {mpq_class(point_.x), mpq_class(point_.y), mpq_class(point_.z)};
    mpq_class value = algebra::evaluate(data_.exact, coordinates);
    if (data_.scale_exponent > 0)
        mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(data_.scale_exponent));
    else
        mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-data_.scale_exponent));
    if (sgn(value) == 0) return {0, 0};
    const double rounded = value.get_d(); // towards zero
    if (std::isinf(rounded)) return {rounded, infinity};
    if (rounded == 0) return {sgn(value) * smallest, smallest};
    return {rounded, std::abs(rounded) * 0x1p-52 + smallest};
}

void require_finite(const glm::dvec3& point) {
    if (!(std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z)))
        throw base::DomainError("evaluating a polynomial: expected finite coordinates");
}

int sign_of(double value) { return (value > 0) - (value < 0); }

} // namespace

int CompiledPolynomial::sign(const glm::dvec3& point) const {
    require_finite(point);
    const auto is_certain = [](const Approximation& a) {
        return std::isfinite(a.value) && std::abs(a.value) > a.error;
    };
    const Approximation fast{value(point), error_bound(point).value};
    if (is_certain(fast)) return sign_of(fast.value);
    return sign_of(Escalation(*data_, point).run(is_certain).value);
}

Approximation CompiledPolynomial::reliable_value(const glm::dvec3& point) const {
    require_finite(point);
    const auto is_close = [](const Approximation& a) {
        return std::isfinite(a.value) && a.error <= 0x1p-30 * std::abs(a.value);
    };
    const Approximation fast{value(point), error_bound(point).value};
    if (is_close(fast)) return fast;
    return Escalation(*data_, point).run(is_close);
}

} // namespace eliminant::field
