// cos and sin in formulas.
#pragma once

#include "eliminant/algebra/expression.hpp"
#include "eliminant/algebra/polynomial.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace eliminant::implicit {

/// An argument of cos or sin: multiple · parameter, the multiple not zero.
struct Angle {
    std::string parameter;
    std::int64_t multiple; ///< below 2^62 in absolute value
};

/// Reads the argument of a function, which may be any formula with such a value, as `u + 2*u`.
/// \param is_parameter says so of a name
/// \throws ParseError if it is anything else
Angle read_angle(algebra::ExpressionView argument, std::size_t call_offset,
                 const std::function<bool(std::string_view)>& is_parameter, base::Run& run);

/// cos(mθ) and sin(mθ) in c = cos θ and s = sin θ.
struct CosineAndSine {
    algebra::Polynomial cosine;
    algebra::Polynomial sine;
};

/// Largest multiple of an angle that is expanded: the expansion has a number of digits quadratic in it.
constexpr std::int64_t max_multiple = 2000;

/// cos(mθ) = T_m(c) and sin(mθ) = s·U_{m−1}(c) with the polynomials of Chebyshev, for 0 ≤ m ≤ max_multiple,
/// by their recurrence.
CosineAndSine multiple_angle(const algebra::Polynomial& c, const algebra::Polynomial& s,
                             std::int64_t multiple, base::Run& run);

} // namespace eliminant::implicit
