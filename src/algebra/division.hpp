#pragma once

#include "eliminant/algebra/arithmetic.hpp"

#include <optional>

namespace eliminant::algebra {

/// Overrides of the choices of try_divide(), for tests: every combination gives the same result.
struct ExactDivisionOptions {
    std::optional<unsigned> window_bits = {}; ///< log₂ of the cells of the window; 0 is the quotient heap
};

/// try_divide() with overrides.
std::optional<Polynomial> try_divide_with(const Polynomial& a, const Polynomial& b,
                                          const ExactDivisionOptions& options, base::Run& run);

} // namespace eliminant::algebra
