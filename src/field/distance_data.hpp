/// \file
/// What a DistanceField holds besides its polynomial.
#pragma once

#include "field/double_double.hpp"
#include "field/expansion_rows.hpp"
#include "field/taylor_scheme.hpp"
#include "field/wide_float.hpp"

#include <cstdint>
#include <vector>

namespace eliminant::field {

struct CompiledData;

struct DistanceData {
    TaylorScheme taylor;
    // Those of its parts of order 3, 4, … without the containers, see ExpansionView.
    std::vector<TaylorScheme::Component> components;
    std::vector<std::uint32_t> component_ends;
    // The coefficients of f, scaled as those of its CompiledData, as shift_to() takes them.
    std::vector<double> entries;
    std::vector<DoubleDouble> double_doubles;
    std::vector<Wide> wide;

    /// Of a complete expansion.
    ExpansionView view(const CompiledData& compiled) const;
};

} // namespace eliminant::field
