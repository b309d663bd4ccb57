#include "eliminant/field/range.hpp"

#include "eliminant/base/error.hpp"

#include "field/bounds.hpp"
#include "field/compiled_data.hpp"
#include "field/distance_data.hpp"
#include "field/local_forms.hpp"
#include "field/nested_horner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace eliminant::field {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Range everything = {-infinity, infinity};

/// Intervals for the kernels. A coefficient has been rounded twice.
struct BoundsArithmetic {
    using Scalar = double;
    using Pack = Bounds;

    static Pack zero() { return {0, 0}; }
    static Pack broadcast(double value) { return value == 0 ? Bounds{0, 0} : outward(value, value); }
    static Pack add(Pack a, Pack b) { return a + b; }
    static Pack multiply(Pack a, Pack b) { return a * b; }
    static Pack multiply_add(Pack a, Pack b, Pack c) { return a * b + c; }
};

/// Bounds are sound only where nothing overflows.
Range checked(Bounds b) {
    return std::isfinite(b.lower) && std::isfinite(b.upper) ? Range{b.lower, b.upper} : everything;
}

Range horner_range(const CompiledData& data, const Box& box) {
    const Bounds point[3] = {
        {box.lower.x, box.upper.x}, {box.lower.y, box.upper.y}, {box.lower.z, box.upper.z}};
    return checked(NestedHorner<BoundsArithmetic>::value(data.view, data.coefficients.data(), point));
}

/// f(origin + q) in doubles: entries of the TaylorScheme, and how much those of each order err together.
struct Expansion {
    Expansion(const DistanceField& field, const glm::dvec3& origin)
        : entries(field.data().entries), errors(field.polynomial().data().majorant.size()) {
        const CompiledData& data = field.polynomial().data();
        shift_to(field.data().taylor, &origin.x, entries.data(), [] {});
        const double r = std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)});
        shifted_majorant(data.majorant.data(), data.majorant.size(), r, data.error_factor, errors.data());
    }
    /// What the errors amount to where all |q_i| ≤ size.
    double error(double size) const {
        double sum = 0;
        for (std::size_t k = errors.size(); k-- > 0;) sum = sum * size + errors[k];
        return sum * (1 + 0x1p-40) + 0x1p-900;
    }

    std::vector<double> entries;
    std::vector<double> errors;
};

/// 1, h, h², … rounded up.
std::vector<double> powers_of(double h, std::size_t count) {
    std::vector<double> result(count + 1, 1);
    for (std::size_t i = 1; i <= count; ++i) result[i] = result[i - 1] * h * (1 + 0x1p-51) + 0x1p-1000;
    return result;
}

/// Calls body(entry, exponents of u, v, w).
template <class Body>
void for_each_entry(const TaylorScheme& scheme, const Body& body) {
    for (const TaylorScheme::FilledLine& line : scheme.filled)
        for (std::uint32_t k = 0; k < line.count; ++k) body(line.first + k, Exponents{line.i, line.j, k});
}

Exponents degrees_of(const TaylorScheme& scheme) {
    Exponents most = {};
    for (const TaylorScheme::FilledLine& line : scheme.filled)
        most = {std::max(most[0], line.i), std::max(most[1], line.j), std::max(most[2], line.count - 1)};
    return most;
}

/// q_i ↦ size_i · q_i of a box, in the levels of the scheme.
class Scales {
  public:
    Scales(const TaylorScheme& scheme, const glm::dvec3& size) {
        const Exponents most = degrees_of(scheme);
        for (std::size_t level = 0; level < 3; ++level)
            powers_[level] = powers_of(size[scheme.coordinates[level]], most[level]);
    }
    double operator()(const Exponents& e) const {
        return powers_[0][e[0]] * powers_[1][e[1]] * powers_[2][e[2]];
    }

  private:
    std::array<std::vector<double>, 3> powers_;
};

Range taylor_range(const DistanceField& field, const Box& box) {
    const TaylorScheme& scheme = field.data().taylor;
    if (!scheme.is_complete) return everything;
    const glm::dvec3 center = box.lower + 0.5 * (box.upper - box.lower);
    const glm::dvec3 half = glm::max(box.upper - center, center - box.lower) * (1 + 0x1p-51);
    const Expansion f(field, center);
    const Scales scale(scheme, half);
    double below = 0;
    double above = 0;
    double constant = 0;
    double sum = 0; // NaN or infinite where anything overflows
    for_each_entry(scheme, [&](std::uint32_t entry, const Exponents& e) {
        const double size = f.entries[entry] * scale(e);
        sum += std::abs(size);
        if (e == Exponents{}) {
            constant = size;
            return;
        }
        const bool is_even =
            e[0] % 2 == 0 && e[1] % 2 == 0 && e[2] % 2 == 0; // then in [0, size] or [size, 0]
        below += is_even ? std::max(0.0, -size) : std::abs(size);
        above += is_even ? std::max(0.0, size) : std::abs(size);
    });
    const double slack = 2 * sum * static_cast<double>(scheme.size + 16) * 0x1p-52 +
                         f.error(std::max({half.x, half.y, half.z}));
    return checked({constant - below - slack, constant + above + slack});
}

