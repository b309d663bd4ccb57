#include "eliminant/field/ray_roots.hpp"

#include "field/beam_layout.hpp"
#include "field/double_double.hpp"
#include "field/dyadic.hpp"
#include "field/first_root.hpp"
#include "field/ray_roots_data.hpp"

#include "eliminant/base/error.hpp"
#include "eliminant/field/ray_restriction.hpp"
#include "eliminant/field/real_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

namespace eliminant::field {

namespace {

constexpr std::size_t most_coefficients = max_kernel_degree + 1;

/// start + step·s for s ∈ [−1, 1].
struct Coordinate {
    DoubleDouble start;
    DoubleDouble step;
};
struct Line {
    std::array<Coordinate, 3> coordinates;
    double reach = 0.0;   ///< bounds all coordinates on it
    double largest = 0.0; ///< bounds what the coordinates were summed from: they err by 2^-101 of this
};

/// The ray on [lower, upper]; s = ±1 are the interval's ends exactly.
Line line_on_interval(const WideRay& ray, double lower, double upper) {
    const DoubleDouble half{0.5};
    const DoubleDouble middle = two_sum(lower, upper) * half;
    const DoubleDouble radius = two_sum(upper, -lower) * half;
    Line line;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        line.coordinates[axis].start = ray.origin[axis] + middle * ray.direction[axis];
        line.coordinates[axis].step = radius * ray.direction[axis];
        const double largest = ray.origin_size[axis] +
                               (std::abs(middle.high) + std::abs(radius.high)) * ray.direction_size[axis];
        line.largest = std::max(line.largest, largest);
        line.reach = std::max(line.reach, std::abs(line.coordinates[axis].start.high) +
                                              std::abs(line.coordinates[axis].step.high));
    }
    line.reach *= 1.0 + 0x1p-40;
    line.largest *= 1.0 + 0x1p-40;
    return line;
}

/// At least Σ |c| r^m over the terms, m being their degrees and r a bound of all coordinates on the line: it
/// bounds the sum of the absolute coefficients of the restriction, also when nothing cancels.
double majorant_on(const RayRootsData& data, const Line& line) {
    double sum = 0.0;
    for (std::size_t m = data.majorant.size(); m-- > 0;) sum = sum * line.reach + data.majorant[m];
    return sum;
}

template <class Number>
Number converted(DoubleDouble x) {
    if constexpr (std::is_same_v<Number, double>)
        return x.high;
    else
        return x;
}

/// Univariate polynomials of degree ≤ max_kernel_degree that are built up by Horner's scheme.
template <class Number>
struct Univariate {
    std::array<Number, most_coefficients> c{};
    std::size_t degree = 0;

    /// *this · (start + step·s)
    void multiply(Number start, Number step) {
        c[degree + 1] = c[degree] * step;
        for (std::size_t i = degree; i > 0; --i) c[i] = c[i] * start + c[i - 1] * step;
        c[0] = c[0] * start;
        ++degree;
    }
    void add(const Univariate& other) {
        for (std::size_t i = 0; i <= other.degree; ++i) c[i] = c[i] + other.c[i];
        degree = std::max(degree, other.degree);
    }
};

/// The polynomial on the line, by Horner's scheme in three variables.
template <class Number>
Univariate<Number> restrict_to_line(const RayRootsData& data, const Line& line) {
    const std::size_t n = data.layout.degree();
    std::array<Number, 3> start;
    std::array<Number, 3> step;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        start[axis] = converted<Number>(line.coordinates[axis].start);
        step[axis] = converted<Number>(line.coordinates[axis].step);
    }
    Univariate<Number> in_x;
    for (std::size_t i = n + 1; i-- > 0;) {
        if (i < n) in_x.multiply(start[0], step[0]);
        Univariate<Number> in_y;
        for (std::size_t j = n - i + 1; j-- > 0;) {
            if (j < n - i) in_y.multiply(start[1], step[1]);
            Univariate<Number> in_z;
            const DoubleDouble* const c = &data.coefficients[data.layout.start(i, j)];
            for (std::size_t k = n - i - j + 1; k-- > 0;) {
                if (k < n - i - j) in_z.multiply(start[2], step[2]);
                in_z.c[0] = in_z.c[0] + converted<Number>(c[k]);
            }
            in_y.add(in_z);
        }
        in_x.add(in_y);
    }
    return in_x;
}

/// The search in one precision; nothing if it stays undecided.
template <class Number>
std::optional<RayRoot> search(const RayRootsData& data, const Line& line, double majorant, double lower,
                              double upper) {
    constexpr bool is_wide = std::is_same_v<Number, DoubleDouble>;
    const std::size_t n = data.layout.degree();
    const Univariate<Number> p = restrict_to_line<Number>(data, line);
    // Each coefficient of f takes part in at most 3n multiplications by a coordinate and as many additions;
    // it and the coordinates were rounded themselves.
    const double unit = is_wide ? DoubleDouble::unit : 0x1p-53;
    const double error = (10.0 * static_cast<double>(n) + 4.0) * unit * majorant + 0x1p-960;
    const FirstRootAnswer answer = first_root(std::span<const Number>(p.c.data(), n + 1), error, -1.0, 1.0);
    // Near the ends only exact arithmetic tells in from out.
    constexpr double inner = 1.0 - 0x1p-40;
    if (answer.state == RayState::undecided) return std::nullopt;
    if (answer.state == RayState::root && std::abs(answer.root) > inner) return std::nullopt;
    RayRoot root;
    root.precision = is_wide ? Precision::wide : Precision::doubles;
    root.side = answer.side;
    root.steps = answer.steps;
    if (answer.state == RayState::root) {
        root.kind = RayRoot::Kind::crossing;
        root.multiplicity = 1;
        root.t =
            std::clamp((0.5 * lower + 0.5 * upper) + (0.5 * upper - 0.5 * lower) * answer.root, lower, upper);
    }
    return root;
}

