#include "field/batch_kernel.hpp"

#include "base/pack.hpp"

namespace eliminant::field {
namespace {

/// A pack as an arithmetic of NestedHorner and ProgramKernel.
template <class Lanes, class Number>
struct PackArithmetic {
    using Scalar = Number;
    using Pack = Lanes;

    static Pack zero() { return Pack::all(Number(0)); }
    static Pack broadcast(Number value) { return Pack::all(value); }
    static Pack add(Pack a, Pack b) { return a + b; }
    static Pack multiply(Pack a, Pack b) { return a * b; }
    static Pack multiply_add(Pack a, Pack b, Pack c) { return fma(a, b, c); }
};

template <class Pack, class Scalar>
class BatchKernel {
  public:
    static void run(const ProgramView& program, const Scalar* coefficients, const BatchArrays<Scalar>& arrays,
                    unsigned long count) {
        const unsigned long full = count - count % Pack::lanes;
        if (program.is_plain())
            run_leaf(program.leaves[0].scheme, coefficients, arrays, full);
        else
            run_program(program, coefficients, arrays, full);
        if (full < count) rest(program, coefficients, arrays, full, count);
    }

  private:
    using Arithmetic = PackArithmetic<Pack, Scalar>;

    static void run_leaf(const SchemeView& scheme, const Scalar* coefficients,
                         const BatchArrays<Scalar>& arrays, unsigned long count) {
        for (unsigned long first = 0; first < count; first += Pack::lanes)
            NestedHorner<Arithmetic>::for_each_of_jet(
                scheme, coefficients, Pack::load(arrays.point[0] + first),
                Pack::load(arrays.point[1] + first), Pack::load(arrays.point[2] + first),
                [&](int k, const Pack& value) { value.store(arrays.jet[k] + first); });
    }
    static void run_program(const ProgramView& program, const Scalar* coefficients,
                            const BatchArrays<Scalar>& arrays, unsigned long count) {
        for (unsigned long first = 0; first < count; first += Pack::lanes) {
            Pack point[3];
            for (int i = 0; i < 3; ++i)
                point[i] = Pack::load(arrays.point[i] + first) + Pack::all(Scalar(program.shift[i]));
            Pack jet[jet_size];
            ProgramKernel<Arithmetic>::jet(program, coefficients, point, jet);
            for (int k = 0; k < jet_size; ++k) jet[k].store(arrays.jet[k] + first);
        }
    }

    /// Fewer points than lanes: by way of full ones on the stack, the spare lanes at the origin.
    static void rest(const ProgramView& program, const Scalar* coefficients,
                     const BatchArrays<Scalar>& arrays, unsigned long first, unsigned long count) {
        Scalar buffer[3 + jet_size][Pack::lanes] = {};
        for (int i = 0; i < 3; ++i)
            for (unsigned long k = first; k < count; ++k) buffer[i][k - first] = arrays.point[i][k];
        BatchArrays<Scalar> lanes;
        for (int i = 0; i < 3; ++i) lanes.point[i] = buffer[i];
        for (int i = 0; i < jet_size; ++i) lanes.jet[i] = buffer[3 + i];
        run(program, coefficients, lanes, Pack::lanes);
        for (int i = 0; i < jet_size; ++i)
            for (unsigned long k = first; k < count; ++k) arrays.jet[i][k] = buffer[3 + i][k - first];
    }
};

template <class Scalar>
struct PackOf {
    using type = base::Doubles;
};
template <>
struct PackOf<float> {
    using type = base::Floats;
};

} // namespace

template <base::VectorUnit unit, class Scalar>
void evaluate_arrays(const ProgramView& program, const Scalar* coefficients,
                     const BatchArrays<Scalar>& arrays, unsigned long count) {
    BatchKernel<typename PackOf<Scalar>::type, Scalar>::run(program, coefficients, arrays, count);
}

template void evaluate_arrays<base::this_unit>(const ProgramView&, const double*, const BatchArrays<double>&,
                                               unsigned long);
template void evaluate_arrays<base::this_unit>(const ProgramView&, const float*, const BatchArrays<float>&,
                                               unsigned long);

} // namespace eliminant::field
