#pragma once

#include "eliminant/algebra/integer.hpp"
#include "eliminant/algebra/prime_field.hpp"

#include <cstdint>
#include <utility>

namespace eliminant::algebra {

/// Coefficient arithmetic of the term kernels, one type per kind of coefficient, so that a kernel is written
/// once and compiled for each. ℤ stands for ℚ: kernels work on numerators over a common denominator.
struct IntegerDomain {
    using Element = Integer;
    static constexpr bool is_field = false;

    static bool is_zero(const Integer& a) { return a.is_zero(); }
    static bool is_one(const Integer& a) { return a.is_one(); }
    static Integer one() { return {1}; }
    static Integer negate(const Integer& a) { return -a; }
    static Integer multiply(const Integer& a, const Integer& b) { return a * b; }
    static void add_to(Integer& a, const Integer& b) { a += b; }
    static void subtract_from(Integer& a, const Integer& b) { a -= b; }
    static void add_product(Integer& sum, const Integer& a, const Integer& b) { sum.add_product(a, b); }
    static void subtract_product(Integer& sum, const Integer& a, const Integer& b) {
        sum.subtract_product(a, b);
    }
};

struct PrimeDomain {
    using Element = PrimeField::Element;
    static constexpr bool is_field = true;

    PrimeField field;

    static bool is_zero(Element a) { return a == 0; }
    static bool is_one(Element a) { return a == 1; }
    static Element one() { return 1; }
    Element negate(Element a) const { return field.negate(a); }
    Element multiply(Element a, Element b) const { return field.multiply(a, b); }
    void add_to(Element& a, Element b) const { a = field.add(a, b); }
    void subtract_from(Element& a, Element b) const { a = field.subtract(a, b); }
    void add_product(Element& sum, Element a, Element b) const {
        sum = field.reduce(sum + static_cast<std::uint64_t>(a) * b);
    }
    void subtract_product(Element& sum, Element a, Element b) const { add_product(sum, field.negate(a), b); }
};

} // namespace eliminant::algebra
