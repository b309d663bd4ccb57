// What a parametrization takes to a line, by resultants.
#pragma once

#include "eliminant/base/run.hpp"
#include "implicit/quotient_algebra.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::implicit {

/// A polynomial in s and t modulo a prime: rows[i] is the coefficient of sⁱ, a polynomial in t. Of a curve's
/// only parameter, t, there is one row.
using FormRows = std::vector<Residues>;

/// The parameters that a map takes to a line, as the points of an algebra GF(p)[t]/(R), and the function on
/// it that is the last coordinate, the height of the image point.
struct LineFibre {
    QuotientAlgebra algebra;
    Residues height;
};

/// A map (f₁/f₀, …, fₙ/f₀) modulo a prime, of n − 1 parameters, n = 2 or 3, and the lines
///
///     { (b₁ + α₁τ, …, bₙ₋₁ + αₙ₋₁τ, τ) }        of one direction (α, 1), over the base points b.
///
/// The parameters that it takes to such a line are the solutions of fᵢ − αᵢfₙ − bᵢf₀ = 0, 1 ≤ i < n, at which
/// not all forms vanish. Where n = 3 the resultant of both equations with respect to s is a polynomial in t;
/// those of its roots that do not depend on b belong to base points (also to those at infinity) and are
/// divided out. At the others the first subresultant tells s: it is a rational function of t, and so is the
/// height. That needs two points of a fibre to have different t, which fails only for maps that are not
/// injective.
class LineFibres {
  public:
    virtual ~LineFibres() = default;
    /// The fibre of the line over a base point; nullopt if the line is in special position.
    virtual std::optional<LineFibre> over(std::span<const Residue> base) const = 0;
};

/// \param forms f₀, f₁, f₂ as polynomials in t, without common factor
std::unique_ptr<LineFibres> curve_fibres(const algebra::PrimeField& field, std::span<const FormRows> forms,
                                         std::span<const Residue> direction, const base::Run& run);

/// How many values of t the resultant is computed at: one more than the degrees of the polynomials in t.
struct SurfaceNodes {
    std::size_t count;
};

/// \param forms f₀, …, f₃, without common factor, all of one number of rows, at least 2
/// \param seed chooses the values of t and the lines by which fixed roots are found
/// \returns null if the choice was unlucky, or if the map has no such fibres at all
std::unique_ptr<LineFibres> surface_fibres(const algebra::PrimeField& field, std::span<const FormRows> forms,
                                           std::span<const Residue> direction, SurfaceNodes nodes,
                                           std::uint64_t seed, base::Run& run);

/// Enough nodes for any forms of these degrees; and as many as these forms really need, found by looking at a
/// line: base points at infinity often save half of them.
SurfaceNodes sufficient_nodes(std::span<const FormRows> forms);
std::optional<SurfaceNodes> needed_nodes(const algebra::PrimeField& field, std::span<const FormRows> forms,
                                         std::uint64_t seed, base::Run& run);

} // namespace eliminant::implicit