void require(const glm::dvec3& origin, const glm::dvec3& direction, double lower, double upper) {
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(origin[axis]) || !std::isfinite(direction[axis]))
            throw base::DomainError("roots on a ray: origin and direction must be finite numbers");
    if (!std::isfinite(lower) || std::isnan(upper))
        throw base::DomainError(
            "roots on a ray: the interval must start at a finite number and end at a number");
}

RayRoot contained_at(double t) {
    RayRoot root;
    root.kind = RayRoot::Kind::contained;
    root.precision = Precision::exact;
    root.t = t;
    return root;
}

RayRoot from_exact(const RealRoot& exact) {
    RayRoot root;
    root.kind = exact.multiplicity % 2 != 0 ? RayRoot::Kind::crossing : RayRoot::Kind::tangency;
    root.t = exact.value;
    root.side = exact.sign_before;
    root.multiplicity = exact.multiplicity;
    root.precision = Precision::exact;
    return root;
}

bool all_zero(std::span<const mpz_class> p) {
    return std::ranges::all_of(p, [](const mpz_class& c) { return c == 0; });
}

/// Sign of Σ p_i t^i, exactly.
int sign_at(std::span<const mpz_class> p, double t) {
    const mpq_class x(t);
    mpq_class value = 0;
    for (std::size_t i = p.size(); i-- > 0;) value = value * x + p[i];
    return sgn(value);
}

} // namespace

std::optional<RayRoot> first_root_on_ray(const RayRootsData& data, const WideRay& ray, double lower,
                                         double upper) {
    if (data.layout.degree() == 0 || !(lower < upper) || !std::isfinite(upper)) return std::nullopt;
    const Line line = line_on_interval(ray, lower, upper);
    const double majorant = majorant_on(data, line);
    if (!(majorant < 0x1p900) || !(line.largest < 0x1p40 * line.reach)) return std::nullopt;
    if (const auto root = search<double>(data, line, majorant, lower, upper)) return root;
    return search<DoubleDouble>(data, line, majorant, lower, upper);
}

RayRoots::RayRoots(const algebra::Polynomial& f) {
    if (!f.ring().field().is_rationals())
        throw base::DomainError("roots on rays: a polynomial over the rationals is expected");
    if (f.ring().variable_count() > 3)
        throw base::DomainError("roots on rays: a polynomial in at most three variables is expected");
    const bool in_floats = f.total_degree() >= 1 && f.total_degree() <= std::int64_t{max_kernel_degree};
    auto data = std::make_shared<RayRootsData>(f, in_floats ? static_cast<std::size_t>(f.total_degree()) : 0);
    data->is_zero = f.is_zero();
    if (in_floats) {
        std::size_t bits = 0;
        for (const algebra::Integer& c : f.integer_terms().coefficients)
            bits = std::max(bits, c.bit_length());
        for (std::size_t i = 0; i < f.size(); ++i) {
            std::array<std::size_t, 3> e{};
            for (std::size_t v = 0; v < f.ring().variable_count(); ++v) e[v] = f.exponent(i, v);
            const DoubleDouble c =
                to_double_double(f.integer_terms().coefficients[i].to_mpz(), static_cast<long>(bits));
            data->coefficients[data->layout.start(e[0], e[1]) + e[2]] = c;
            data->majorant[e[0] + e[1] + e[2]] += std::abs(c.high) * (1.0 + 0x1p-40);
        }
    }
    if (SparseRay::is_for(f)) data->sparse.emplace(f);
    data_ = std::move(data);
}

RayRoot RayRoots::first(const glm::dvec3& origin, const glm::dvec3& direction, double lower, double upper,
                        base::Run& run) const {
    require(origin, direction, lower, upper);
    if (!(lower <= upper)) return {};
    if (data_->is_zero) return contained_at(lower);
    if (data_->sparse)
        if (const auto root = data_->sparse->first(origin, direction, lower, upper, run)) return *root;
    WideRay ray;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        ray.origin[i] = origin[axis];
        ray.direction[i] = direction[axis];
        ray.origin_size[i] = std::abs(origin[axis]);
        ray.direction_size[i] = std::abs(direction[axis]);
    }
    if (const auto root = first_root_on_ray(*data_, ray, lower, upper)) return *root;
    const std::vector<mpz_class> exact = restrict_to_ray(data_->f, origin, direction, run);
    if (all_zero(exact)) return contained_at(lower);
    if (const auto root = first_real_root(exact, lower, upper, run)) return from_exact(*root);
    RayRoot none;
    none.side = sign_at(exact, lower);
    none.precision = Precision::exact;
    return none;
}

std::vector<RayRoot> RayRoots::all(const glm::dvec3& origin, const glm::dvec3& direction, double lower,
                                   double upper, base::Run& run) const {
    require(origin, direction, lower, upper);
    if (!(lower <= upper)) return {};
    const std::vector<mpz_class> exact = restrict_to_ray(data_->f, origin, direction, run);
    if (all_zero(exact)) return {contained_at(lower)};
    std::vector<RayRoot> roots;
    for (const RealRoot& root : real_roots(exact, lower, upper, run)) roots.push_back(from_exact(root));
    return roots;
}

} // namespace eliminant::field
