// Proofs for parametrizations whose parameters satisfy relations.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/algebra/rational_function.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/implicit/certificate.hpp"
#include "implicit/verify_map.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::implicit {

/// Coordinates numeratorᵢ/denominator on a domain: the points, over the algebraic closure of the field of
/// constants, at which the relations are zero and the denominator is not. All polynomials are over ℤ.
struct DomainMap {
    algebra::Ring ring; ///< of the parameters, then the constants
    std::size_t parameter_count;
    /// With c² + s² = 1 for each angle. A single one is squarefree, without factors in the denominator or in
    /// the constants alone: it generates the ideal of the domain.
    std::vector<algebra::Polynomial> relations;
    algebra::Polynomial denominator;
    std::vector<algebra::Polynomial> numerators;
};

/// \param relations not zero, one at least, counting angles; like the functions in `ring`
DomainMap domain_map(const algebra::Ring& ring, std::size_t parameter_count,
                     std::span<const CosineSine> rotations, std::span<const algebra::Polynomial> relations,
                     std::span<const algebra::RationalFunction> functions, base::Run& run);

/// The relations in an order that compares by these weights first; nullopt unless their leading monomials are
/// pairwise coprime. If so they are a Groebner basis (Buchberger 1979), and as many as the codimension of the
/// set of their zeros.
std::optional<std::vector<algebra::Polynomial>> as_basis(const DomainMap& map,
                                                         const std::vector<std::uint64_t>& weights);

/// Whether f(x(T)), cleared of denominators, is in the ideal of the relations.
/// \param f between coordinates and constants
/// \param basis as_basis(…)
bool vanishes(const DomainMap& map, const algebra::Polynomial& f,
              const std::vector<algebra::Polynomial>& basis, base::Run& run);

/// A domain modulo a prime, looked at in points.
class DomainModulo {
  public:
    using Element = algebra::PrimeField::Element;
    static constexpr std::uint64_t prime_bound = std::uint64_t{1} << 30;

    DomainModulo(const DomainMap& map, const algebra::PrimeField& field);

    /// The rank of the differential of the coordinates on the tangent space; nullopt unless the point is one
    /// of the domain at which the gradients of all relations are independent.
    ///
    /// By Hensel's lemma it is then the residue of points over the p-adic integers, near which the domain is
    /// a manifold, with transcendental coordinates if one likes; the rank there is no less, so the component
    /// through it has an image of at least that dimension. Constants are independent variables in it.
    std::optional<std::size_t> rank_at(std::span<const Element> point, base::Run& run) const;

    /// The coordinates at a point of the domain.
    std::vector<Element> image(std::span<const Element> point, base::Run& run) const;

  private:
    const DomainMap& map_;
    algebra::PrimeField field_;
    std::vector<std::vector<algebra::Polynomial>> relation_gradients_;
    std::vector<std::vector<algebra::Polynomial>> numerator_gradients_;
    std::vector<algebra::Polynomial> denominator_gradient_;
};

/// Points of which no polynomial of degree at most `degree` is zero at all: as many as it has coefficients,
/// of which the matrix of all monomials at the points is regular. p is below 2^30.
class IndependentPoints {
  public:
    using Element = algebra::PrimeField::Element;

    IndependentPoints(const algebra::PrimeField& field, std::size_t coordinates, std::uint64_t degree);

    std::size_t needed() const { return exponents_.size(); }
    bool are_enough() const { return rows_.size() == needed(); }
    /// \returns whether the point is independent of those before
    bool add(std::span<const Element> point);

  private:
    algebra::PrimeField field_;
    std::vector<std::vector<std::uint32_t>> exponents_; ///< of the monomials
    std::vector<std::vector<Element>> rows_;            ///< reduced to each other, with a 1 at the pivot
    std::vector<std::size_t> pivots_;
};

/// Number of monomials of degree at most `degree` in so many variables, or `limit` if they are more.
std::size_t monomial_count(std::size_t variables, std::uint64_t degree, std::size_t limit);

/// What is wrong with the claim about the domain, as a clause; empty if nothing is.
///
/// With `lower_degree`, no polynomial of that degree vanishes on the image. If f, of degree lower_degree + 1
/// in the coordinates, does, and the rank is one less than the number of coordinates, f generates the ideal
/// of the image: components of the domain with a point of that rank have hypersurfaces as their images, f is
/// a multiple of the product g of their equations, g vanishes at the images of all points, so that its degree
/// is that of f at least, and f = g. Specialised constants and residues only lower the rank of the matrix.
std::string refutation(const DomainMap& map, const DomainClaim& claim,
                       std::optional<std::uint64_t> lower_degree, base::Run& run);

} // namespace eliminant::implicit
