#include "implicit/roots_modulo.hpp"

namespace eliminant::implicit {

namespace dense = algebra::dense;
using algebra::PrimeField;
using dense::Element;
using dense::Vector;

namespace {

/// base^exponent modulo f.
Vector power_modulo(const PrimeField& field, const Vector& base, std::uint64_t exponent, const Vector& f) {
    Vector result = {1};
    for (unsigned bit = 64U - static_cast<unsigned>(__builtin_clzll(exponent)); bit-- > 0;) {
        result = dense::multiply(field, result, result);
        dense::divide(field, result, f);
        if ((exponent >> bit & 1) == 0) continue;
        result = dense::multiply(field, result, base);
        dense::divide(field, result, f);
    }
    return result;
}

void subtract_constant(const PrimeField& field, Vector& f, std::size_t power) {
    if (f.size() <= power) f.resize(power + 1, 0);
    f[power] = field.subtract(f[power], 1);
    dense::trim(f);
}

Element root_of_linear(const PrimeField& field, const Vector& f) {
    return field.negate(field.multiply(f[0], field.inverse(f[1])));
}

/// Of a product of distinct linear factors.
void split(const PrimeField& field, const Vector& f, algebra::Random& random, base::Run& run,
           std::vector<Element>& found) {
    if (f.size() == 2) found.push_back(root_of_linear(field, f));
    if (f.size() <= 2) return;
    for (;;) {
        run.poll();
        const Vector shifted = {random.below(field.characteristic()), 1};
        Vector half = power_modulo(field, shifted, (field.characteristic() - 1) / 2, f);
        subtract_constant(field, half, 0);
        const Vector part = dense::gcd(field, f, half, run);
        if (part.size() < 2 || part.size() == f.size()) continue;
        Vector rest = f;
        const Vector quotient = dense::divide(field, rest, part);
        split(field, part, random, run, found);
        split(field, quotient, random, run, found);
        return;
    }
}

} // namespace

std::vector<Element> roots(const PrimeField& field, Vector f, algebra::Random& random, base::Run& run) {
    std::vector<Element> found;
    if (f.size() == 2) return {root_of_linear(field, f)};
    if (f.size() < 2) return found;
    Vector frobenius = power_modulo(field, {0, 1}, field.characteristic(), f);
    subtract_constant(field, frobenius, 1);
    Vector linear = dense::gcd(field, std::move(f), std::move(frobenius), run);
    split(field, linear, random, run, found);
    return found;
}

} // namespace eliminant::implicit
