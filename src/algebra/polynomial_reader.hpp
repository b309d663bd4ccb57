#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/base/source_text.hpp"

#include "expression_parser.hpp"
#include "polynomial_arithmetic.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace eliminant::algebra {

/// Reads the terms that nearly all long polynomials are made of, `- 3/4*x^2*y`, straight into a
/// PolynomialBuilder.
///
/// It knows only digits, names, `*`, `^`, `/` after the first number, and ASCII blanks. Of anything else,
/// also of every error, it reads nothing and leaves it to ExpressionParser, so that the grammar and its
/// messages stay in one place.
class TermReader {
  public:
    TermReader(const Ring& ring, std::string_view text, Dialect dialect);

    /// Reads one term at `position` that is followed by a sign, the end, or one of `=,;`, adds it to the sum
    /// and moves `position` to what follows. Otherwise changes nothing and returns false.
    bool read(std::size_t& position, PolynomialBuilder& sum);

  private:
    const char* skip_blanks(const char* p) const;
    const char* read_digits(const char* p, Integer& value) const;
    const char* read_coefficient(const char* p);
    const char* read_power(const char* p);
    std::size_t find(std::string_view name) const;

    static constexpr std::size_t absent = ~std::size_t{0};

    Ring ring_;
    std::string_view text_;
    const char* end_;
    bool juxtaposition_; ///< 2x is a product
    std::array<std::size_t, 128> one_letter_names_;
    Integer numerator_;
    Integer denominator_;
    std::vector<std::uint64_t> exponents_;
};

/// Reads polynomials one after another from a text.
class PolynomialReader {
  public:
    using Definitions = std::map<std::string, Polynomial, std::less<>>;

    /// The references outlive it.
    PolynomialReader(const Ring& ring, const base::SourceText& source, Dialect dialect, base::Run& run);
    PolynomialReader(const PolynomialReader&) = delete;
    PolynomialReader& operator=(const PolynomialReader&) = delete;

    /// Names that stand for polynomials besides the variables.
    void set_definitions(const Definitions& definitions) { definitions_ = &definitions; }

    /// The sum at `position`, up to the end or one of `=,;`, which `position` is set to.
    /// Throws ParseError at what is neither a part of it nor one of these.
    Polynomial read(std::size_t& position);
    /// The same for `f` or `f = g`.
    Polynomial read_equation(std::size_t& position);

  private:
    std::size_t read_general_term(std::size_t position, PolynomialBuilder& sum);

    Ring ring_;
    const base::SourceText& source_;
    Dialect dialect_;
    base::Run& run_;
    Vocabulary vocabulary_;
    const Definitions* definitions_ = nullptr;
    TermReader terms_;
};

} // namespace eliminant::algebra
