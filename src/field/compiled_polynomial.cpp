#include "eliminant/field/compiled_polynomial.hpp"

#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/base/error.hpp"

#include "field/arithmetic.hpp"
#include "field/compiled_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

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

/// e with 2^(e−1) ≤ |q| < 2^(e+1).
long binary_exponent(const mpq_class& q) {
    return static_cast<long>(mpz_sizeinbase(q.get_num_mpz_t(), 2)) -
           static_cast<long>(mpz_sizeinbase(q.get_den_mpz_t(), 2));
}

mpq_class times_power_of_two(const mpq_class& q, long exponent) {
    mpq_class result;
    if (exponent >= 0)
        mpq_mul_2exp(result.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
    else
        mpq_div_2exp(result.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
    return result;
}

/// The exponent that makes the largest coefficient about 1, or 0 if it is within 2^±limit anyway.
int scale_exponent_for(long largest, long limit) {
    if (std::abs(largest) <= limit) return 0;
    if (std::abs(largest) > std::numeric_limits<int>::max() / 2)
        throw OverflowError("compiling a polynomial: a coefficient exceeds 2^(2^30)");
    return static_cast<int>(largest);
}

DoubleDouble to_double_double(const mpq_class& q) {
    const double high = q.get_d(); // truncated
    const double low = mpq_class(q - high).get_d();
    return fast_two_sum(high, low);
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
    data.floats.assign(size, 0);
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
        data.floats[slot] =
            static_cast<float>(times_power_of_two(exact[t], -data.scale_exponent_float).get_d());
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

std::shared_ptr<const CompiledData> compile(Polynomial f, const base::Run& run) {
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

double largest_coordinate(const glm::dvec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

bool is_finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

using Horner = NestedHorner<PointArithmetic<double>>;

Jet to_jet(const double* jet) {
    return {jet[at_value],
            {jet[at_x], jet[at_y], jet[at_z]},
            {jet[at_xx], jet[at_xy], jet[at_xz], jet[at_yy], jet[at_yz], jet[at_zz]}};
}

double never_nan(double bound) { return std::isnan(bound) ? infinity : bound; }

} // namespace

double SymmetricMatrix::frobenius_norm() const {
    return std::sqrt(xx * xx + yy * yy + zz * zz + 2 * (xy * xy + xz * xz + yz * yz));
}

CompiledPolynomial::CompiledPolynomial(const Polynomial& f)
    : data_(compile(in_coordinates(f), base::Run())) {}

CompiledPolynomial::CompiledPolynomial(const Polynomial& f, base::Run& run)
    : data_(compile(in_coordinates(f), run)) {}

CompiledPolynomial::CompiledPolynomial(const Polynomial& f, const Region& region, base::Run& run)
    : data_(compile(in_region(f, region, run), run)) {}

int CompiledPolynomial::degree() const { return data_->degree; }
const Polynomial& CompiledPolynomial::polynomial() const { return data_->exact; }
int CompiledPolynomial::scale_exponent() const { return data_->scale_exponent; }
int CompiledPolynomial::scale_exponent_float() const { return data_->scale_exponent_float; }

double CompiledPolynomial::value(const glm::dvec3& point) const {
    return Horner::value(data_->view, data_->coefficients.data(), &point.x);
}

Jet CompiledPolynomial::jet(const glm::dvec3& point) const {
    double jet[jet_size];
    Horner::jet(data_->view, data_->coefficients.data(), &point.x, jet);
    return to_jet(jet);
}

JetError CompiledPolynomial::error_bound(const glm::dvec3& point) const {
    if (!is_finite(point)) return {infinity, infinity, infinity};
    const double r = largest_coordinate(point);
    double sum = 0;
    double first = 0;
    double half_second = 0;
    for (std::size_t k = data_->majorant.size(); k-- > 0;) {
        half_second = half_second * r + first;
        first = first * r + sum;
        sum = sum * r + data_->majorant[k];
    }
    const double factor = data_->error_factor;
    return {never_nan(factor * sum), never_nan(factor * first), never_nan(factor * 2 * half_second)};
}

JetError CompiledPolynomial::close_error_bound(const glm::dvec3& point) const {
    if (!is_finite(point)) return {infinity, infinity, infinity};
    const glm::dvec3 magnitude = glm::abs(point);
    double sums[jet_size];
    Horner::jet(data_->view, data_->magnitudes.data(), &magnitude.x, sums);
    const Jet jet = to_jet(sums);
    const auto bound = [&](double sum) {
        return never_nan(data_->error_factor *
                         with_underflow(sum, largest_coordinate(magnitude), data_->degree));
    };
    return {bound(jet.value), bound(glm::length(jet.gradient)), bound(jet.hessian.frobenius_norm())};
}

double with_underflow(double sum, double r, int degree) {
    return sum + 0x1p-900 * std::pow(std::max(1.0, r), degree);
}

} // namespace eliminant::field
