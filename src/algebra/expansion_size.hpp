#pragma once

#include "eliminant/algebra/polynomial.hpp"

#include <cstdint>

namespace eliminant::algebra {

/// A formula is not expanded where the bounds below exceed this.
constexpr double max_expansion_bytes = 4294967296.0;
constexpr const char* expansion_expected = "a formula that expands to less than about 4 GiB";

/// Upper bound of the memory that a·b takes, in bytes: terms are at most the product of the numbers of terms,
/// and at most the monomials of the degrees that occur; coefficients at most as long as their sum says.
double expansion_bytes(const Polynomial& a, const Polynomial& b);

/// The same for f^exponent: at most C(exponent + t − 1, t − 1) terms for t terms.
double expansion_bytes(const Polynomial& f, std::uint64_t exponent);

} // namespace eliminant::algebra
