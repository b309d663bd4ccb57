/// \file
/// Which parameters reach a point.
#pragma once

#include "eliminant/ideal/ideal.hpp"
#include "eliminant/implicit/implicitize.hpp"
#include "eliminant/implicit/parametrization.hpp"

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::implicit {

/// The fibre of a parametrization over a point: all parameter values over the algebraic closure, at which
/// every coordinate is defined, with that image.
struct Preimages {
    /// Of the parameters; the cosine and the sine of an angle are two of them.
    algebra::Ring ring;
    /// Of the fibre as a variety: −1 if the point is not reached, 0 if finitely many values reach it.
    std::int64_t dimension = -1;
    /// How many values reach the point, rational or not; nullopt if infinitely many.
    std::optional<mpz_class> count;
    /// If they are finitely many, those that are rational: a number for each parameter.
    std::vector<std::vector<mpq_class>> rational;
    /// The others, as the zeros of radical ideals of `ring`, which have no zeros in common; the whole fibre
    /// if it is infinite, but for the zeros of `excluded`.
    std::vector<ideal::Ideal> components;
    /// Of an infinite fibre: denominators that are zero somewhere on the components, where the map is not
    /// defined.
    std::vector<algebra::Polynomial> excluded = {};
    /// How many values that reach the point are real; nullopt if infinitely many values reach it.
    std::optional<mpz_class> real_count = {};
    /// Whether real values reach the point. nullopt if infinitely many values do, of which no real one was
    /// met: that there are none is not decided then.
    std::optional<bool> has_real = false;
    /// Whether the point is the limit of the images for t → ∞, which is no value of t. For maps of one
    /// parameter without relations; false for others.
    bool is_limit_at_infinity = false;
};

/// The preimages of a point. Its ideal is the one of the equations nᵢ − pᵢdᵢ = 0, for coordinates nᵢ/dᵢ, and
/// of the relations, without components on which a denominator is zero: there base points are, which have no
/// image. For curves it is a gcd, otherwise a Groebner basis over ℚ; rational values are split off by the
/// rational zeros of minimal polynomials. Real values are counted as real zeros of the minimal polynomial of
/// a linear form that has different values at all of them.
///
/// `point` has a number for each coordinate.
/// \throws DomainError if there are symbolic constants, or if the point has another number of coordinates
/// \throws Stopped
Preimages preimages(const Parametrization& parametrization, std::span<const mpq_class> point, base::Run& run);

/// Whether all equations of a result vanish at a point: whether it lies on the closure of the image, which
/// may have points without preimages.
///
/// `point` has a number for each variable of the result's ring.
/// \throws DomainError if it has another number of coordinates
/// \throws Stopped
bool closure_contains(const ImplicitResult& result, std::span<const mpq_class> point, base::Run& run);

} // namespace eliminant::implicit

namespace eliminant {
using implicit::closure_contains;
using implicit::Preimages;
using implicit::preimages;
} // namespace eliminant
