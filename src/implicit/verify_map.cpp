#include "implicit/verify_map.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/coefficients.hpp"
#include "eliminant/algebra/gcd.hpp"

#include <algorithm>
#include <array>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::RationalFunction;

namespace {

/// f = numerator/(1 + w²)^power after the substitution.
struct OnCircle {
    Polynomial numerator;
    std::uint64_t power;
};

OnCircle substituted(const Polynomial& f, const CosineSine& rotation, base::Run& run) {
    const std::array<std::size_t, 2> variables = {rotation.first, rotation.second};
    const std::vector<algebra::CoefficientTerm> terms = coefficients(f, variables);
    std::uint64_t power = 0;
    for (const auto& term : terms) power = std::max(power, term.exponents[0] + term.exponents[1]);

    const Polynomial w = Polynomial::variable(f.ring(), rotation.first);
    const Polynomial one = Polynomial::constant(f.ring(), 1);
    const Polynomial norm = one + w * w;
    const Polynomial cosine = one - w * w;
    const Polynomial sine = w.scaled(2);
    Polynomial sum(f.ring());
    for (const auto& term : terms) {
        const std::uint64_t rest = power - term.exponents[0] - term.exponents[1];
        sum += multiply(
            term.coefficient,
            multiply(multiply(pow(cosine, term.exponents[0], run), pow(sine, term.exponents[1], run), run),
                     pow(norm, rest, run), run),
            run);
    }
    return {std::move(sum), power};
}

} // namespace

RationalFunction by_half_angles(const RationalFunction& f, std::span<const CosineSine> rotations,
                                base::Run& run) {
    RationalFunction result = f;
    for (const CosineSine& rotation : rotations) {
        const OnCircle top = substituted(result.numerator, rotation, run);
        const OnCircle bottom = substituted(result.denominator, rotation, run);
        const Polynomial w = Polynomial::variable(f.numerator.ring(), rotation.first);
        const Polynomial norm = Polynomial::constant(f.numerator.ring(), 1) + w * w;
        const std::uint64_t common = std::min(top.power, bottom.power);
        result = RationalFunction(multiply(top.numerator, pow(norm, bottom.power - common, run), run),
                                  multiply(bottom.numerator, pow(norm, top.power - common, run), run));
    }
    return in_lowest_terms(result, run);
}

RationalMap rational_map(const algebra::Ring& ring, std::span<const std::size_t> constants,
                         std::span<const CosineSine> rotations, std::span<const RationalFunction> functions,
                         base::Run& run) {
    RationalMap map{ring, Polynomial::constant(ring, 1), {}, {}, {constants.begin(), constants.end()}};
    const auto is_parameter = [&](std::size_t i) {
        return std::ranges::find(constants, i) == constants.end() &&
               std::ranges::find(rotations, i, &CosineSine::second) == rotations.end();
    };
    for (std::size_t i = 0; i < ring.variable_count(); ++i)
        if (is_parameter(i)) map.parameters.push_back(i);

    std::vector<RationalFunction> free;
    for (const RationalFunction& f : functions) {
        free.push_back(by_half_angles(f, rotations, run));
        if (!free.back().is_polynomial())
            map.denominator = lcm(map.denominator, free.back().denominator, run);
    }
    map.denominator = map.denominator.primitive_part();
    for (const RationalFunction& f : free) {
        if (f.is_polynomial())
            map.components.push_back({f.numerator, false});
        else
            map.components.push_back(
                {multiply(f.numerator, divide_exactly(map.denominator, f.denominator, run), run), true});
    }
    for (const std::size_t constant : constants)
        map.components.push_back({Polynomial::variable(ring, constant), false});
    return map;
}

} // namespace eliminant::implicit
