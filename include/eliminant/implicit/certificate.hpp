/// \file
/// What is claimed of implicit equations, in a form that can be checked without the code that found them.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace eliminant::implicit {

/// A parametrization in text: formulas of polynomials and rational functions, without cos and sin.
struct CertificateInput {
    std::vector<std::string> parameters;
    std::vector<std::string> constants; ///< elements of the field
    /// Pairs of parameters that are the cosine and the sine of one angle: c² + s² = 1.
    std::vector<std::pair<std::string, std::string>> angles;
    std::vector<std::string> relations;                           ///< polynomials that are zero on the domain
    std::vector<std::pair<std::string, std::string>> coordinates; ///< names and functions

    friend bool operator==(const CertificateInput&, const CertificateInput&) = default;
};

/// That an equation is zero on the parametrization. In it, put in, cleared of denominators, cos and sin being
/// replaced by functions of the tangent of the half-angle (named as the cosine was), no coefficient exceeds
/// `height`, no degree the bounds; and it is zero modulo the primes, of which the product exceeds the height.
struct VanishingClaim {
    std::vector<std::uint64_t> degrees; ///< in the parameters, then the constants
    std::uint64_t total_degree = 0;
    mpz_class height;
    std::vector<std::uint64_t> primes;

    friend bool operator==(const VanishingClaim&, const VanishingClaim&) = default;
};

/// That the differential of the coordinates by the parameters has this rank at a point modulo a prime,
/// half-angles as above: the image has at least this dimension.
struct RankClaim {
    std::uint64_t prime = 0;
    std::vector<std::uint32_t> point; ///< values of the parameters, then of the constants
    std::uint64_t rank = 0;
    std::uint32_t minor = 0; ///< product of the pivots of its elimination

    friend bool operator==(const RankClaim&, const RankClaim&) = default;
};

/// That an equation is irreducible over the field of constants: modulo a prime, on the line base +
/// t·direction, it keeps its degree and is irreducible.
struct SectionClaim {
    std::uint64_t prime = 0;
    std::vector<std::uint32_t> base;      ///< values of the coordinates, then of the constants
    std::vector<std::uint32_t> direction; ///< zero at the constants
    std::vector<std::uint32_t> section;   ///< the restriction, monic, from the constant coefficient up

    friend bool operator==(const SectionClaim&, const SectionClaim&) = default;
};

/// For inputs with relations, in the place of the claims on vanishing, rank and irreducibility: points of the
/// domain modulo a prime at which it is smooth and the coordinates are defined, and at which the differential
/// of the coordinates on the tangent space has the rank claimed. For a hypersurface they are as many as there
/// are monomials of lower degree than that of the equation, and no combination of these is zero at all of
/// their images; otherwise one is enough.
struct DomainClaim {
    /// Of parameters, then constants: comparing monomials by this weight first, then by degrevlex, the
    /// leading ones of the relations are coprime, so that division by the relations tells what is in their
    /// ideal.
    std::vector<std::uint64_t> weights;
    std::uint64_t prime = 0;
    std::uint64_t rank = 0;
    std::vector<std::vector<std::uint32_t>> points; ///< values of the parameters, then of the constants

    friend bool operator==(const DomainClaim&, const DomainClaim&) = default;
};

/// Why the equations are those of the closure of the image.
enum class Theorem {
    /// One equation; it vanishes, the dimension is one less than that of the space, and it is irreducible, or
    /// of the least degree: so it generates the ideal of the image, which is principal. All of it is checked.
    hypersurface,
    /// One equation, a binomial, and coordinates that are single terms: exponents and coefficients show that
    /// it
    /// vanishes and is irreducible, so it generates the ideal. All of it is checked, without VanishingClaim
    /// and
    /// SectionClaim, whatever the degree.
    toric,
    /// No equation: the dimension is that of the space. All of it is checked.
    dense,
    /// The equations are a Groebner basis of the kernel of a homomorphism, made by elimination. That they
    /// vanish, and that the image has at least the dimension claimed, is checked; that there are no other
    /// equations, and so the dimension, rests on the computation.
    elimination,
};

/// What is claimed of the equations.
struct Claims {
    Theorem theorem = Theorem::elimination;
    std::uint64_t codimension = 0;
    std::vector<std::uint64_t> degrees;    ///< of the equations, in the coordinates
    std::vector<VanishingClaim> vanishing; ///< one an equation; none if `toric`
    RankClaim rank;
    std::optional<SectionClaim> irreducible; ///< of a hypersurface
    std::optional<DomainClaim> domain;       ///< of an input with relations, instead of these three

    friend bool operator==(const Claims&, const Claims&) = default;
};

/// An input, its equations, and what is claimed of them; checked by verify().
struct Certificate {
    CertificateInput input;
    std::vector<std::string> equations; ///< polynomials in the coordinates, then the constants
    Claims claims;

    friend bool operator==(const Certificate&, const Certificate&) = default;
};

/// A checksum of all that a certificate says (FNV-1a, 64 bits), which is written down with it: most claims
/// can be changed to others that are true as well, and whoever does so by accident should be told.
std::uint64_t digest(const Certificate& certificate);

} // namespace eliminant::implicit

namespace eliminant {
using implicit::Certificate;
using implicit::CertificateInput;
using implicit::Claims;
using implicit::DomainClaim;
using implicit::RankClaim;
using implicit::SectionClaim;
using implicit::Theorem;
using implicit::VanishingClaim;
} // namespace eliminant
