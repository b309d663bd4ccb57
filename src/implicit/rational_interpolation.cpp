#include "implicit/rational_interpolation.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::implicit {

namespace dense = algebra::dense;
using algebra::PrimeField;
using dense::Element;
using dense::Vector;

namespace {

/// a − q·b.
Vector minus_product(const PrimeField& field, Vector a, const Vector& q, const Vector& b) {
    const Vector product = dense::multiply(field, q, b);
    a.resize(std::max(a.size(), product.size()), 0);
    dense::add_multiple<PrimeField>(field, a, product, field.negate(1));
    dense::trim(a);
    return a;
}

std::size_t coefficients(const Vector& numerator, const Vector& denominator) {
    return numerator.size() + denominator.size() - 1; // up to a common factor
}

} // namespace

std::optional<RationalInterpolant> rational_interpolant(const PrimeField& field,
                                                        std::span<const Element> points,
                                                        std::span<const Element> values,
                                                        std::size_t redundancy, base::Run& run) {
    Vector r0 = {1};
    for (const Element z : points) dense::multiply_by_root(field, r0, z);
    Vector r1 = dense::interpolate<PrimeField>(field, points, values);
    Vector t0;
    Vector t1 = {1};
    RationalInterpolant best{r1, t1};
    while (!r1.empty()) {
        run.poll();
        const Vector quotient = dense::divide(field, r0, r1);
        std::swap(r0, r1);
        t0 = minus_product(field, std::move(t0), quotient, t1);
        std::swap(t0, t1);
        if (!r1.empty() && coefficients(r1, t1) < coefficients(best.numerator, best.denominator))
            best = {r1, t1};
    }
    if (coefficients(best.numerator, best.denominator) + redundancy > points.size()) return std::nullopt;
    for (const Element z : points)
        if (dense::evaluate<PrimeField>(field, best.denominator, z) == 0) return std::nullopt;
    const Element inverse = field.inverse(best.denominator.back());
    for (Element& c : best.numerator) c = field.multiply(c, inverse);
    for (Element& c : best.denominator) c = field.multiply(c, inverse);
    return best;
}

} // namespace eliminant::implicit
