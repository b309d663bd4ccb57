#pragma once

#include "eliminant/algebra/ring.hpp"

#include <span>
#include <string>

namespace eliminant::exporting {

// The ring's order as other systems declare it; names are those of the variables there.

/// `dp`, `(dp(2),dp(1))`, `M(…)`.
std::string singular_order(const algebra::Ring& ring);
/// The value of the option MonomialOrder: `GRevLex`, `{Weights=>{…},Lex}`.
std::string macaulay2_order(const algebra::Ring& ring);
/// The value of the argument order: `'degrevlex'`, `TermOrder(…)`.
std::string sage_order(const algebra::Ring& ring);
/// `tdeg(x,y)`, `'matrix'([[…]],[x,y])`.
std::string maple_order(const algebra::Ring& ring, std::span<const std::string> names);

} // namespace eliminant::exporting
