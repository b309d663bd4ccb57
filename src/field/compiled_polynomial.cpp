#include "eliminant/field/compiled_polynomial.hpp"

#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/algebra/parse.hpp"
#include "eliminant/base/error.hpp"

#include "field/arithmetic.hpp"
#include "field/compiled_data.hpp"
#include "field/exact_coefficients.hpp"
#include "field/formula.hpp"
#include "field/scheme_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace eliminant::field {

namespace {

using algebra::Polynomial;
using base::DomainError;
using base::OverflowError;

constexpr double infinity = std::numeric_limits<double>::infinity();

Polynomial in_coordinates(const Polynomial& f) {
    if (!f.ring().field().is_rationals())
        throw DomainError("compiling a polynomial: expected coefficients in QQ, found " +
                          f.ring().field().to_string());
    const std::size_t count = f.ring().variable_count();
    std::vector<std::size_t> map(count, Polynomial::dropped);
    for (std::size_t i = 0; i < std::min<std::size_t>(count, 3); ++i) map[i] = i;
    for (std::size_t i = 3; i < count; ++i)
        if (f.degree(i) > 0)
            throw DomainError("compiling a polynomial: expected a polynomial in the coordinates, found '" +
                              f.ring().names()[i] + "', which has no value");
    return f.in_ring(algebra::Ring(algebra::CoefficientField::rationals(), {"x", "y", "z"}), map);
}

Polynomial in_region(const Polynomial& f, const Region& region, base::Run& run) {
    if (sgn(region.scale) == 0)
        throw DomainError("compiling a polynomial: expected a region of nonzero scale");
    const Polynomial g = in_coordinates(f);
    std::vector<Polynomial> images;
    for (std::size_t i = 0; i < 3; ++i)
        images.push_back(Polynomial::variable(g.ring(), i).scaled(region.scale) +
                         Polynomial::constant(g.ring(), region.center[i]));
    return algebra::compose(g, g.ring(), images, run);
}

/// The exponent that makes the largest coefficient about 1, or 0 if it is within 2^±limit anyway.
int scale_exponent_for(long largest, long limit) {
    if (std::abs(largest) <= limit) return 0;
    if (std::abs(largest) > std::numeric_limits<int>::max() / 2)
        throw OverflowError("compiling a polynomial: a coefficient exceeds 2^(2^30)");
    return static_cast<int>(largest);
}

void set_coefficients(CompiledData& data, const std::vector<mpq_class>& exact, const base::Run& run) {
    long largest = std::numeric_limits<long>::min();
    for (const mpq_class& c : exact) largest = std::max(largest, binary_exponent(c));
    data.scale_exponent = exact.empty() ? 0 : scale_exponent_for(largest, 300);
    data.scale_exponent_float = exact.empty() ? 0 : scale_exponent_for(largest, 30);

    const std::size_t size = data.scheme.size;
    data.coefficients.assign(size, 0);
    data.magnitudes.assign(size, 0);
    data.double_doubles.assign(size, 0.0);
    data.wide.values.assign(size, Wide(0));
    data.wide.magnitudes.assign(size, Wide(0));
    for (std::size_t t = 0; t < exact.size(); ++t) {
        run.poll();
        const std::uint32_t slot = data.scheme.slots[t];
        const mpq_class scaled = times_power_of_two(exact[t], -data.scale_exponent);
        data.wide.values[slot] = to_wide(scaled);
        data.wide.magnitudes[slot] = abs(data.wide.values[slot]);
        data.double_doubles[slot] = to_double_double(scaled);
        data.coefficients[slot] = data.double_doubles[slot].high;
        data.magnitudes[slot] = std::abs(data.coefficients[slot]);
    }
}

void set_bounds(CompiledData& data, std::span<const Exponents> terms) {
    constexpr double unit = 0x1p-53;
    const auto degree = static_cast<std::size_t>(std::max(data.degree, 0));
    // The last summands are the roundings of the bounds themselves.
    data.error_factor = static_cast<double>(data.scheme.roundings() + 4 * degree + 32) * unit * (1 + 0x1p-20);
    data.majorant.assign(degree + 1, 0);
    for (std::size_t t = 0; t < terms.size(); ++t)
        data.majorant[terms[t][0] + terms[t][1] + terms[t][2]] += data.magnitudes[data.scheme.slots[t]];
    for (double& sum : data.majorant) sum = sum * (1 + 0x1p-26) + 0x1p-900; // at most 2^24 additions each
}

std::shared_ptr<CompiledData> expanded_data(Polynomial f, const base::Run& run) {
    if (f.total_degree() > CompiledPolynomial::max_degree)
        throw OverflowError("compiling a polynomial: expected a degree of at most " +
                            std::to_string(CompiledPolynomial::max_degree) + ", found " +
                            std::to_string(f.total_degree()));
    auto data = std::make_shared<CompiledData>(std::move(f));
    const Polynomial& exact = data->exact;
    data->degree = static_cast<int>(exact.total_degree());
    std::vector<Exponents> terms(exact.size());
    std::vector<mpq_class> coefficients(exact.size());
    for (std::size_t t = 0; t < exact.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) terms[t][i] = static_cast<std::uint32_t>(exact.exponent(t, i));
        coefficients[t] = exact.coefficient(t);
    }
    data->scheme = make_nested_scheme(terms);
    data->view = data->scheme.view();
    set_coefficients(*data, coefficients, run);
    set_bounds(*data, terms);
    return data;
}

