#include "field/precise_distance.hpp"

#include "eliminant/algebra/calculus.hpp"
#include "eliminant/algebra/evaluation.hpp"

#include "field/arithmetic.hpp"
#include "field/taylor_forms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace eliminant::field {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// s·a rounded up to a double, for s = 2^shift.
double scaled_up(const Wide& a, int shift) { return std::nextafter(to_double(ldexp(a, shift)), infinity); }

int exponent_of(const Wide& a) {
    int exponent = 0;
    frexp(a, &exponent);
    return exponent;
}

/// About log₂ of the smallest of (|f| / size of part k)^(1/k): the bound is near this power of two, and in
/// units of it no part is much larger than |f|.
int natural_scale(const LocalForms<Wide>& forms) {
    const int value = exponent_of(forms.value);
    std::optional<int> scale;
    const auto consider = [&](const Wide& size, int k) {
        if (!(size > 0)) return;
        const int candidate = (value - exponent_of(size)) / k;
        scale = scale ? std::min(*scale, candidate) : candidate;
    };
    consider(gradient_norm(forms), 1);
    consider(largest_entry(forms.half_hessian), 2);
    for (std::size_t k = 3; k < forms.size(); ++k) consider(forms.norms[k], static_cast<int>(k));
    return scale.value_or(0);
}

/// In doubles and in units of 2^scale and about |f|, where nothing of importance over- or underflows. What
/// the rounding to doubles does is added to the errors.
void set_in_units(LocalForms<double>& result, const LocalForms<Wide>& forms, int scale) {
    const int unit = -exponent_of(forms.value);
    for (std::size_t k = 0; k < forms.size(); ++k) {
        const int shift = unit + static_cast<int>(k) * scale;
        result.errors[k] = scaled_up(forms.errors[k], shift);
        if (k >= 3) result.norms[k] = scaled_up(forms.norms[k], shift);
    }
    const auto down = [&](const Wide& a, int k) { return to_double(ldexp(a, unit + k * scale)); };
    result.value = down(forms.value, 0);
    for (int i = 0; i < 3; ++i) result.gradient[i] = down(forms.gradient[i], 1);
    const Symmetric<Wide>& h = forms.half_hessian;
    result.half_hessian = {down(h.xx, 2), down(h.xy, 2), down(h.xz, 2),
                           down(h.yy, 2), down(h.yz, 2), down(h.zz, 2)};
    constexpr double tiny = std::numeric_limits<double>::min();
    const auto add_rounding = [&](std::size_t k, double size) {
        if (k < forms.size()) result.errors[k] += size * 0x1p-51 + tiny;
    };
    add_rounding(0, std::abs(result.value));
    add_rounding(1, 2 * gradient_norm(result));
    add_rounding(2, 9 * largest_entry(result.half_hessian));
}

/// ρ · 2^scale, rounded down.
double times_power_of_two(double rho, int scale) {
    const double result = std::ldexp(rho, scale);
    if (std::isinf(result) && !std::isinf(rho)) return std::numeric_limits<double>::max();
    return std::isnormal(result) || result == 0 ? result : std::nextafter(result, 0.0);
}

Estimate<double> distance_in_wide(const LocalForms<Wide>& forms, DistanceLevel level) {
    if (level == DistanceLevel::guaranteed) {
        const int scale = natural_scale(forms);
        LocalForms<double> in_doubles(forms.degree);
        set_in_units(in_doubles, forms, scale);
        const Estimate<double> bound = guaranteed_bound(in_doubles);
        return {std::isinf(bound.value) ? infinity : times_power_of_two(bound.value, scale),
                bound.uncertainty};
    }
    if (gradient_norm(forms) == 0 &&
        (level == DistanceLevel::first_order || largest_entry(forms.half_hessian) == 0))
        return {infinity, forms.degree > 0 && forms.errors[1] > 0 ? infinity : 0};
    const Estimate<Wide> result = estimate(forms, level);
    return {to_double(result.value), to_double(result.uncertainty)};
}

