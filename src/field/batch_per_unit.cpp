#include "field/batch_kernel.hpp"

#include "base/pack.hpp"

namespace eliminant::field {
namespace {

/// A pack as an arithmetic of NestedHorner and ProgramKernel: by its bare register, for compilers keep
/// structures of structures of registers in memory, which takes 1.4 times as long.
template <class Lanes, class Number>
struct PackArithmetic {
    using Scalar = Number;
    using Pack = decltype(Lanes::v);

    static Pack zero() { return Lanes::all(Number(0)).v; }
    static Pack broadcast(Number value) { return Lanes::all(value).v; }
    static Pack add(Pack a, Pack b) { return (Lanes{a} + Lanes{b}).v; }
    static Pack multiply(Pack a, Pack b) { return (Lanes{a} * Lanes{b}).v; }
    static Pack multiply_add(Pack a, Pack b, Pack c) { return fma(Lanes{a}, Lanes{b}, Lanes{c}).v; }
};

template <class Lanes, class Scalar>
class BatchKernel {
  public:
    static void run(const ProgramView& program, const Scalar* coefficients, const BatchArrays<Scalar>& arrays,
                    unsigned long count) {
        const unsigned long full = count - count % Lanes::lanes;
        if (program.is_plain())
            run_leaf(program.leaves[0].scheme, coefficients, arrays, full);
        else
            run_program(program, coefficients, arrays, full);
        if (full < count) rest(program, coefficients, arrays, full, count);
    }

  private:
    using Arithmetic = PackArithmetic<Lanes, Scalar>;
    using Pack = typename Arithmetic::Pack;

    static Pack load(const Scalar* from) { return Lanes::load(from).v; }
    static void store(Scalar* to, const Pack& value) { Lanes{value}.store(to); }

    static void run_leaf(const SchemeView& scheme, const Scalar* coefficients,
                         const BatchArrays<Scalar>& arrays, unsigned long count) {
        for (unsigned long first = 0; first < count; first += Lanes::lanes)
            NestedHorner<Arithmetic>::for_each_of_jet(
                scheme, coefficients, load(arrays.point[0] + first), load(arrays.point[1] + first),
                load(arrays.point[2] + first),
                [&](int k, const Pack& value) { store(arrays.jet[k] + first, value); });
    }
    static void run_program(const ProgramView& program, const Scalar* coefficients,
                            const BatchArrays<Scalar>& arrays, unsigned long count) {
        for (unsigned long first = 0; first < count; first += Lanes::lanes) {
            Pack point[3];
            for (int i = 0; i < 3; ++i)
                point[i] = Arithmetic::add(load(arrays.point[i] + first),
                                           Arithmetic::broadcast(Scalar(program.shift[i])));
            Pack jet[jet_size];
            ProgramKernel<Arithmetic>::jet(program, coefficients, point, jet);
            for (int k = 0; k < jet_size; ++k) store(arrays.jet[k] + first, jet[k]);
        }
    }

    /// Fewer points than lanes: by way of full ones on the stack, the spare lanes at the origin.
    static void rest(const ProgramView& program, const Scalar* coefficients,
                     const BatchArrays<Scalar>& arrays, unsigned long first, unsigned long count) {
        Scalar buffer[3 + jet_size][Lanes::lanes] = {};
        for (int i = 0; i < 3; ++i)
            for (unsigned long k = first; k < count; ++k) buffer[i][k - first] = arrays.point[i][k];
        BatchArrays<Scalar> lanes;
        for (int i = 0; i < 3; ++i) lanes.point[i] = buffer[i];
        for (int i = 0; i < jet_size; ++i) lanes.jet[i] = buffer[3 + i];
        run(program, coefficients, lanes, Lanes::lanes);
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
