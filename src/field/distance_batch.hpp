/// \file
/// Distances of batches on a chosen instruction set, and what single points share with them.
#pragma once

#include "eliminant/field/distance.hpp"

#include "field/local_forms.hpp"

#include "base/vector_unit.hpp"

namespace eliminant::field {

/// The result that doubles have given from these forms at a finite point, or, if errors may spoil it, that of
/// more precise numbers. f is not 0.
Distance trusted_or_precise(const Estimate<double>& result, const LocalForms<double>& forms,
                            const DistanceField& field, const glm::dvec3& point, DistanceLevel level);

/// `distances` with a unit that this machine has.
void distances_with(base::VectorUnit unit, const DistanceField& field, const PointArrays<double>& points,
                    DistanceLevel level, const DistanceArrays& result);

} // namespace eliminant::field
