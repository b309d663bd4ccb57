// The parameter of a plane curve as a function of the point, by subresultants of moving lines.
#pragma once

#include "algebra/univariate_mod_p.hpp"
#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/run.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace eliminant::implicit {

/// Coefficients u₀, u₁, u₂, polynomials in t, of a line u₀(t) + u₁(t)·x + u₂(t)·y = 0.
using MovingLine = std::array<algebra::dense::Vector, 3>;

/// A basis of the lines that move through the point of a curve (f₁/f₀, f₂/f₀): of the module of syzygies u₀f₀
/// + u₁f₁ + u₂f₂ = 0. Its degrees in t add up to that of the curve. The three syzygies (fⱼ, −fᵢ) generate
/// the module, as the fᵢ have no common factor; the highest one of dependent leading vectors is reduced by
/// the others, until none is left. O(n²) for degree n. Sederberg and Chen, SIGGRAPH 1995; Zheng and
/// Sederberg, J. Symb. Comput. 31 (2001).
///
/// \param forms f₀, f₁, f₂, coprime
std::optional<std::array<MovingLine, 2>> moving_line_basis(const algebra::PrimeField& field, MovingLine forms,
                                                           base::Run& run);

/// A polynomial D(x, y)·t − N(x, y), monic, that vanishes on the graph of a curve: the first subresultant, in
/// t, of both lines of a basis, of degree n − 2 in x and y for n > 2, which the basis does not change but for
/// a factor. It is interpolated from values at n(n − 1)/2 points, each by Euclid's algorithm: O(n⁴) in all,
/// where the n(n − 1) unknown coefficients are a system for O(n⁶).
///
/// \param ring modulo the prime of `field`, of three variables
/// \param t which of them is t; the others are x and y
/// \returns nullopt if the prime or a random choice was unlucky
std::optional<algebra::Polynomial> curve_inversion_modulo(const algebra::PrimeField& field,
                                                          const MovingLine& forms, const algebra::Ring& ring,
                                                          std::size_t t, std::uint64_t seed, base::Run& run);

} // namespace eliminant::implicit
