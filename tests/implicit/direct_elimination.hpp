// The slow twin: the definition of the ideal of an image, by the general operations on ideals.
#pragma once

#include "eliminant/algebra/coefficients.hpp"
#include "eliminant/algebra/gcd.hpp"
#include "eliminant/ideal/operations.hpp"
#include "eliminant/ideal/radical.hpp"
#include "implicit/support.hpp"

#include <string>
#include <vector>

namespace eliminant::implicit {

/// (⟨Q_i·x_i − P_i⟩ + relations + ⟨1 − z·∏ Q_i⟩) ∩ ℚ[coordinates, constants], in the ring of a result.
inline Ideal direct_elimination(const Parametrization& p, const Ring& result_ring, Run& run) {
    std::vector<std::string> names = {"z_"};
    std::vector<std::size_t> eliminated = {0};
    for (const std::size_t i : p.parameters()) {
        eliminated.push_back(names.size());
        names.push_back(p.ring().names()[i]);
    }
    names.insert(names.end(), result_ring.names().begin(), result_ring.names().end());
    const Ring ring(CoefficientField::rationals(), names);
    std::vector<Polynomial> generators;
    Polynomial denominators = Polynomial::constant(ring, 1);
    for (const auto& [name, value] : p.coordinates()) {
        const Polynomial Q = value.denominator.in_ring(ring);
        denominators *= Q;
        generators.push_back(Q * Polynomial::variable(ring, name) - value.numerator.in_ring(ring));
    }
    generators.push_back(Polynomial::constant(ring, 1) -
                         Polynomial::variable(ring, std::size_t{0}) * squarefree_part(denominators, run));
    for (const Polynomial& f : p.rotation_relations()) generators.push_back(f.in_ring(ring));
    for (const Polynomial& f : p.relations()) generators.push_back(f.in_ring(ring));
    const Ideal image = eliminate(Ideal(ring, generators), eliminated, run);
    std::vector<Polynomial> moved;
    for (const Polynomial& f : image.groebner_basis(run)) moved.push_back(f.in_ring(result_ring));
    return {result_ring, moved};
}

/// Whether the equations are the reduced basis of the radical ideal of the image, prime without relations.
/// With constants: whether what they generate over ℚ(constants) meets ℚ[coordinates, constants] in that
/// ideal.
inline ::testing::AssertionResult agrees_with_direct_elimination(const Parametrization& p,
                                                                 const ImplicitResult& result) {
    Run run;
    Ideal direct = direct_elimination(p, result.ring, run);
    if (!p.relations().empty()) direct = radical(direct, run);
    const Ideal ours(result.ring, result.equations);
    const auto failure = [&] {
        return ::testing::AssertionFailure() << "got\n"
                                             << joined(result.equations) << "\nbut direct elimination gives\n"
                                             << joined(direct.groebner_basis(run));
    };
    if (p.constants().empty()) {
        if (joined(direct.groebner_basis(run)) != joined(result.equations)) return failure();
        return ::testing::AssertionSuccess();
    }
    std::vector<std::size_t> coordinates(p.coordinates().size());
    for (std::size_t i = 0; i < coordinates.size(); ++i) coordinates[i] = i;
    Ideal contraction = ours;
    for (const Polynomial& f : result.equations) {
        if (content(f, coordinates, run) != Polynomial::constant(result.ring, 1)) return failure();
        for (const auto& term : coefficients(f, coordinates)) {
            bool head = true;
            for (const std::size_t i : coordinates) head = head && term.exponents[i] == f.exponent(0, i);
            if (head) contraction = saturate(contraction, term.coefficient, run);
        }
    }
    return contraction.equals(direct, run) ? ::testing::AssertionSuccess() : failure();
}

} // namespace eliminant::implicit
