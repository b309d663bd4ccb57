#include "number_text.hpp"

#include "scanner.hpp"

#include <algorithm>
#include <charconv>
#include <string>

namespace eliminant::algebra {

namespace {

/// Decimal exponents beyond this exceed max_constant_bits.
constexpr std::int64_t max_decimal_exponent = 1'260'000;

} // namespace

std::optional<std::int64_t> read_exponent(std::string_view digits) {
    if (digits.empty() || !is_digit(digits.front())) return std::nullopt; // from_chars would take a sign
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || stop != digits.data() + digits.size()) return std::nullopt;
    return value;
}

Expression::Number multiply_fractions(const Expression::Number& a, const Expression::Number& b) {
    Expression::Number result{a.numerator * b.numerator, a.denominator * b.denominator};
    if (!result.denominator.is_one()) {
        const Integer common = gcd(result.numerator, result.denominator);
        result.numerator.divide_exactly(common);
        result.denominator.divide_exactly(common);
    }
    return result;
}

Expression::Number read_number(const base::SourceText& source, std::size_t begin, std::size_t end) {
    const std::string_view text = source.text().substr(begin, end - begin);
    const std::size_t exponent_at = std::min(text.find_first_of("eE"), text.size());
    const std::size_t point = std::min(text.find('.'), exponent_at);
    std::string digits(text.substr(0, point));
    std::int64_t scale = 0; // value = digits · 10^scale
    if (point != exponent_at) {
        digits += text.substr(point + 1, exponent_at - point - 1);
        scale = -static_cast<std::int64_t>(exponent_at - point - 1);
    }
    if (exponent_at != text.size()) {
        std::string_view written = text.substr(exponent_at + 1);
        const bool minus = written.front() == '-';
        if (minus || written.front() == '+') written.remove_prefix(1);
        const auto value = read_exponent(written);
        if (!value || *value > max_decimal_exponent)
            source.fail(begin + exponent_at + 1,
                        "a decimal exponent of at most " + std::to_string(max_decimal_exponent));
        scale += minus ? -*value : *value;
    }
    Expression::Number result{Integer::from_digits(digits), Integer(1)};
    if (scale == 0) return result;
    const Integer power = pow(Integer(10), static_cast<unsigned long>(scale < 0 ? -scale : scale));
    const Expression::Number ten =
        scale < 0 ? Expression::Number{Integer(1), power} : Expression::Number{power, Integer(1)};
    return multiply_fractions(result, ten);
}

} // namespace eliminant::algebra
