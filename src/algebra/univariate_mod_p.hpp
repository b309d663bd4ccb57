#pragma once

#include "galois_field.hpp"

#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/run.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Univariate polynomials over a finite field as dense vectors.
///
/// Coefficient i belongs to x^i, the last one is not zero, and 0 is the empty vector. Schoolbook methods:
/// they are the fastest up to degrees of several hundred, and the users here stay mostly below. Instantiated
/// for PrimeField and GaloisField.
namespace eliminant::algebra::dense {

using Element = std::uint32_t;
using Vector = std::vector<Element>;

/// Removes leading zeros.
inline void trim(Vector& f) {
    while (!f.empty() && f.back() == 0) f.pop_back();
}

/// Σ a[i]·b[i] over the length of a; b is at least as long. Inline, for most of them are short.
inline Element dot(const PrimeField& field, std::span<const Element> a, std::span<const Element> b) {
    // Four products of residues below 2^31 − 1 and one more residue fit in 64 bits.
    std::uint64_t sum = 0;
    std::size_t i = 0;
    for (; i + 4 < a.size(); i += 4) {
        sum += std::uint64_t{a[i]} * b[i] + std::uint64_t{a[i + 1]} * b[i + 1] +
               std::uint64_t{a[i + 2]} * b[i + 2] + std::uint64_t{a[i + 3]} * b[i + 3];
        sum = field.reduce(sum);
    }
    for (; i < a.size(); ++i) sum += std::uint64_t{a[i]} * b[i];
    return field.reduce(sum);
}
inline Element dot(const GaloisField& field, std::span<const Element> a, std::span<const Element> b) {
    Element sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum = field.add(sum, field.multiply(a[i], b[i]));
    return sum;
}

/// a += factor·b; a is at least as long as b.
template <class Field>
void add_multiple(const Field& field, std::span<Element> a, std::span<const Element> b, Element factor);

/// f(x) by Horner's rule.
template <class Field>
Element evaluate(const Field& field, std::span<const Element> f, Element x);

/// 1, x, …, x^(count−1).
template <class Field>
Vector powers(const Field& field, Element x, std::size_t count);

template <class Field>
Vector multiply(const Field& field, const Vector& a, const Vector& b);

/// Replaces a by its remainder modulo b and returns the quotient; b is not 0.
template <class Field>
Vector divide(const Field& field, Vector& a, const Vector& b);

/// Divided by its leading coefficient.
template <class Field>
void make_monic(const Field& field, Vector& f);

/// The monic gcd; gcd(0, 0) = 0. Polls once a remainder.
template <class Field>
Vector gcd(const Field& field, Vector a, Vector b, base::Run& run);

/// Replaces f by (x − root)·f, f not 0.
template <class Field>
void multiply_by_root(const Field& field, Vector& f, Element root);

/// The polynomial of degree below n with f(points[i]) = values[i]; the n points are distinct. Newton's
/// scheme.
template <class Field>
Vector interpolate(const Field& field, std::span<const Element> points, std::span<const Element> values);

} // namespace eliminant::algebra::dense
