// The graded algebra behind an elimination.
#pragma once

#include "eliminant/algebra/integer.hpp"
#include "implicit/projective_map.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::implicit {

/// A homogeneous homomorphism of graded rings whose kernel, dehomogenised, is the ideal of the image.
///
/// Let fᵢ be the forms of a ProjectiveMap, T the parameters, C the constants, and let F^h be F homogenised in
/// T by h and in C by e. The map φ sends Xᵢ ↦ fᵢ^h and each of C, e to itself, and
///
/// - with a denominator: X₀ ↦ f₀^h, all homogenised to one degree d in T. Every element of degree D in the
///   Xᵢ of ker φ becomes, at X₀ = e = 1, an element of the ideal of the image, and each of those comes so
///   from one, because X₀^D·G(X₁/X₀, …) maps to f₀^D·G(f₁/f₀, …).
/// - without one (f₀ = 1): h is kept too, h ↦ h, and each fᵢ^h has its own degree. The same at h = e = 1.
///   Weights of their own make the computation shorter: modulo p, L6 of Abbott, Bigatti and Robbiano takes
///   17 s with weights, and over a minute with the common degree.
///
/// The target is A = ℚ[T, h, C, e]/(c² + s² − h² for each rotation), a domain: so ker φ is prime, and if it
/// has codimension one it is principal, being prime of height one in a factorial ring. X₀ ↦ f₀^h is
/// algebraically independent of the quotients fᵢ/f₀, which have degree 0, so codimensions are those of the
/// image. This is the point of the construction: homogenising the ideal of the graph, and saturating it by
/// the denominator, instead, may leave a power of h or a component at infinity in the elimination ideal.
///
/// ker φ = ⟨Xᵢ − fᵢ^h⟩ ∩ ℚ[kept], homogeneous for the sum of both degrees, in which it is computed. See
/// Abbott, Bigatti and Robbiano, Implicitization of hypersurfaces, J. Symb. Comput. 81 (2017).
struct GradedMap {
    static constexpr std::size_t absent = ~std::size_t{0};

    algebra::Ring ring;                 ///< eliminated variables first, in an order that eliminates them
    std::size_t eliminated;             ///< how many they are
    std::vector<std::uint64_t> weights; ///< of all variables, positive
    std::vector<algebra::Polynomial> generators; ///< of the ideal of the graph, homogeneous
    std::vector<std::size_t> images;    ///< variables X₀, X₁, …; X₀ absent without denominator
    std::vector<std::size_t> constants; ///< variables of the constants, in the parametrization's sequence
    /// For each kept variable x a bound of ‖φ(x)‖₁, see vanishing_bound().
    std::vector<algebra::Integer> norms;

    /// Whether f, of `ring` or of its image over GF(p), is free of eliminated variables. By the order it is
    /// enough to look at the leading monomial.
    bool is_kept(const algebra::Polynomial& f) const;
};

/// The map of a parametrization; `relations` generate the ideal of its domain, homogeneous in T and h (by
/// total degree), as homogenized_relations() makes them; they are in the parametrization's ring with one
/// variable, h, added last. Without them the domain is all of parameter space, up to rotations.
GradedMap graded_map(const Parametrization& parametrization, const ProjectiveMap& map,
                     std::span<const algebra::Polynomial> relations);

/// A bound B of the coefficients of F(φ(X)) for F over ℤ in the kept variables, in this sense: if F(φ(X)) is
/// zero modulo a number M > 2B without prime factor 2, it is zero.
///
/// Without rotations these are coefficients of a polynomial over ℤ, and B = Σ |coefficient| ∏ ‖φ(xᵢ)‖₁^eᵢ. A
/// rotation becomes c = (z + 1/z)/2, s = (z − 1/z)/2i, an isomorphism onto Laurent polynomials over ℚ(i) for
/// h = 1, and setting h = 1 loses nothing of a homogeneous element: again ‖c‖₁ = ‖s‖₁ = 1, but coefficients
/// are Gaussian integers only after multiplication by a power of 2, which each norm contains.
algebra::Integer vanishing_bound(const GradedMap& map, const algebra::Polynomial& F);

} // namespace eliminant::implicit
