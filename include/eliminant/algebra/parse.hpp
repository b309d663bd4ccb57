/// \file
/// Text in. The grammar of all formulas:
///
///     sum      = product { ("+" | "-") product }
///     product  = { sign } factor { ("*" | "/") { sign } factor | factor }      the last after a bare number
///     only factor   = atom [ ("^" | "**") exponent | superscript ] exponent = { sign } number | "(" sum
///     without names ")"                   with an integral value atom     = number | name | "(" sum ")" |
///     function "(" sum ")"            functions: expression.hpp only number   = digits [ "." digits ] [ ("e"
///     | "E") [ sign ] digits ] | "." digits …
///
/// - Numbers are exact. `2e3` and `2e-3` are decimals, `2e` and `2ex` products; where `e3` is a variable,
/// `2e3` is an
///   error instead of a guess, and so is a decimal that runs into a letter (`2e3x`).
/// - `-x^2` is −(x²). `x^2^3` is an error: it is read differently by different programs.
/// - A number before a name or a parenthesis is multiplied (`2x`, `3(x+1)`, `2 x`), unless it follows `/` or
/// `^`
///   (`1/2x` and `x^2y` are errors). No other operator is implied: `x y`, `x 1`, `(x)(y)`, `x(y)`, `(x)2` are
///   errors.
/// - −, –, ·, ⋅, ×, ∗, ∕, ⁄ and superscript digits are read as what they look like, Unicode's blanks as
/// blanks.
/// - Blanks, line breaks and comments (from `#` to the end of the line) separate tokens and mean nothing
/// else.
/// - Limits: parentheses nest 1000 deep; exponents are below 2^63; a power or product of constants, or a
/// decimal, has
///   at most 2^22 bits (over GF(p) only what is written matters); an expansion that would need more than
///   about 4 GiB is refused before it starts. Literals may be of any length.
///
/// Everything else, also bytes that are not UTF-8, is a ParseError with line and column of what does not fit.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/algebra/rational_function.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/base/source_text.hpp"

#include <gmpxx.h>

#include <span>
#include <string>
#include <vector>

namespace eliminant::algebra {

/// The polynomial that a text denotes, expanded. Division is allowed by constants only. A sum of n monomials
/// takes linear time, and a sort where they are not in the ring's order. \throws ParseError, Stopped
Polynomial parse_polynomial(const Ring& ring, const base::SourceText& source, base::Run& run);
Polynomial parse_polynomial(const Ring& ring, const base::SourceText& source);

/// A polynomial, or an equation `f = g`, which is f − g.
/// \throws ParseError, Stopped
Polynomial parse_equation(const Ring& ring, const base::SourceText& source, base::Run& run);

/// A quotient of polynomials in the variables of `ring`, in lowest terms.
/// \throws ParseError, Stopped
RationalFunction parse_rational_function(const Ring& ring, const base::SourceText& source, base::Run& run);
RationalFunction parse_rational_function(const Ring& ring, const base::SourceText& source);

/// A number, or a formula of numbers, as `3/4` or `2^-3`.
/// \throws ParseError
mpq_class parse_rational(const base::SourceText& source);

/// The names in a text in order of first appearance. The text need not be a formula otherwise.
/// \throws ParseError where bytes are not UTF-8
std::vector<std::string> names_in(const base::SourceText& source);

/// Distinct names separated by commas, at least one: `x, y, z`.
/// \throws ParseError
std::vector<std::string> parse_names(const base::SourceText& source);

/// `lex`, `deglex`, `degrevlex`, `weight(1,2;lex)` (the tie-break `lex` or `revlex`; revlex if there is
/// none), `elim(x,y)` (several blocks as `elim(x;y,z)`), `matrix(1,1;0,-1)`; an order on variables of these
/// names. \throws ParseError, also for an order that is not admissible, with the reason
MonomialOrder parse_order(const base::SourceText& source, std::span<const std::string> names);

/// `QQ` or `GF(p)`.
/// \throws ParseError, also if p is not a prime below 2^31
CoefficientField parse_field(const base::SourceText& source);

} // namespace eliminant::algebra

namespace eliminant {
using algebra::names_in;
using algebra::parse_equation;
using algebra::parse_field;
using algebra::parse_names;
using algebra::parse_order;
using algebra::parse_polynomial;
using algebra::parse_rational;
using algebra::parse_rational_function;
} // namespace eliminant
