/// \file
/// Text out.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/algebra/rational_function.hpp"

#include <iosfwd>
#include <string>

namespace eliminant::algebra {

/// `x^4+2*x^2*y^2-3/4*x+1`: terms in the ring's order, without blanks; residues of GF(p) as 0 … p − 1; `0`
/// for zero. parse_polynomial reads it back. Linear.
std::string to_string(const Polynomial& f);

/// For test messages and logs; the same text.
std::ostream& operator<<(std::ostream& out, const Polynomial& f);
std::ostream& operator<<(std::ostream& out, const Ring& ring);

} // namespace eliminant::algebra

namespace eliminant {
using algebra::to_string;
} // namespace eliminant
