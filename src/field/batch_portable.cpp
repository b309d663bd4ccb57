/// \file
/// Registers of 16 bytes, which the base architectures x86-64 and arm64 both have.
#include "field/batch_units.hpp"

#include <cstring>

namespace eliminant::field {

namespace {

/// Vectors of the compilers' extension; on other machines they become scalars.
template <class Number>
struct PortableArithmetic {
    using Scalar = Number;
    using Pack [[gnu::vector_size(16)]] = Number;
    static constexpr int lanes = 16 / sizeof(Number);

    static Pack zero() { return Pack{}; }
    static Pack broadcast(Scalar value) { return Pack{} + value; }
    static Pack add(Pack a, Pack b) { return a + b; }
    static Pack multiply(Pack a, Pack b) { return a * b; }
    static Pack multiply_add(Pack a, Pack b, Pack c) { return a * b + c; }
    static Pack load(const Scalar* from) {
        Pack result;
        std::memcpy(&result, from, sizeof result);
        return result;
    }
    static void store(Scalar* to, Pack value) { std::memcpy(to, &value, sizeof value); }
};

} // namespace

void batch_portable(const ProgramView& program, const double* coefficients, const BatchArrays<double>& arrays,
                    unsigned long count) {
    BatchKernel<PortableArithmetic<double>>::run(program, coefficients, arrays, count);
}

void batch_portable(const ProgramView& program, const float* coefficients, const BatchArrays<float>& arrays,
                    unsigned long count) {
    BatchKernel<PortableArithmetic<float>>::run(program, coefficients, arrays, count);
}

} // namespace eliminant::field