/// \param formula the structure of f, if it is known
/// \param box where f will be evaluated, or nothing
std::shared_ptr<const CompiledData> compile(Polynomial f, const std::optional<Formula>& formula,
                                            const std::optional<Box>& box, base::Run& run) {
    const std::shared_ptr<CompiledData> data = expanded_data(std::move(f), run);
    choose_scheme(*data, formula, box, run);
    return data;
}

double largest_coordinate(const glm::dvec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

bool is_finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

using Kernel = ProgramKernel<PointArithmetic<double>>;

Jet to_jet(const double* jet) {
    return {jet[at_value],
            {jet[at_x], jet[at_y], jet[at_z]},
            {jet[at_xx], jet[at_xy], jet[at_xz], jet[at_yy], jet[at_yz], jet[at_zz]}};
}

/// A point as the scheme sees it.
glm::dvec3 from_center(const CompiledData& data, const glm::dvec3& point) {
    const auto& c = data.program.center;
    return {point.x - c[0], point.y - c[1], point.z - c[2]};
}

const Box& checked(const Box& box) {
    if (is_finite(box.lower) && is_finite(box.upper) && box.lower.x <= box.upper.x &&
        box.lower.y <= box.upper.y && box.lower.z <= box.upper.z)
        return box;
    throw DomainError("compiling a polynomial: expected a box with finite lower ≤ upper");
}

/// M(r), M'(r) and M''(r).
JetError majorant_at(const JetProgram& program, double r) {
    double sum = 0;
    double first = 0;
    double half_second = 0;
    for (std::size_t k = program.majorant.size(); k-- > 0;) {
        half_second = half_second * r + first;
        first = first * r + sum;
        sum = sum * r + program.majorant[k];
    }
    return {sum, first, 2 * half_second};
}

double never_nan(double bound) { return std::isnan(bound) ? infinity : bound; }

} // namespace

double SymmetricMatrix::frobenius_norm() const {
    return std::sqrt(xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz));
}

CompiledPolynomial::CompiledPolynomial(const Polynomial& f) {
    base::Run run;
    *this = CompiledPolynomial(f, run);
}

CompiledPolynomial::CompiledPolynomial(const Polynomial& f, base::Run& run)
    : data_(compile(in_coordinates(f), std::nullopt, std::nullopt, run)) {}

CompiledPolynomial::CompiledPolynomial(const Polynomial& f, const Region& region, base::Run& run)
    : data_(compile(in_region(f, region, run), std::nullopt, std::nullopt, run)) {}

CompiledPolynomial::CompiledPolynomial(const Polynomial& f, const Box& box, base::Run& run)
    : data_(compile(in_coordinates(f), std::nullopt, checked(box), run)) {}

