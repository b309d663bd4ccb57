/// \file
/// Systems of polynomials in text: our own format, msolve's and Singular's.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/base/source_text.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace eliminant::algebra {

/// Polynomials of one ring.
struct System {
    Ring ring;
    std::vector<Polynomial> polynomials;
};

/// How a system is written.
enum class SystemFormat {
    guess, ///< whichever of the others the beginning of the text can only be

    /// Lines `variables x, y, z`, `field QQ` or `field GF(p)`, `order …`, all optional, each at most once and
    /// before the first polynomial; then a polynomial or an equation a line. Comments with `#`, empty lines.
    /// Without `variables`, the variables are the names in order of first appearance.
    eliminant,

    /// Variables separated by commas; the characteristic, 0 for ℚ; polynomials separated by commas, over any
    /// number of lines. The order is degrevlex.
    msolve,

    /// `ring r = 0,(x,y,z),dp;` then `poly f = …;` and one `ideal I = f, …;`, the system (all the poly, if
    /// there is no ideal). Orderings lp, dp, Dp, wp, Wp, M and products of them, a vector `a` before.
    /// Monomials may be written x2y, and mean what Singular reads: 2x^2 is (2x)^2 there, and so it is here.
    singular,
};

/// What a caller sets against the text. Variables that are no names, or not distinct, are a DomainError.
struct SystemOverrides {
    std::optional<std::vector<std::string>> variables = {};
    std::optional<CoefficientField> field = {};
    std::optional<std::string> order = {}; ///< as parse_order reads it; it may name variables
};

/// Reads a system.
/// \throws ParseError at the first thing that does not fit, Stopped
System parse_system(const base::SourceText& source, SystemFormat format, const SystemOverrides& overrides,
                    base::Run& run);

/// A system of polynomials and equations, one a text, as on a command line. Without overrides the ring is ℚ
/// in the names in order of first appearance, degrevlex. \throws ParseError, Stopped
System parse_system(std::span<const base::SourceText> polynomials, const SystemOverrides& overrides,
                    base::Run& run);

/// The system in our own format; parse_system reads it back.
std::string to_string(const System& system);

} // namespace eliminant::algebra

namespace eliminant {
using algebra::parse_system;
using algebra::System;
using algebra::SystemFormat;
using algebra::SystemOverrides;
} // namespace eliminant
