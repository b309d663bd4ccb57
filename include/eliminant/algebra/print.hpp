/// \file
/// Text out.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/algebra/rational_function.hpp"
#include "eliminant/base/run.hpp"

#include <iosfwd>
#include <string>

namespace eliminant::algebra {

/// `x^4+2*x^2*y^2-3/4*x+1`: terms in the ring's order, without blanks; residues of GF(p) as 0 … p − 1; `0`
/// for zero. parse_polynomial reads it back. Linear, except in the digits of a coefficient.
std::string to_string(const Polynomial& f);
/// \throws Stopped
std::string to_string(const Polynomial& f, const base::Run& run);

/// For test messages and logs; the same text.
std::ostream& operator<<(std::ostream& out, const Polynomial& f);
std::ostream& operator<<(std::ostream& out, const Ring& ring);

} // namespace eliminant::algebra

namespace eliminant {
using algebra::to_string;
} // namespace eliminant
