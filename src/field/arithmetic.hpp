/// \file
/// Arithmetic of one point at a time for the kernels that are templates of it.
#pragma once

namespace eliminant::field {

/// A number type with + and · as it is.
template <class Number>
struct PointArithmetic {
    using Scalar = Number;
    using Pack = Number;

    static Pack zero() { return Pack(0); }
    static Pack broadcast(const Scalar& value) { return value; }
    static Pack add(const Pack& a, const Pack& b) { return a + b; }
    static Pack multiply(const Pack& a, const Pack& b) { return a * b; }
    static Pack multiply_add(const Pack& a, const Pack& b, const Pack& c) { return a * b + c; }
};

} // namespace eliminant::field
