/// \file
/// Registers of 32 bytes.
#include "field/batch_units.hpp"

#include <immintrin.h>

namespace eliminant::field {

namespace {

struct Doubles {
    using Scalar = double;
    using Pack = __m256d;
    static constexpr int lanes = 4;

    static Pack zero() { return _mm256_setzero_pd(); }
    static Pack broadcast(double value) { return _mm256_set1_pd(value); }
    static Pack add(Pack a, Pack b) { return _mm256_add_pd(a, b); }
    static Pack multiply(Pack a, Pack b) { return _mm256_mul_pd(a, b); }
    static Pack multiply_add(Pack a, Pack b, Pack c) { return _mm256_fmadd_pd(a, b, c); }
    static Pack load(const double* from) { return _mm256_loadu_pd(from); }
    static void store(double* to, Pack value) { _mm256_storeu_pd(to, value); }
};

struct Floats {
    using Scalar = float;
    using Pack = __m256;
    static constexpr int lanes = 8;

    static Pack zero() { return _mm256_setzero_ps(); }
    static Pack broadcast(float value) { return _mm256_set1_ps(value); }
    static Pack add(Pack a, Pack b) { return _mm256_add_ps(a, b); }
    static Pack multiply(Pack a, Pack b) { return _mm256_mul_ps(a, b); }
    static Pack multiply_add(Pack a, Pack b, Pack c) { return _mm256_fmadd_ps(a, b, c); }
    static Pack load(const float* from) { return _mm256_loadu_ps(from); }
    static void store(float* to, Pack value) { _mm256_storeu_ps(to, value); }
};

} // namespace

void batch_avx2(const ProgramView& program, const double* coefficients, const BatchArrays<double>& arrays,
                unsigned long count) {
    BatchKernel<Doubles>::run(program, coefficients, arrays, count);
}

void batch_avx2(const ProgramView& program, const float* coefficients, const BatchArrays<float>& arrays,
                unsigned long count) {
    BatchKernel<Floats>::run(program, coefficients, arrays, count);
}

} // namespace eliminant::field
