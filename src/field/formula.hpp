/// \file
/// Polynomials as sums, products and powers: what expansion would forget.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/base/source_text.hpp"

#include <gmpxx.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace eliminant::field {

/// factor · (a polynomial, or the sum or product of `parts`, or parts[0]^exponent).
///
/// Sums have no sums and products no products among their parts, so that trees are as deep as parentheses.
struct Formula {
    enum class Kind : std::uint8_t { polynomial, sum, product, power };

    Kind kind = Kind::polynomial;
    mpq_class factor = 1;
    std::optional<algebra::Polynomial> polynomial = {};
    std::vector<Formula> parts = {};
    std::uint64_t exponent = 1;

    bool is_constant() const { return kind == Kind::polynomial && polynomial->is_constant(); }
};

Formula to_formula(algebra::Polynomial f);

/// The structure of a text that parse_equation() has expanded: of f − g for f = g.
Formula formula_of_text(const algebra::Polynomial& expanded, const base::SourceText& source, base::Run& run);

/// The obvious factors of f: its unit, contents with respect to each coordinate, and powers. Often there are
/// none, and what comes back is f. A gcd or a few.
Formula obvious_factors(const algebra::Polynomial& f, base::Run& run);

} // namespace eliminant::field
