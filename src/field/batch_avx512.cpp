/// \file
/// Pairs of registers of 64 bytes: two chains of dependent multiply-adds at a time, and all partial sums of a
/// row still fit the 32 registers.
#include "field/batch_units.hpp"

#include <immintrin.h>

namespace eliminant::field {

namespace {

struct Doubles {
    using Scalar = double;
    struct Pack {
        __m512d a, b;
    };
    static constexpr int lanes = 16;

    static Pack zero() { return {_mm512_setzero_pd(), _mm512_setzero_pd()}; }
    static Pack broadcast(double value) { return {_mm512_set1_pd(value), _mm512_set1_pd(value)}; }
    static Pack add(Pack x, Pack y) { return {_mm512_add_pd(x.a, y.a), _mm512_add_pd(x.b, y.b)}; }
    static Pack multiply(Pack x, Pack y) { return {_mm512_mul_pd(x.a, y.a), _mm512_mul_pd(x.b, y.b)}; }
    static Pack multiply_add(Pack x, Pack y, Pack z) {
        return {_mm512_fmadd_pd(x.a, y.a, z.a), _mm512_fmadd_pd(x.b, y.b, z.b)};
    }
    static Pack load(const double* from) { return {_mm512_loadu_pd(from), _mm512_loadu_pd(from + 8)}; }
    static void store(double* to, Pack value) {
        _mm512_storeu_pd(to, value.a);
        _mm512_storeu_pd(to + 8, value.b);
    }
};

struct Floats {
    using Scalar = float;
    struct Pack {
        __m512 a, b;
    };
    static constexpr int lanes = 32;

    static Pack zero() { return {_mm512_setzero_ps(), _mm512_setzero_ps()}; }
    static Pack broadcast(float value) { return {_mm512_set1_ps(value), _mm512_set1_ps(value)}; }
    static Pack add(Pack x, Pack y) { return {_mm512_add_ps(x.a, y.a), _mm512_add_ps(x.b, y.b)}; }
    static Pack multiply(Pack x, Pack y) { return {_mm512_mul_ps(x.a, y.a), _mm512_mul_ps(x.b, y.b)}; }
    static Pack multiply_add(Pack x, Pack y, Pack z) {
        return {_mm512_fmadd_ps(x.a, y.a, z.a), _mm512_fmadd_ps(x.b, y.b, z.b)};
    }
    static Pack load(const float* from) { return {_mm512_loadu_ps(from), _mm512_loadu_ps(from + 16)}; }
    static void store(float* to, Pack value) {
        _mm512_storeu_ps(to, value.a);
        _mm512_storeu_ps(to + 16, value.b);
    }
};

} // namespace

void batch_avx512(const SchemeView& scheme, const double* coefficients, const BatchArrays<double>& arrays,
                  unsigned long count) {
    BatchKernel<Doubles>::run(scheme, coefficients, arrays, count);
}

void batch_avx512(const SchemeView& scheme, const float* coefficients, const BatchArrays<float>& arrays,
                  unsigned long count) {
    BatchKernel<Floats>::run(scheme, coefficients, arrays, count);
}

} // namespace eliminant::field