/// From the coefficients of t^0, …, t^n along an axis of a tensor to those of Bernstein's basis of [0, 1]:
/// b_i = Σ_{k ≤ i} C(i, k)/C(n, k) a_k, by a triangle of additions.
void to_bernstein(std::span<double> tensor, std::size_t count, std::size_t stride) {
    const std::size_t n = count - 1;
    std::vector<double> weights(count, 1);
    for (std::size_t k = 1; k <= n; ++k)
        weights[k] = weights[k - 1] * static_cast<double>(k) / static_cast<double>(n - k + 1);
    for (std::size_t block = 0; block < tensor.size(); block += count * stride)
        for (std::size_t offset = 0; offset < stride; ++offset) {
            double* a = tensor.data() + block + offset;
            for (std::size_t k = 0; k <= n; ++k) a[k * stride] *= weights[k];
            for (std::size_t done = 0; done < n; ++done)
                for (std::size_t i = n; i > done; --i) a[i * stride] += a[(i - 1) * stride];
        }
}

constexpr std::size_t max_tensor = std::size_t{1} << 22;

std::size_t tensor_size(const TaylorScheme& scheme) {
    const Exponents most = degrees_of(scheme);
    return (std::size_t{most[0]} + 1) * (std::size_t{most[1]} + 1) * (std::size_t{most[2]} + 1);
}

Range bernstein_range(const DistanceField& field, const Box& box) {
    const TaylorScheme& scheme = field.data().taylor;
    if (!scheme.is_complete || tensor_size(scheme) > max_tensor) return everything;
    const Expansion f(field, box.lower);
    const glm::dvec3 size = (box.upper - box.lower) * (1 + 0x1p-51);
    const Scales scale(scheme, size);
    const Exponents most = degrees_of(scheme);
    const std::array<std::size_t, 3> counts = {most[0] + std::size_t{1}, most[1] + std::size_t{1},
                                               most[2] + std::size_t{1}};
    std::vector<double> tensor(counts[0] * counts[1] * counts[2], 0);
    double sum = 0;
    for_each_entry(scheme, [&](std::uint32_t entry, const Exponents& e) {
        const double a = f.entries[entry] * scale(e);
        tensor[(e[0] * counts[1] + e[1]) * counts[2] + e[2]] = a;
        sum += std::abs(a);
    });
    to_bernstein(tensor, counts[2], 1);
    to_bernstein(tensor, counts[1], counts[2]);
    to_bernstein(tensor, counts[0], counts[1] * counts[2]);
    // Weights are at most 1, so each coefficient errs by at most a part of the sum of all.
    const double roundings = 6.0 * static_cast<double>(counts[0] + counts[1] + counts[2]) + 16;
    const double slack = sum * (roundings + static_cast<double>(scheme.size)) * 0x1p-53 * (1 + 0x1p-20) +
                         f.error(std::max({size.x, size.y, size.z}));
    const auto [least, greatest] = std::ranges::minmax_element(tensor);
    return checked({*least - slack, *greatest + slack});
}

constexpr std::size_t affordable_tensor = 4096;

bool excludes_zero(const Range& range) { return range.lower > 0 || range.upper < 0; }

Range automatic_range(const DistanceField& field, const Box& box) {
    if (!field.data().taylor.is_complete) return horner_range(field.polynomial().data(), box);
    const Range taylor = taylor_range(field, box);
    if (excludes_zero(taylor) || tensor_size(field.data().taylor) > affordable_tensor) return taylor;
    const Range bernstein = bernstein_range(field, box);
    return {std::max(taylor.lower, bernstein.lower), std::min(taylor.upper, bernstein.upper)};
}

bool is_finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

CertainSign to_sign(int sign) { return static_cast<CertainSign>(sign); }

} // namespace

std::string_view to_string(RangeForm form) {
    switch (form) {
    case RangeForm::horner:
        return "horner";
    case RangeForm::taylor:
        return "taylor";
    case RangeForm::bernstein:
        return "bernstein";
    case RangeForm::automatic:
        break;
    }
    return "automatic";
}

Range range(const DistanceField& field, const Box& box, RangeForm form) {
    if (!(is_finite(box.lower) && is_finite(box.upper) && box.lower.x <= box.upper.x &&
          box.lower.y <= box.upper.y && box.lower.z <= box.upper.z))
        throw base::DomainError("range of a polynomial: expected a box with finite lower ≤ upper");
    if (field.polynomial().is_zero()) return {0, 0};
    switch (form) {
    case RangeForm::horner:
        return horner_range(field.polynomial().data(), box);
    case RangeForm::taylor:
        return taylor_range(field, box);
    case RangeForm::bernstein:
        return bernstein_range(field, box);
    case RangeForm::automatic:
        break;
    }
    return automatic_range(field, box);
}

CertainSign sign_on_box(const DistanceField& field, const Box& box) {
    const Range values = range(field, box);
    if (excludes_zero(values)) return values.lower > 0 ? CertainSign::positive : CertainSign::negative;
    if (distance_from_box(field, box.lower, box.upper) > 0)
        return to_sign(field.polynomial().sign(box.lower));
    return CertainSign::unknown;
}

CertainSign sign_on_ball(const DistanceField& field, const glm::dvec3& center, double radius) {
    if (distance_from_ball(field, center, radius) > 0) return to_sign(field.polynomial().sign(center));
    return CertainSign::unknown;
}

} // namespace eliminant::field
