#include "polynomial_reader.hpp"

#include "scanner.hpp"

#include <algorithm>
#include <string>

namespace eliminant::algebra {

namespace {

/// As many decimal digits always fit in an inline Integer.
constexpr std::ptrdiff_t max_small_digits = 18;

} // namespace

TermReader::TermReader(const Ring& ring, std::string_view text, Dialect dialect)
    : ring_(ring), text_(text), end_(text.data() + text.size()),
      juxtaposition_(dialect == Dialect::eliminant), exponents_(ring.variable_count(), 0) {
    one_letter_names_.fill(absent);
    for (std::size_t i = 0; i < ring.variable_count(); ++i) {
        const std::string& name = ring.names()[i];
        if (name.size() == 1) one_letter_names_[static_cast<unsigned char>(name.front())] = i;
    }
}

std::size_t TermReader::find(std::string_view name) const {
    if (name.size() == 1) return one_letter_names_[static_cast<unsigned char>(name.front())];
    return ring_.index_of(name).value_or(absent);
}

const char* TermReader::skip_blanks(const char* p) const {
    while (p != end_ && (*p == ' ' || *p == '\n' || *p == '\r' || *p == '\t')) ++p;
    return p;
}

const char* TermReader::read_digits(const char* p, Integer& value) const {
    const char* const first = p;
    std::int64_t small = 0;
    for (; p != end_ && is_digit(*p) && p - first < max_small_digits; ++p) small = 10 * small + (*p - '0');
    if (p == end_ || !is_digit(*p)) {
        value = Integer(small);
        return p;
    }
    p = std::find_if_not(p, end_, is_digit);
    value = Integer::from_digits(std::string(first, p));
    return p;
}

/// A number or fraction and the `*` after it; null where there is more to it.
const char* TermReader::read_coefficient(const char* p) {
    p = read_digits(p, numerator_);
    bool is_fraction = false;
    if (p != end_ && *p == '/') {
        ++p;
        if (p == end_ || !is_digit(*p)) return nullptr;
        p = read_digits(p, denominator_);
        if (denominator_.is_zero()) return nullptr;
        is_fraction = true;
    }
    if (p == end_) return p;
    if (*p == '*') return p + 1 != end_ && is_letter(p[1]) ? p + 1 : nullptr;
    // 2x is a product, 2e3 is not, 1/2x is an error.
    if (is_letter(*p)) return juxtaposition_ && !is_fraction && *p != 'e' && *p != 'E' ? p : nullptr;
    return p;
}

/// A name, its exponent, and the `*` after them if a name follows it; null where there is more to it.
const char* TermReader::read_power(const char* p) {
    const char* const name = p;
    while (p != end_ && continues_name(*p)) ++p;
    const std::size_t variable = find({name, static_cast<std::size_t>(p - name)});
    if (variable == absent) return nullptr;
    std::uint64_t exponent = 1;
    if (p != end_ && *p == '^') {
        const char* const digits = ++p;
        exponent = 0;
        for (; p != end_ && is_digit(*p) && p - digits < max_small_digits; ++p)
            exponent = 10 * exponent + static_cast<std::uint64_t>(*p - '0');
        if (p == digits || (p != end_ && continues_name(*p)) || (p != end_ && *p == '.')) return nullptr;
    }
    exponents_[variable] += exponent;
    if (exponents_[variable] >> 63 != 0) return nullptr;
    if (p != end_ && *p == '*') return p + 1 != end_ && is_letter(p[1]) ? p + 1 : nullptr;
    return p;
}

bool TermReader::read(std::size_t& position, PolynomialBuilder& sum) {
    std::ranges::fill(exponents_, 0);
    const char* p = skip_blanks(text_.data() + position);
    if (p == end_) return false;
    const bool minus = *p == '-';
    if (minus || *p == '+') p = skip_blanks(p + 1);
    numerator_ = Integer(1);
    denominator_ = Integer(1);
    if (p != end_ && is_digit(*p))
        p = read_coefficient(p);
    else if (p == end_ || !is_letter(*p))
        return false;
    while (p != nullptr && p != end_ && is_letter(*p)) {
        const char* const next = read_power(p);
        if (next != nullptr && next != end_ && is_letter(*next) && next[-1] != '*') return false;
        p = next;
    }
    if (p == nullptr) return false;
    p = skip_blanks(p);
    if (p != end_ && *p != '+' && *p != '-' && *p != '=' && *p != ',' && *p != ';') return false;
    if (minus) numerator_.negate();
    if (!ring_.field().is_rationals() && !denominator_.is_one()) return false; // it may be zero there
    sum.add(numerator_, denominator_, exponents_);
    position = static_cast<std::size_t>(p - text_.data());
    return true;
}

} // namespace eliminant::algebra