CompiledPolynomial CompiledPolynomial::of_formula(const base::SourceText& text, base::Run& run) {
    const algebra::Ring ring(algebra::CoefficientField::rationals(), {"x", "y", "z"});
    Polynomial f = algebra::parse_equation(ring, text, run);
    const Formula formula = formula_of_text(f, text, run);
    return CompiledPolynomial(compile(std::move(f), formula, std::nullopt, run));
}

int CompiledPolynomial::degree() const { return data_->degree; }
const Polynomial& CompiledPolynomial::polynomial() const { return data_->exact; }
int CompiledPolynomial::scale_exponent() const { return data_->scale_exponent; }
int CompiledPolynomial::scale_exponent_float() const { return data_->scale_exponent_float; }

std::span<const EvaluationScheme> CompiledPolynomial::schemes() const { return data_->schemes; }

double CompiledPolynomial::value(const glm::dvec3& point) const {
    const glm::dvec3 p = from_center(*data_, point);
    return Kernel::value(data_->program_view, data_->program.coefficients.data(), &p.x);
}

Jet CompiledPolynomial::jet(const glm::dvec3& point) const {
    const glm::dvec3 p = from_center(*data_, point);
    double jet[jet_size];
    Kernel::jet(data_->program_view, data_->program.coefficients.data(), &p.x, jet);
    return to_jet(jet);
}

JetError CompiledPolynomial::error_bound(const glm::dvec3& point) const {
    if (!is_finite(point)) return {infinity, infinity, infinity};
    const JetProgram& program = data_->program;
    const double r = largest_coordinate(from_center(*data_, point));
    if (r > program.safe_radius()) return {infinity, infinity, infinity};
    const JetError sums = majorant_at(program, r);
    const double factor = program.error_factor;
    return {never_nan(factor * sums.value), never_nan(factor * sums.gradient),
            never_nan(factor * sums.hessian)};
}

JetError CompiledPolynomial::error_bound_float(const glm::dvec3& point) const {
    if (!is_finite(point)) return {infinity, infinity, infinity};
    const JetProgram& program = data_->program;
    const double r = largest_coordinate(from_center(*data_, point));
    const double scale = std::ldexp(1.0, data_->scale_exponent - data_->scale_exponent_float);
    const JetError sums = majorant_at(program, r);
    // Powers of coordinates and partial sums are within this, if nothing overflows.
    const double reach = std::pow(std::max(1.0, r), static_cast<double>(program.majorant.size() + 1)) *
                         static_cast<double>(program.majorant.size() * program.majorant.size());
    const double largest = std::max({sums.value, sums.gradient, sums.hessian}) * scale + reach;
    if (r > program.safe_radius() || !(largest * program.amplification < 0x1p120))
        return {infinity, infinity, infinity};
    // Each operation may lose 2^−149 to underflow, and each coefficient as much.
    const double lost =
        static_cast<double>(4 * program.operations + 64) * 0x1p-148 * reach * program.amplification;
    const double factor = program.error_factor * 0x1p29 * scale;
    return {factor * sums.value + lost, factor * sums.gradient + lost, factor * sums.hessian + lost};
}

JetError CompiledPolynomial::close_error_bound(const glm::dvec3& point) const {
    if (!is_finite(point)) return {infinity, infinity, infinity};
    const JetProgram& program = data_->program;
    const glm::dvec3 magnitude = glm::abs(from_center(*data_, point));
    const double r = largest_coordinate(magnitude);
    if (r > program.safe_radius()) return {infinity, infinity, infinity};
    double sums[jet_size];
    Kernel::jet(data_->program_view, program.magnitudes.data(), &magnitude.x, sums);
    const Jet jet = to_jet(sums);
    const int degree = static_cast<int>(program.majorant.size()) - 1;
    const auto bound = [&](double sum) {
        return never_nan(program.error_factor * with_underflow(sum, r, degree));
    };
    return {bound(jet.value), bound(glm::length(jet.gradient)), bound(jet.hessian.frobenius_norm())};
}

double with_underflow(double sum, double r, int degree) {
    return sum + 0x1p-900 * std::pow(std::max(1.0, r), degree);
}

} // namespace eliminant::field
