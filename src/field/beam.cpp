#include "beam.hpp"

#include "beam_rows.hpp"
#include "dyadic.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace eliminant::field {
namespace {

/// p(x) ← p(center + radius·x) for the n + 1 coefficients at p, p + stride(0), …; `index(i)` is where the
/// coefficient of x^i stands. n²/2 + n multiplications.
template <class Index>
void change_variable(std::vector<DoubleDouble>& p, std::size_t n, Span span, const Index& index) {
    if (span.center != 0.0)
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = n; j-- > i;) p[index(j)] = p[index(j)] + p[index(j + 1)] * span.center;
    DoubleDouble power{span.radius, 0.0};
    for (std::size_t i = 1; i <= n; ++i) {
        p[index(i)] = p[index(i)] * power;
        power = power * span.radius;
    }
}

/// Of a sum of at most 2n + 2 rounded terms and n products, n being the degree.
double relative_error(std::size_t degree) { return static_cast<double>(4 * degree + 8) * DoubleDouble::unit; }

} // namespace

bool Beam::has_no_zero() const {
    // The sum of all absolute values is rounded up, and twice the constant is exact.
    return 2.0 * std::abs(coefficients[0]) > (magnitude + error) * (1.0 + 0x1p-30);
}

void Beam::collapse_rows(const BeamLayout& layout, double v, double* row, double* v_derivative) const {
    const std::size_t n = layout.degree();
    for (std::size_t k = 0; k <= n; ++k) {
        double* const p = row + k * (n + 1);
        double* const dp = v_derivative + k * (n + 1);
        std::fill_n(p, n - k + 1, 0.0);
        std::fill_n(dp, n - k + 1, 0.0);
        for (std::size_t b = n - k + 1; b-- > 0;) {
            const double* const c = coefficients.data() + layout.start(k, b);
            // Powers of u that a row of a higher b lacks are still 0.
            for (std::size_t a = 0; a <= n - k - b; ++a) {
                dp[a] = dp[a] * v + p[a];
                p[a] = p[a] * v + c[a];
            }
        }
    }
}

WideBeam::WideBeam(const ExactBeam& exact) : layout_(exact.layout()) {
    std::size_t bits = 0;
    for (const mpz_class& c : exact.coefficients()) bits = std::max(bits, mpz_sizeinbase(c.get_mpz_t(), 2));
    coefficients_.reserve(layout_.size());
    for (const mpz_class& c : exact.coefficients())
        coefficients_.push_back(to_double_double(c, static_cast<long>(bits)));
    measure();
    // The second term is for coefficients that underflow.
    error_ = magnitude_ * DoubleDouble::unit + static_cast<double>(layout_.size()) * 0x1p-990;
}

void WideBeam::measure() {
    magnitude_ = 0.0;
    for (const DoubleDouble& c : coefficients_) magnitude_ += std::abs(c.high);
    magnitude_ *= 1.0 + 0x1p-30; // the rounding of the sum, and the low parts
}

WideBeam WideBeam::part(Span u, Span v) const {
    const std::size_t n = layout_.degree();
    WideBeam result(*this);
    for (std::size_t k = 0; k <= n; ++k) {
        for (std::size_t b = 0; b <= layout_.rows(k, n); ++b)
            change_variable(result.coefficients_, layout_.columns(k, b, n), u,
                            [start = layout_.start(k, b)](std::size_t a) { return start + a; });
        for (std::size_t a = 0; a <= layout_.columns(k, 0, n); ++a)
            change_variable(result.coefficients_, std::min(layout_.rows(k, n), n - k - a), v,
                            [&](std::size_t b) { return layout_.start(k, b) + a; });
    }
    result.error_ = error_ + 2.0 * relative_error(n) * magnitude_;
    result.measure();
    return result;
}

Beam WideBeam::slab(Span w) const {
    const std::size_t n = layout_.degree();
    std::vector<DoubleDouble> p = coefficients_;
    for (std::size_t b = 0; b <= layout_.rows(0, n); ++b)
        for (std::size_t a = 0; a <= layout_.columns(0, b, n); ++a)
            change_variable(p, n - a - b, w, [&](std::size_t k) { return layout_.start(k, b) + a; });
    Beam beam;
    beam.coefficients.reserve(p.size());
    for (const DoubleDouble& c : p) {
        beam.coefficients.push_back(c.high);
        beam.magnitude += std::abs(c.high);
    }
    beam.magnitude *= 1.0 + 0x1p-30;
    beam.error = error_ + relative_error(n) * magnitude_ + 0x1p-53 * beam.magnitude;
    return beam;
}

std::vector<DoubleDouble> WideBeam::on_ray(double u, double v, double& error) const {
    const std::size_t n = layout_.degree();
    std::vector<DoubleDouble> result(n + 1);
    for (std::size_t k = 0; k <= n; ++k)
        for (std::size_t b = layout_.rows(k, n) + 1; b-- > 0;) {
            const DoubleDouble* const row = &coefficients_[layout_.start(k, b)];
            DoubleDouble in_u{};
            for (std::size_t a = layout_.columns(k, b, n) + 1; a-- > 0;) in_u = in_u * u + row[a];
            result[k] = result[k] * v + in_u;
        }
    error = error_ + 2.0 * relative_error(n) * magnitude_;
    return result;
}

} // namespace eliminant::field
