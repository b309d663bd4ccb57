#include "expansion_size.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace eliminant::algebra {

namespace {

/// What bounds the size of products, as doubles: they only have to be right up to a factor.
struct Shape {
    double terms;
    double total_degree;
    std::vector<double> degrees;
    bool is_homogeneous;
    double coefficient_bits;
};

Shape shape_of(const Polynomial& f) {
    Shape shape{static_cast<double>(f.size()), static_cast<double>(f.total_degree()),
                std::vector<double>(f.ring().variable_count(), 0.0), f.is_homogeneous(), 32.0};
    for (std::size_t i = 0; i < f.size(); ++i) {
        for (std::size_t v = 0; v < shape.degrees.size(); ++v)
            shape.degrees[v] = std::max(shape.degrees[v], static_cast<double>(f.exponent(i, v)));
    }
    if (f.ring().field().is_rationals()) {
        std::size_t bits = f.denominator().bit_length();
        for (const Integer& c : f.integer_terms().coefficients) bits = std::max(bits, c.bit_length());
        shape.coefficient_bits = static_cast<double>(bits);
    }
    return shape;
}

/// By its product, which only grows, so that it can end early; differences of lgamma lose every digit for
/// large n.
double binomial(double n, double k) {
    constexpr double enough = 1e30;
    k = std::min(k, n - k);
    double result = 1;
    for (double i = 1; i <= k && result < enough; ++i) result *= (n - k + i) / i;
    return result;
}

/// Number of monomials within the degrees.
double monomials_within(const Shape& shape) {
    double box = 1;
    double variables = 0;
    for (const double degree : shape.degrees) {
        box *= degree + 1;
        if (degree > 0) variables += 1;
    }
    if (variables == 0) return 1;
    const double free = shape.is_homogeneous ? variables - 1 : variables;
    return std::min(box, binomial(shape.total_degree + free, free));
}

double bytes(const Ring& ring, const Shape& shape) {
    const double words = static_cast<double>(ring.layout(16).words());
    // An inline coefficient has 8 bytes; a long one also a GMP integer and two allocations.
    const double digits = shape.coefficient_bits > 62 ? 48 + shape.coefficient_bits / 8 : 0;
    return std::min(shape.terms, monomials_within(shape)) * (8 * words + 8 + digits);
}

} // namespace

double expansion_bytes(const Polynomial& a, const Polynomial& b) {
    const Shape left = shape_of(a);
    Shape shape = shape_of(b);
    const double sums = std::min(left.terms, shape.terms);
    shape.terms *= left.terms;
    shape.total_degree += left.total_degree;
    for (std::size_t v = 0; v < shape.degrees.size(); ++v) shape.degrees[v] += left.degrees[v];
    shape.is_homogeneous = shape.is_homogeneous && left.is_homogeneous;
    if (a.ring().field().is_rationals())
        shape.coefficient_bits += left.coefficient_bits + std::log2(sums + 1);
    return bytes(a.ring(), shape);
}

double expansion_bytes(const Polynomial& f, std::uint64_t exponent) {
    Shape shape = shape_of(f);
    const auto k = static_cast<double>(exponent);
    if (f.ring().field().is_rationals())
        shape.coefficient_bits = k * (shape.coefficient_bits + std::log2(shape.terms + 1));
    shape.terms = shape.terms <= 1 ? shape.terms : binomial(k + shape.terms - 1, shape.terms - 1);
    shape.total_degree *= k;
    for (double& degree : shape.degrees) degree *= k;
    return bytes(f.ring(), shape);
}

} // namespace eliminant::algebra
