// Maps by single terms, on which a binomial can be checked by its exponents alone.
#pragma once

#include "implicit/verify_map.hpp"

#include <gmpxx.h>

#include <optional>
#include <string_view>
#include <vector>

namespace eliminant::implicit {

/// A map whose components are terms c·t^a in parameters and constants, c ≠ 0; exponents may be negative.
struct TermMap {
    std::vector<mpq_class> coefficients;           ///< one a component
    std::vector<std::vector<mpz_class>> exponents; ///< one row a component, one entry a variable of the ring
};

/// nullopt if a component is no single term.
std::optional<TermMap> term_map(const RationalMap& map);

constexpr std::string_view toric_theorem =
    "the coordinates are monomials, and the equation is a binomial that exponents show to be zero on them; "
    "their "
    "rank is n - 1, so the ideal of the image is principal; and the binomial is irreducible, because its two "
    "monomials are coprime and the exponents have no common factor";

/// Whether f, in the ring of the map's coordinates, is an irreducible binomial that is zero on the map.
///
/// With f = a·x^p + b·x^q, p and q without a common variable, and u = p − q: it is zero on the map if Σ uᵢ·aᵢ
/// = 0 and a·∏ cᵢ^uᵢ = −b. If the gcd of u is 1, u is part of a basis of the lattice, so an automorphism of
/// the ring of Laurent polynomials takes f to a unit times z + b/a (B. Sturmfels, Gröbner Bases and Convex
/// Polytopes, ch. 4): f has one factor that is no monomial, and none that is one.
/// \throws OverflowError where the coefficients have to be greater than `max_binomial_bits`
bool is_irreducible_binomial_on(const TermMap& map, const algebra::Polynomial& f);

/// ∏ cᵢ^uᵢ. \throws OverflowError if that may be a number of more than `max_binomial_bits`
mpq_class product_of_powers(const std::vector<mpq_class>& c, const std::vector<mpz_class>& u);
constexpr std::size_t max_binomial_bits = std::size_t{1} << 24;

} // namespace eliminant::implicit
