#include "implicit/roots_modulo.hpp"

#include "algebra/residue_classes.hpp"

#include <optional>

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

/// A square root of a; nullopt if it has none. Tonelli and Shanks, p odd (Cohen, A Course in Computational
/// Algebraic Number Theory, Algorithm 1.5.1): a tenth of the time of a power of a linear polynomial.
std::optional<Element> square_root(const PrimeField& field, Element a, algebra::Random& random) {
    if (a == 0) return 0;
    const std::uint64_t units = field.characteristic() - std::uint64_t{1};
    auto exponent = static_cast<unsigned>(__builtin_ctzll(units));
    const std::uint64_t odd = units >> exponent;
    const Element power = field.power(a, (odd - 1) / 2);
    Element root = field.multiply(a, power);
    Element defect = field.multiply(root, power); // root² = a·defect, defect^(2^exponent) = 1
    Element generator = 0;                        // of the group of 2^exponent-th roots of unity
    while (defect != 1) {
        unsigned order = 0;
        for (Element square = defect; square != 1 && order < exponent; ++order)
            square = field.multiply(square, square);
        if (order == exponent) return std::nullopt; // only before a generator was found
        while (generator == 0) {
            const Element candidate = 1 + random.below(field.characteristic() - 1);
            if (field.power(candidate, units / 2) != 1) generator = field.power(candidate, odd);
        }
        for (; order + 1 < exponent; --exponent) generator = field.multiply(generator, generator);
        root = field.multiply(root, generator);
        generator = field.multiply(generator, generator);
        --exponent;
        defect = field.multiply(defect, generator);
    }
    return root;
}

/// f has degree 2 and p is odd. The roots are distinct.
std::vector<Element> roots_of_quadratic(const PrimeField& field, const Vector& f, algebra::Random& random) {
    // a·x² + b·x + c, with h = b/2: (a·x + h)² = h² − a·c
    const Element half = field.multiply(f[1], field.characteristic() / 2 + 1);
    const auto root =
        square_root(field, field.subtract(field.multiply(half, half), field.multiply(f[2], f[0])), random);
    if (!root) return {};
    const Element inverse = field.inverse(f[2]);
    std::vector<Element> found = {field.multiply(field.subtract(*root, half), inverse)};
    if (*root != 0) found.push_back(field.negate(field.multiply(field.add(*root, half), inverse)));
    return found;
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
    if (f.size() == 3) return roots_of_quadratic(field, f, random);
    dense::make_monic(field, f);
    Vector frobenius = dense::ResidueClasses(field, f).power_of_linear(0, field.characteristic());
    subtract_constant(field, frobenius, 1);
    Vector linear = dense::gcd(field, std::move(f), std::move(frobenius), run);
    split(field, linear, random, run, found);
    return found;
}

} // namespace eliminant::implicit
