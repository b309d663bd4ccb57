/// \file
/// Value, gradient and Hessian of sums, products and powers of polynomials, for any arithmetic.
///
/// For the same files as nested_horner.hpp: a template of the arithmetic, nothing of the standard library.
#pragma once

#include "field/nested_horner.hpp"

namespace eliminant::field {

/// One step on a stack of jets.
struct JetStep {
    enum Kind : unsigned char {
        leaf,     ///< pushes the jet of leaf `index`
        scale,    ///< multiplies the top by coefficient `index`
        add,      ///< replaces the two topmost jets by that of their sum
        multiply, ///< the same for the product
        to_power, ///< raises the top to the power `index` ≥ 2
    };
    Kind kind = leaf;
    std::uint32_t index = 0;
};

/// An expanded polynomial among the coefficients of a program.
struct ProgramLeaf {
    SchemeView scheme;
    std::uint32_t first; ///< place of its first coefficient
};

/// A JetProgram as kernels see it: either a single leaf, or steps.
struct ProgramView {
    const ProgramLeaf* leaves;
    const JetStep* steps;
    const JetStep* steps_end; ///< equal to steps for a single leaf
    double shift[3];          ///< is added to the points
    bool is_shifted;          ///< whether that changes anything

    bool is_plain() const { return steps == steps_end && !is_shifted; } ///< a leaf in the coordinates
};

inline constexpr int max_program_depth = 8; ///< of the stack

template <class A>
class ProgramKernel {
  public:
    using Pack = typename A::Pack;
    using Scalar = typename A::Scalar;

    /// At a point that has been shifted.
    static void jet(const ProgramView& program, const Scalar* coefficients, const Pack* point, Pack* jet) {
        if (program.steps == program.steps_end) {
            leaf_jet(program.leaves[0], coefficients, point, jet);
            return;
        }
        Pack stack[max_program_depth][jet_size];
        int depth = 0;
        for (const JetStep* step = program.steps; step != program.steps_end; ++step) {
            Pack* top = stack[depth > 0 ? depth - 1 : 0];
            switch (step->kind) {
            case JetStep::leaf:
                leaf_jet(program.leaves[step->index], coefficients, point, stack[depth++]);
                break;
            case JetStep::scale:
                scale(top, A::broadcast(coefficients[step->index]));
                break;
            case JetStep::add:
                add(stack[--depth - 1], top);
                break;
            case JetStep::multiply:
                multiply(stack[--depth - 1], top);
                break;
            case JetStep::to_power:
                raise(top, step->index);
                break;
            }
        }
        for (int k = 0; k < jet_size; ++k) jet[k] = stack[0][k];
    }

    /// The value alone.
    static Pack value(const ProgramView& program, const Scalar* coefficients, const Pack* point) {
        if (program.steps == program.steps_end) return leaf_value(program.leaves[0], coefficients, point);
        Pack stack[max_program_depth];
        int depth = 0;
        for (const JetStep* step = program.steps; step != program.steps_end; ++step) {
            Pack& top = stack[depth > 0 ? depth - 1 : 0];
            switch (step->kind) {
            case JetStep::leaf:
                stack[depth++] = leaf_value(program.leaves[step->index], coefficients, point);
                break;
            case JetStep::scale:
                top = A::multiply(top, A::broadcast(coefficients[step->index]));
                break;
            case JetStep::add:
                --depth;
                stack[depth - 1] = A::add(stack[depth - 1], top);
                break;
            case JetStep::multiply:
                --depth;
                stack[depth - 1] = A::multiply(stack[depth - 1], top);
                break;
            case JetStep::to_power:
                top = A::multiply(A::multiply(power(top, step->index - 2), top), top);
                break;
            }
        }
        return stack[0];
    }

  private:
    static void leaf_jet(const ProgramLeaf& leaf, const Scalar* coefficients, const Pack* point, Pack* jet) {
        NestedHorner<A>::jet(leaf.scheme, coefficients + leaf.first, point, jet);
    }
    static Pack leaf_value(const ProgramLeaf& leaf, const Scalar* coefficients, const Pack* point) {
        return NestedHorner<A>::value(leaf.scheme, coefficients + leaf.first, point);
    }

    /// Calls body(ij, i, j) for the second derivative ij by the first derivatives i and j.
    template <class Body>
    static void for_each_second(const Body& body) {
        body(at_xx, at_x, at_x);
        body(at_xy, at_x, at_y);
        body(at_xz, at_x, at_z);
        body(at_yy, at_y, at_y);
        body(at_yz, at_y, at_z);
        body(at_zz, at_z, at_z);
    }

    static void scale(Pack* a, const Pack& factor) {
        for (int k = 0; k < jet_size; ++k) a[k] = A::multiply(a[k], factor);
    }
    static void add(Pack* a, const Pack* b) {
        for (int k = 0; k < jet_size; ++k) a[k] = A::add(a[k], b[k]);
    }
    static void multiply(Pack* a, const Pack* b) {
        for_each_second([&](int ij, int i, int j) {
            const Pack mixed = A::multiply_add(a[i], b[j], A::multiply(a[j], b[i]));
            a[ij] = A::multiply_add(a[ij], b[0], A::multiply_add(a[0], b[ij], mixed));
        });
        for (int i = at_x; i <= at_z; ++i) a[i] = A::multiply_add(a[i], b[0], A::multiply(a[0], b[i]));
        a[0] = A::multiply(a[0], b[0]);
    }

    /// base^exponent by squaring.
    static Pack power(Pack base, std::uint32_t exponent) {
        Pack result = A::broadcast(Scalar(1));
        for (; exponent > 0; exponent /= 2) {
            if (exponent % 2 == 1) result = A::multiply(result, base);
            if (exponent > 1) base = A::multiply(base, base);
        }
        return result;
    }
    static void raise(Pack* a, std::uint32_t exponent) {
        const Pack below = power(a[0], exponent - 2);
        const Pack before = A::multiply(below, a[0]);
        const Pack first = A::multiply(before, A::broadcast(Scalar(exponent)));
        const Pack second = A::multiply(below, A::broadcast(Scalar(exponent) * Scalar(exponent - 1)));
        const Pack by[3] = {A::multiply(second, a[at_x]), A::multiply(second, a[at_y]),
                            A::multiply(second, a[at_z])};
        for_each_second([&](int ij, int i, int j) {
            a[ij] = A::multiply_add(a[ij], first, A::multiply(by[i - at_x], a[j]));
        });
        for (int i = at_x; i <= at_z; ++i) a[i] = A::multiply(a[i], first);
        a[0] = A::multiply(before, a[0]);
    }
};

} // namespace eliminant::field
