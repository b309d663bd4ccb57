/// \file
/// Values of polynomials: at points, and with polynomials in the place of variables.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <cstddef>
#include <span>

namespace eliminant::algebra {

/// f at a point, one coordinate a variable. Over GF(p) coordinates are mapped to the field and the value is
/// the residue in [0, p).
///
/// Powers of each coordinate are computed once. Throws DomainError if the number of coordinates is wrong, or
/// if p divides a denominator.
mpq_class evaluate(const Polynomial& f, std::span<const mpq_class> point, base::Run& run);
mpq_class evaluate(const Polynomial& f, std::span<const mpq_class> point);

/// The image of f in GF(p) at a point of residues in [0, p); f is over ℚ or over the same GF(p).
///
/// Throws DomainError if p divides the denominator of f, if the number of coordinates is wrong, or if f is
/// over another prime field.
PrimeField::Element evaluate(const Polynomial& f, const PrimeField& field,
                             std::span<const PrimeField::Element> point, base::Run& run);

/// f with values in the place of some variables; the result is in the same ring. variables[i] ↦ values[i].
///
/// Throws DomainError if the two lengths differ, a variable does not exist, or p divides a denominator.
Polynomial evaluate(const Polynomial& f, std::span<const std::size_t> variables,
                    std::span<const mpq_class> values, base::Run& run);
/// The same for one variable.
Polynomial evaluate(const Polynomial& f, std::size_t variable, const mpq_class& value, base::Run& run);

/// f with g in the place of one variable; f and g are of one ring, and g may contain the variable.
Polynomial substitute(const Polynomial& f, std::size_t variable, const Polynomial& g, base::Run& run);

/// f(images[0], images[1], …): the image of f under the homomorphism that sends variable i to images[i]. All
/// images are of one ring, `target`, whose field is that of f, or a prime field where f is over ℚ.
///
/// Images of one term are mapped term by term; the others by Horner's scheme in several variables, the
/// largest image outermost, where it is multiplied with least often. Throws DomainError if the number of
/// images is not that of the variables or coefficients have no image in `target`, RingMismatchError for an
/// image of another ring.
Polynomial compose(const Polynomial& f, const Ring& target, std::span<const Polynomial> images,
                   base::Run& run);

} // namespace eliminant::algebra

namespace eliminant {
using algebra::compose;
using algebra::evaluate;
using algebra::substitute;
} // namespace eliminant
