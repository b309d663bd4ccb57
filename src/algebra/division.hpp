#pragma once

#include "eliminant/algebra/arithmetic.hpp"

#include <optional>

namespace eliminant::algebra {

/// How an exact quotient is computed.
enum class QuotientKernel {
    automatic, ///< by the shape of the operands
    window,    ///< a window, or the heap, that slides down the terms
    dense, ///< arrays with room for every monomial, or division of huge integers; `window` where exponents
           ///< are large
};

/// Overrides of the choices of try_divide(), for tests: every combination gives the same result.
struct ExactDivisionOptions {
    QuotientKernel kernel = QuotientKernel::automatic;
    std::optional<unsigned> window_bits = {}; ///< log₂ of the cells of the window; 0 is the quotient heap
};

/// try_divide() with overrides.
std::optional<Polynomial> try_divide_with(const Polynomial& a, const Polynomial& b,
                                          const ExactDivisionOptions& options, base::Run& run);

} // namespace eliminant::algebra
