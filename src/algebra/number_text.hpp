#pragma once

#include "eliminant/algebra/expression.hpp"
#include "eliminant/base/source_text.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace eliminant::algebra {

/// Largest size, in bits, of a constant that is computed and not spelled out: 1.2 million decimal digits.
constexpr std::size_t max_constant_bits = std::size_t{1} << 22;

/// The value of a number token. Throws ParseError where a decimal exponent makes it too large.
Expression::Number read_number(const base::SourceText& source, std::size_t begin, std::size_t end);

/// Digits as a number below 2^63; nullopt if it is not.
std::optional<std::int64_t> read_exponent(std::string_view digits);

/// a·b/(c·d) in lowest terms.
Expression::Number multiply_fractions(const Expression::Number& a, const Expression::Number& b);

} // namespace eliminant::algebra
