#include "eliminant/field/distance.hpp"

#include "eliminant/base/error.hpp"

#include "field/arithmetic.hpp"
#include "field/distance_batch.hpp"
#include "field/positive_root.hpp"
#include "field/precise_distance.hpp"
#include "field/taylor_forms.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

namespace eliminant::field {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

double largest_coordinate(const glm::dvec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

double identity(double value) { return value; }

/// Value and two derivatives by the fast scheme, with their errors.
void set_jet_in_double(LocalForms<double>& forms, const CompiledPolynomial& f, const glm::dvec3& point) {
    const Jet jet = f.jet(point);
    const SymmetricMatrix& h = jet.hessian;
    const double components[jet_size] = {jet.value, jet.gradient.x, jet.gradient.y, jet.gradient.z, h.xx,
                                         h.xy,      h.xz,           h.yy,           h.yz,           h.zz};
    set_jet(forms, components, identity);
    const JetError error = f.error_bound(point);
    forms.errors[0] = error.value;
    if (forms.size() > 1) forms.errors[1] = error.gradient;
    if (forms.size() > 2) forms.errors[2] = error.hessian / 2;
}

void set_all_in_double(LocalForms<double>& forms, const DistanceField& field, const glm::dvec3& point) {
    const CompiledData& data = field.polynomial().data();
    const DistanceData& expansion = field.data();
    const double r = largest_coordinate(point);
    if (expansion.taylor.is_complete) {
        SmallBuffer<double, 512> entries(expansion.entries.size());
        std::memcpy(entries.data(), expansion.entries.data(), expansion.entries.size() * sizeof(double));
        set_parts(forms, expansion.taylor, &point.x, entries.data(), identity);
    } else {
        set_parts_by_majorant(forms, data, r);
        set_jet_in_double(forms, field.polynomial(), point);
    }
    shifted_majorant(data.majorant.data(), data.majorant.size(), r, data.error_factor, &forms.errors[0]);
}

void set_in_double(LocalForms<double>& forms, const DistanceField& field, const glm::dvec3& point,
                   DistanceLevel level) {
    if (level == DistanceLevel::guaranteed)
        set_all_in_double(forms, field, point);
    else
        set_jet_in_double(forms, field.polynomial(), point);
}

/// Whether the errors of doubles are small enough.
bool is_trusted(const Estimate<double>& result, const LocalForms<double>& forms, DistanceLevel level) {
    if (!(result.uncertainty <= (level == DistanceLevel::guaranteed ? 0x1p-12 : 0x1p-30))) return false;
    // Squares of what is beyond this have over- or underflowed.
    const double g = gradient_norm(forms);
    return result.value > 0 && g < 1e150 && (g > 1e-140 || g == 0);
}

std::shared_ptr<const DistanceData> make_distance_data(const CompiledPolynomial& f) {
    const CompiledData& compiled = f.data();
    std::vector<Exponents> terms(compiled.exact.size());
    for (std::size_t t = 0; t < terms.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            terms[t][i] = static_cast<std::uint32_t>(compiled.exact.exponent(t, i));
    auto data = std::make_shared<DistanceData>();
    data->taylor = make_taylor_scheme(terms);
    if (!data->taylor.is_complete) return data;
    for (std::size_t k = 3; k < data->taylor.parts.size(); ++k) {
        const auto& part = data->taylor.parts[k];
        data->components.insert(data->components.end(), part.begin(), part.end());
        data->component_ends.push_back(static_cast<std::uint32_t>(data->components.size()));
    }
    data->entries.assign(data->taylor.size, 0);
    data->double_doubles.assign(data->taylor.size, 0.0);
    data->wide.assign(data->taylor.size, Wide(0));
    for (std::size_t t = 0; t < terms.size(); ++t) {
        const std::uint32_t from = compiled.scheme.slots[t];
        const std::uint32_t to = data->taylor.slots[t];
        data->entries[to] = compiled.coefficients[from];
        data->double_doubles[to] = compiled.double_doubles[from];
        data->wide[to] = compiled.wide.values[from];
    }
    return data;
}

} // namespace

ExpansionView DistanceData::view(const CompiledData& compiled) const {
    const TaylorScheme& t = taylor;
    return {static_cast<std::size_t>(std::max(compiled.degree, 0)),
            t.size,
            {t.coordinates[0], t.coordinates[1], t.coordinates[2]},
            entries.data(),
            t.lines.data(),
            t.lines.data() + t.lines.size(),
            t.steps.data(),
            t.steps.data() + t.steps.size(),
            t.low.data(),
            components.data(),
            component_ends.data(),
            compiled.majorant.data(),
            compiled.error_factor};
}

std::string_view to_string(DistanceLevel level) {
    switch (level) {
    case DistanceLevel::first_order:
        return "first_order";
    case DistanceLevel::second_order:
        return "second_order";
    case DistanceLevel::second_order_frobenius:
        return "second_order_frobenius";
    case DistanceLevel::guaranteed:
        break;
    }
    return "guaranteed";
}

DistanceField::DistanceField(CompiledPolynomial f) : f_(std::move(f)), data_(make_distance_data(f_)) {}

Estimate<double> guaranteed_bound(const LocalForms<double>& forms) {
    // More than the roundings of each norm, a sum of at most (k+1)(k+2)/2 squares.
    const double up = 1 + (forms.degree + 8.0) * (forms.degree + 8.0) * 0x1p-52;
    const double value = (std::abs(forms.value) - forms.error(0)) * (1 - 0x1p-50);
    if (!(value > 0)) return {0, infinity};
    SmallBuffer<double, 33> higher(forms.size());
    for (std::size_t k = 3; k < forms.size(); ++k) higher[k - 3] = (forms.norms[k] + forms.errors[k]) * up;
    const std::size_t count = forms.size() < 3 ? 0 : forms.size() - 3;

    FallingPolynomial phi{value, 0, 0, {higher.data(), count}};
    phi.linear = (gradient_norm(forms) + forms.error(1)) * up;
    // Towards 0 is down where f > 0.
    const double towards = forms.value > 0 ? -1 : 1;
    const double turn = largest_eigenvalue_bound(towards * forms.half_hessian, 0x1p-46);
    phi.quadratic = turn + forms.error(2);
    phi.quadratic += std::abs(phi.quadratic) * 0x1p-50;
    const double rho = positive_until(phi);

    double lost = 0;
    if (!std::isinf(rho))
        for (std::size_t k = forms.size(); k-- > 0;) lost = lost * rho + forms.errors[k];
    return {rho, lost / value};
}

Distance distance(const DistanceField& field, const glm::dvec3& point, DistanceLevel level) {
    const CompiledPolynomial& f = field.polynomial();
    if (!is_finite(point))
        return {level == DistanceLevel::guaranteed ? 0 : std::numeric_limits<double>::quiet_NaN(), 0};
    if (f.is_zero()) return {0, 0};
    LocalForms<double> forms(f.degree());
    set_in_double(forms, field, point, level);
    const bool is_bound = level == DistanceLevel::guaranteed;
    return trusted_or_precise(is_bound ? guaranteed_bound(forms) : estimate(forms, level), forms, field,
                              point, level);
}

Distance trusted_or_precise(const Estimate<double>& result, const LocalForms<double>& forms,
                            const DistanceField& field, const glm::dvec3& point, DistanceLevel level) {
    if (is_trusted(result, forms, level)) return {result.value, forms.value > 0 ? 1 : -1};
    const int sign = field.polynomial().sign(point);
    if (sign == 0) return {0, 0};
    return {precise_distance(field, point, level), sign};
}

double distance_from_ball(const DistanceField& field, const glm::dvec3& center, double radius) {
    if (!(radius >= 0)) throw base::DomainError("distance from a ball: expected a radius ≥ 0");
    const double bound = distance(field, center, DistanceLevel::guaranteed).value;
    if (std::isinf(bound)) return bound;
    return std::max(0.0, std::nextafter(bound - radius, -infinity));
}

double distance_from_box(const DistanceField& field, const glm::dvec3& lower, const glm::dvec3& upper) {
    if (!(lower.x <= upper.x && lower.y <= upper.y && lower.z <= upper.z))
        throw base::DomainError("distance from a box: expected lower ≤ upper in each coordinate");
    const glm::dvec3 center = lower + 0.5 * (upper - lower);
    // Each half side as seen from the center that was rounded.
    const glm::dvec3 half = glm::max(upper - center, center - lower);
    return distance_from_ball(field, center,
                              glm::length(half) * (1 + 0x1p-50) + std::numeric_limits<double>::min());
}

} // namespace eliminant::field