/// The forms at one point, in one arithmetic after the other.
class Precise {
  public:
    Precise(const DistanceField& field, const glm::dvec3& point, DistanceLevel level)
        : field_(field), data_(field.polynomial().data()),
          level_(level), coordinates_{point.x, point.y, point.z},
          r_(std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)})) {}

    Estimate<double> in_two_doubles() const {
        return result<DoubleDouble>(data_.double_doubles, field_.data().double_doubles, DoubleDouble::unit,
                                    [](const DoubleDouble& a) { return Wide(a.high) + Wide(a.low); });
    }
    Estimate<double> in_wide() const {
        return result<Wide>(data_.wide.values, field_.data().wide, wide_unit,
                            [](const Wide& a) { return a; });
    }

  private:
    template <class Number, class Convert>
    Estimate<double> result(const std::vector<Number>& coefficients, const std::vector<Number>& entries,
                            double unit, const Convert& convert) const {
        const Number point[3] = {Number(coordinates_[0]), Number(coordinates_[1]), Number(coordinates_[2])};
        LocalForms<Wide> forms(data_.degree);
        if (level_ == DistanceLevel::guaranteed && field_.data().taylor.is_complete) {
            std::vector<Number> expansion = entries;
            set_parts(forms, field_.data().taylor, point, expansion.data(), convert);
        } else {
            if (level_ == DistanceLevel::guaranteed) set_parts_by_majorant(forms, data_, Wide(r_));
            Number jet[jet_size];
            NestedHorner<PointArithmetic<Number>>::jet(data_.view, coefficients.data(), point, jet);
            set_jet(forms, jet, convert);
        }
        shifted_majorant(data_.majorant.data(), data_.majorant.size(), Wide(r_),
                         Wide(data_.error_factor) * (unit / 0x1p-53), &forms.errors[0]);
        return distance_in_wide(forms, level_);
    }

    const DistanceField& field_;
    const CompiledData& data_;
    DistanceLevel level_;
    std::array<double, 3> coordinates_;
    double r_;
};

bool is_certain(const Estimate<double>& result, DistanceLevel level) {
    return !std::isnan(result.value) &&
           result.uncertainty <= (level == DistanceLevel::guaranteed ? 0x1p-12 : 0x1p-30);
}

/// The forms by rationals; those of order 3 and more only if asked for. f is in a ring of x, y, z.
void set_exactly(LocalForms<Wide>& forms, const DistanceField& field, const std::array<mpq_class, 3>& point,
                 bool with_all_orders, base::Run& run) {
    const CompiledData& data = field.polynomial().data();
    const DistanceData& expansion = field.data();
    const algebra::Polynomial& f = data.exact;
    for (std::size_t k = 0; k < forms.size(); ++k)
        forms.errors[k] = 0; // of 256 bits, which the bound has room for
    const auto convert = [](const mpq_class& a) { return to_wide(a); };
    if (with_all_orders && expansion.taylor.is_complete) {
        std::vector<mpq_class> entries(expansion.taylor.size);
        for (std::size_t t = 0; t < f.size(); ++t) entries[expansion.taylor.slots[t]] = f.coefficient(t);
        set_parts(forms, expansion.taylor, point.data(), entries.data(), convert, [&run] { run.poll(); });
        return;
    }
    std::array<mpq_class, jet_size> jet;
    jet[at_value] = algebra::evaluate(f, point, run);
    std::size_t second = at_xx;
    for (std::size_t i = 0; i < 3; ++i) {
        const algebra::Polynomial first = algebra::derivative(f, i);
        jet[at_x + i] = algebra::evaluate(first, point, run);
        for (std::size_t j = i; j < 3; ++j)
            jet[second++] = algebra::evaluate(algebra::derivative(first, j), point, run);
    }
    set_jet(forms, jet.data(), convert);
    if (!with_all_orders) return;
    Wide r = 0;
    for (const mpq_class& x : point)
        if (const Wide magnitude = abs(to_wide(x)) * (1 + wide_unit); magnitude > r) r = magnitude;
    set_parts_by_majorant(forms, data, r);
    for (std::size_t k = 3; k < forms.size(); ++k)
        forms.norms[k] = ldexp(forms.norms[k], data.scale_exponent); // the jet is not scaled
}

} // namespace

double precise_distance(const DistanceField& field, const glm::dvec3& point, DistanceLevel level) {
    const Precise precise(field, point, level);
    // Two doubles reach no further than one.
    if (field.polynomial().error_bound(point).value < 0x1p500)
        if (const auto result = precise.in_two_doubles(); is_certain(result, level)) return result.value;
    if (const auto result = precise.in_wide(); is_certain(result, level)) return result.value;
    base::Run run;
    LocalForms<Wide> forms(field.polynomial().degree());
    set_exactly(forms, field, {mpq_class(point.x), mpq_class(point.y), mpq_class(point.z)},
                level == DistanceLevel::guaranteed, run);
    return distance_in_wide(forms, level).value;
}

std::vector<Distance> distances(const algebra::Polynomial& f, const std::array<mpq_class, 3>& point,
                                std::span<const DistanceLevel> levels, base::Run& run) {
    const DistanceField field(CompiledPolynomial(f, run));
    std::vector<Distance> result(levels.size());
    if (field.polynomial().is_zero()) return result;
    LocalForms<Wide> forms(field.polynomial().degree());
    set_exactly(forms, field, point, std::ranges::find(levels, DistanceLevel::guaranteed) != levels.end(),
                run);
    if (forms.value == 0) return result;
    for (std::size_t i = 0; i < levels.size(); ++i)
        result[i] = {distance_in_wide(forms, levels[i]).value, forms.value > 0 ? 1 : -1};
    return result;
}

Distance distance(const algebra::Polynomial& f, const std::array<mpq_class, 3>& point, DistanceLevel level,
                  base::Run& run) {
    return distances(f, point, {&level, 1}, run).front();
}

} // namespace eliminant::field
