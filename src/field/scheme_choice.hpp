/// \file
/// Which scheme a CompiledPolynomial evaluates.
#pragma once

#include "eliminant/base/run.hpp"
#include "eliminant/field/compiled_polynomial.hpp"

#include "field/compiled_data.hpp"
#include "field/formula.hpp"

#include <optional>

namespace eliminant::field {

/// Sets program and schemes of data whose exact polynomial and scales are there: the candidate of least
/// expected cost, its accuracy being measured on points of the box or of [−1, 1]³.
void choose_scheme(CompiledData& data, const std::optional<Formula>& formula, const std::optional<Box>& box,
                   base::Run& run);

} // namespace eliminant::field
