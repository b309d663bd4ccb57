/// \file
/// Value, gradient and Hessian of many points in vector registers, for any of them.
///
/// A is an arithmetic of NestedHorner with `lanes`, load(const Scalar*) and store(Scalar*, Pack).
#pragma once

#include "field/nested_horner.hpp"

namespace eliminant::field {

/// Columns of numbers: coordinates by the levels of the scheme, components by its SchemeView::components.
template <class Scalar>
struct BatchArrays {
    const Scalar* point[3];
    Scalar* jet[jet_size];
};

template <class A>
class BatchKernel {
  public:
    using Pack = typename A::Pack;
    using Scalar = typename A::Scalar;

    static void run(const SchemeView& scheme, const Scalar* coefficients, const BatchArrays<Scalar>& arrays,
                    unsigned long count) {
        unsigned long first = 0;
        for (; first + A::lanes <= count; first += A::lanes) {
            NestedHorner<A>::for_each_of_jet(
                scheme, coefficients, A::load(arrays.point[0] + first), A::load(arrays.point[1] + first),
                A::load(arrays.point[2] + first),
                [&](int k, const Pack& value) { A::store(arrays.jet[k] + first, value); });
        }
        if (first < count) rest(scheme, coefficients, arrays, first, count);
    }

  private:
    /// Fewer points than lanes: by way of full ones on the stack, the spare lanes at the origin.
    static void rest(const SchemeView& scheme, const Scalar* coefficients, const BatchArrays<Scalar>& arrays,
                     unsigned long first, unsigned long count) {
        Scalar buffer[3 + jet_size][A::lanes] = {};
        for (int i = 0; i < 3; ++i)
            for (unsigned long k = first; k < count; ++k) buffer[i][k - first] = arrays.point[i][k];
        BatchArrays<Scalar> lanes;
        for (int i = 0; i < 3; ++i) lanes.point[i] = buffer[i];
        for (int i = 0; i < jet_size; ++i) lanes.jet[i] = buffer[3 + i];
        run(scheme, coefficients, lanes, A::lanes);
        for (int i = 0; i < jet_size; ++i)
            for (unsigned long k = first; k < count; ++k) arrays.jet[i][k] = buffer[3 + i][k - first];
    }
};

} // namespace eliminant::field
