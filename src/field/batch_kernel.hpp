/// \file
/// Value, gradient and Hessian of many points; nothing of the standard library, for files of one instruction
/// set.
#pragma once

#include "field/program_kernel.hpp"

#include "base/vector_unit.hpp"

namespace eliminant::field {

/// Columns of numbers: for a plain leaf coordinates by the levels of its scheme and components by its
/// SchemeView::components, else x, y, z and as JetComponent.
template <class Scalar>
struct BatchArrays {
    const Scalar* point[3];
    Scalar* jet[jet_size];
};

/// For Scalar float and double; defined for each unit by batch_per_unit.cpp.
template <base::VectorUnit unit, class Scalar>
void evaluate_arrays(const ProgramView& program, const Scalar* coefficients,
                     const BatchArrays<Scalar>& arrays, unsigned long count);

} // namespace eliminant::field
