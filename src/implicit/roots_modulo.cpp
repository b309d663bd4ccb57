#include "implicit/roots_modulo.hpp"

#include "algebra/residue_classes.hpp"

namespace eliminant::implicit {

namespace dense = algebra::dense;
using algebra::PrimeField;
using dense::Element;
using dense::Vector;

namespace {

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
    dense::ResidueClasses classes(field, f);
    for (;;) {
        run.poll();
        Vector half =
            classes.power_of_linear(random.below(field.characteristic()), (field.characteristic() - 1) / 2);
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
    dense::make_monic(field, f);
    Vector frobenius = dense::ResidueClasses(field, f).power_of_linear(0, field.characteristic());
    subtract_constant(field, frobenius, 1);
    Vector linear = dense::gcd(field, std::move(f), std::move(frobenius), run);
    split(field, linear, random, run, found);
    return found;
}

} // namespace eliminant::implicit
