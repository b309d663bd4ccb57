/// \file
/// Batches on a chosen instruction set.
#pragma once

#include "eliminant/field/compiled_polynomial.hpp"

#include "base/vector_unit.hpp"

namespace eliminant::field {

/// CompiledPolynomial::evaluate with a unit that this machine has.
void evaluate_with(base::VectorUnit unit, const CompiledPolynomial& f, const PointArrays<double>& points,
                   const JetArrays<double>& jets);
void evaluate_with(base::VectorUnit unit, const CompiledPolynomial& f, const PointArrays<float>& points,
                   const JetArrays<float>& jets);

} // namespace eliminant::field
