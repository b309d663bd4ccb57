/// \file
/// Value, gradient and Hessian of many points in vector registers, for any of them.
///
/// A is an arithmetic of NestedHorner with `lanes`, load(const Scalar*) and store(Scalar*, Pack).
#pragma once

#include "field/program_kernel.hpp"

namespace eliminant::field {

/// Columns of numbers: for a plain leaf coordinates by the levels of its scheme and components by its
/// SchemeView::components, else x, y, z and as JetComponent.
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

    static void run(const ProgramView& program, const Scalar* coefficients, const BatchArrays<Scalar>& arrays,
                    unsigned long count) {
        const unsigned long full = count - count % A::lanes;
        if (program.is_plain())
            run_leaf(program.leaves[0].scheme, coefficients, arrays, full);
        else
            run_program(program, coefficients, arrays, full);
        if (full < count) rest(program, coefficients, arrays, full, count);
    }

  private:
    static void run_leaf(const SchemeView& scheme, const Scalar* coefficients,
                         const BatchArrays<Scalar>& arrays, unsigned long count) {
        for (unsigned long first = 0; first < count; first += A::lanes)
            NestedHorner<A>::for_each_of_jet(
                scheme, coefficients, A::load(arrays.point[0] + first), A::load(arrays.point[1] + first),
                A::load(arrays.point[2] + first),
                [&](int k, const Pack& value) { A::store(arrays.jet[k] + first, value); });
    }
    static void run_program(const ProgramView& program, const Scalar* coefficients,
                            const BatchArrays<Scalar>& arrays, unsigned long count) {
        for (unsigned long first = 0; first < count; first += A::lanes) {
            Pack point[3];
            for (int i = 0; i < 3; ++i)
                point[i] = A::add(A::load(arrays.point[i] + first), A::broadcast(Scalar(program.shift[i])));
            Pack jet[jet_size];
            ProgramKernel<A>::jet(program, coefficients, point, jet);
            for (int k = 0; k < jet_size; ++k) A::store(arrays.jet[k] + first, jet[k]);
        }
    }

    /// Fewer points than lanes: by way of full ones on the stack, the spare lanes at the origin.
    static void rest(const ProgramView& program, const Scalar* coefficients,
                     const BatchArrays<Scalar>& arrays, unsigned long first, unsigned long count) {
        Scalar buffer[3 + jet_size][A::lanes] = {};
        for (int i = 0; i < 3; ++i)
            for (unsigned long k = first; k < count; ++k) buffer[i][k - first] = arrays.point[i][k];
        BatchArrays<Scalar> lanes;
        for (int i = 0; i < 3; ++i) lanes.point[i] = buffer[i];
        for (int i = 0; i < jet_size; ++i) lanes.jet[i] = buffer[3 + i];
        run(program, coefficients, lanes, A::lanes);
        for (int i = 0; i < jet_size; ++i)
            for (unsigned long k = first; k < count; ++k) arrays.jet[i][k] = buffer[3 + i][k - first];
    }
};

} // namespace eliminant::field
