/// \file
/// What a DistanceField holds besides its polynomial.
#pragma once

#include "field/double_double.hpp"
#include "field/taylor_scheme.hpp"
#include "field/wide_float.hpp"

#include <vector>

namespace eliminant::field {

struct DistanceData {
    TaylorScheme taylor;
    // The coefficients of f, scaled as those of its CompiledData, as shift_to() takes them.
    std::vector<double> entries;
    std::vector<DoubleDouble> double_doubles;
    std::vector<Wide> wide;
};

} // namespace eliminant::field
