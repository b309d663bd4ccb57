/// \file
/// Horner's scheme in three variables with first and second derivatives, for any arithmetic.
///
/// Everything is a template of the arithmetic A, and nothing of the standard library is used: files for one
/// instruction set instantiate it for a type of their own, so that no function of theirs is shared with files
/// for another one. A has
/// - Scalar, the type of coefficients, and Pack, of one or several points;
/// - zero(), broadcast(Scalar), add(a, b), multiply(a, b), multiply_add(a, b, c) = a·b + c.
#pragma once

#include <cstdint>

namespace eliminant::field {

/// Positions of value, gradient and Hessian in an array of ten.
enum JetComponent : unsigned char { at_value, at_x, at_y, at_z, at_xx, at_xy, at_xz, at_yy, at_yz, at_zz };
inline constexpr int jet_size = 10;

/// A polynomial in w; see NestedScheme.
struct SchemeLine {
    std::uint32_t first = 0; ///< slot of the highest power
    std::uint32_t count = 0; ///< slots; 0 is the zero polynomial
    bool w_before = false;   ///< an earlier line of this row contains w
};

/// A polynomial in v and w; see NestedScheme.
struct SchemeRow {
    std::uint32_t first = 0; ///< line of the highest power
    std::uint32_t count = 0; ///< lines; 0 is the zero polynomial
    bool v_before = false;   ///< an earlier row contains v
    bool w_before = false;   ///< an earlier row contains w
};

/// A NestedScheme as kernels see it.
struct SchemeView {
    const SchemeRow* rows;
    const SchemeRow* rows_end;
    const SchemeLine* lines;
    std::uint32_t coordinates[3]; ///< which of x, y, z are u, v, w
    std::uint32_t powers[3];      ///< u is a power of that coordinate
    std::uint32_t
        components[jet_size]; ///< JetComponent of f; f_u, f_v, f_w; f_uu, f_uv, f_uw, f_vv, f_vw, f_ww
};

template <class A>
class NestedHorner {
  public:
    using Pack = typename A::Pack;
    using Scalar = typename A::Scalar;

    /// Value and derivatives at the point (x, y, z): `store(component, pack)` is called once for each
    /// JetComponent.
    template <class Store>
    static void for_each_of_jet(const SchemeView& scheme, const Scalar* coefficients, const Pack* point,
                                const Store& store) {
        const Letter u = letter(scheme, 0, point);
        const Letter v = letter(scheme, 1, point);
        const Letter w = letter(scheme, 2, point);
        Sum sum = polynomial(scheme, coefficients, u.value, v.value, w.value);
        apply_chain_rule(scheme, sum, u, v, w);
        store(scheme.components[0], sum.f);
        store(scheme.components[1], sum.u);
        store(scheme.components[2], sum.v);
        store(scheme.components[3], sum.w);
        store(scheme.components[4], sum.uu);
        store(scheme.components[5], sum.uv);
        store(scheme.components[6], sum.uw);
        store(scheme.components[7], sum.vv);
        store(scheme.components[8], sum.vw);
        store(scheme.components[9], sum.ww);
    }

    /// The same into jet[jet_size].
    static void jet(const SchemeView& scheme, const Scalar* coefficients, const Pack* point, Pack* jet) {
        for_each_of_jet(scheme, coefficients, point,
                        [jet](std::uint32_t component, const Pack& value) { jet[component] = value; });
    }

    /// The value alone.
    static Pack value(const SchemeView& scheme, const Scalar* coefficients, const Pack* point) {
        const Pack u = power(scheme, 0, point);
        const Pack v = power(scheme, 1, point);
        const Pack w = power(scheme, 2, point);
        Pack sum = A::zero();
        for (const SchemeRow* r = scheme.rows; r != scheme.rows_end; ++r) {
            const SchemeRow& row = *r;
            Pack row_sum = A::zero();
            for (std::uint32_t i = 0; i < row.count; ++i) {
                const SchemeLine& line = scheme.lines[row.first + i];
                Pack line_sum = A::zero();
                for (std::uint32_t k = 0; k < line.count; ++k)
                    line_sum = A::multiply_add(line_sum, w, A::broadcast(coefficients[line.first + k]));
                row_sum = A::multiply_add(row_sum, v, line_sum);
            }
            sum = A::multiply_add(sum, u, row_sum);
        }
        return sum;
    }

  private:
    // Second derivatives are halved throughout: Horner's recurrence for f'' / 2 is h = h·x + f', the same
    // step as those of f' and f.
    struct LineSum {
        Pack f, w, ww;
    };
    struct RowSum {
        Pack f, v, w, vv, vw, ww;
    };
    struct Sum {
        Pack f, u, v, w, uu, uv, uw, vv, vw, ww;
    };
    /// What stands for u: x^g with its derivatives; only the value if g = 1.
    struct Letter {
        Pack value, first, second;
    };

    static Pack power(const SchemeView& scheme, int level, const Pack* point) {
        const Pack& x = point[scheme.coordinates[level]];
        Pack result = x;
        for (std::uint32_t i = 1; i < scheme.powers[level]; ++i) result = A::multiply(result, x);
        return result;
    }

    static Letter letter(const SchemeView& scheme, int level, const Pack* point) {
        const Pack& x = point[scheme.coordinates[level]];
        const std::uint32_t g = scheme.powers[level];
        if (g == 1) return {x, A::zero(), A::zero()};
        Pack below = A::broadcast(Scalar(1)); // x^(g−2)
        for (std::uint32_t i = 2; i < g; ++i) below = A::multiply(below, x);
        const Pack before = A::multiply(below, x);
        return {A::multiply(before, x), A::multiply(A::broadcast(Scalar(g)), before),
                A::multiply(A::broadcast(Scalar(g) * Scalar(g - 1)), below)};
    }

    static LineSum line_sum(const Scalar* c, std::uint32_t count, const Pack& w) {
        if (count == 0) return {A::zero(), A::zero(), A::zero()};
        LineSum sum{A::broadcast(c[0]), A::zero(), A::zero()};
        if (count == 1) return sum;
        sum.w = sum.f;
        sum.f = A::multiply_add(sum.f, w, A::broadcast(c[1]));
        if (count == 2) return sum;
        sum.ww = sum.w;
        sum.w = A::multiply_add(sum.w, w, sum.f);
        sum.f = A::multiply_add(sum.f, w, A::broadcast(c[2]));
        for (std::uint32_t k = 3; k < count; ++k) {
            sum.ww = A::multiply_add(sum.ww, w, sum.w);
            sum.w = A::multiply_add(sum.w, w, sum.f);
            sum.f = A::multiply_add(sum.f, w, A::broadcast(c[k]));
        }
        return sum;
    }

    static RowSum row_sum(const SchemeLine* lines, std::uint32_t count, const Scalar* coefficients,
                          const Pack& v, const Pack& w) {
        const LineSum first = line_sum(coefficients + lines[0].first, lines[0].count, w);
        RowSum sum{first.f, A::zero(), first.w, A::zero(), A::zero(), first.ww};
        for (std::uint32_t i = 1; i < count; ++i) {
            const SchemeLine& line = lines[i];
            const Scalar* c = coefficients + line.first;
            sum.vv = A::multiply_add(sum.vv, v, sum.v);
            sum.v = A::multiply_add(sum.v, v, sum.f);
            if (line.count < 2 && !line.w_before) {
                sum.f = A::multiply_add(sum.f, v, line.count == 0 ? A::zero() : A::broadcast(c[0]));
                continue;
            }
            const LineSum add = line_sum(c, line.count, w);
            sum.f = A::multiply_add(sum.f, v, add.f);
            sum.vw = A::multiply_add(sum.vw, v, sum.w);
            sum.w = A::multiply_add(sum.w, v, add.w);
            sum.ww = A::multiply_add(sum.ww, v, add.ww);
        }
        return sum;
    }

    static Sum polynomial(const SchemeView& scheme, const Scalar* coefficients, const Pack& u, const Pack& v,
                          const Pack& w) {
        const Pack zero = A::zero();
        Sum sum{zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
        for (const SchemeRow* r = scheme.rows; r != scheme.rows_end; ++r) {
            const SchemeRow& row = *r;
            if (r != scheme.rows) step_derivatives(sum, row, u);
            const SchemeLine* lines = scheme.lines + row.first;
            if (row.count > 1) {
                const RowSum add = row_sum(lines, row.count, coefficients, v, w);
                sum.f = A::multiply_add(sum.f, u, add.f);
                sum.v = A::multiply_add(sum.v, u, add.v);
                sum.w = A::multiply_add(sum.w, u, add.w);
                sum.vv = A::multiply_add(sum.vv, u, add.vv);
                sum.vw = A::multiply_add(sum.vw, u, add.vw);
                sum.ww = A::multiply_add(sum.ww, u, add.ww);
                continue;
            }
            if (row.v_before) {
                sum.v = A::multiply(sum.v, u);
                sum.vv = A::multiply(sum.vv, u);
                if (row.w_before) sum.vw = A::multiply(sum.vw, u);
            }
            if (row.count == 1 && lines->count > 1) {
                const LineSum add = line_sum(coefficients + lines->first, lines->count, w);
                sum.f = A::multiply_add(sum.f, u, add.f);
                sum.w = A::multiply_add(sum.w, u, add.w);
                sum.ww = A::multiply_add(sum.ww, u, add.ww);
                continue;
            }
            if (row.w_before) {
                sum.w = A::multiply(sum.w, u);
                sum.ww = A::multiply(sum.ww, u);
            }
            sum.f =
                A::multiply_add(sum.f, u, row.count == 0 ? zero : A::broadcast(coefficients[lines->first]));
        }
        return sum;
    }

    /// Horner's step for derivatives in u, before that of what they are derivatives of.
    static void step_derivatives(Sum& sum, const SchemeRow& row, const Pack& u) {
        sum.uu = A::multiply_add(sum.uu, u, sum.u);
        sum.u = A::multiply_add(sum.u, u, sum.f);
        if (row.v_before) sum.uv = A::multiply_add(sum.uv, u, sum.v);
        if (row.w_before) sum.uw = A::multiply_add(sum.uw, u, sum.w);
    }

    /// ∂²/∂x² from ½ ∂²/∂t², and ∂/∂x from ∂/∂t, for t = x^g.
    static void pure(std::uint32_t g, const Letter& t, Pack& first, Pack& second) {
        second = A::add(second, second);
        if (g == 1) return;
        second = A::multiply_add(A::multiply(second, t.first), t.first, A::multiply(first, t.second));
        first = A::multiply(first, t.first);
    }

    static void mixed(std::uint32_t g, const Letter& t, Pack& one, Pack& other) {
        if (g == 1) return;
        one = A::multiply(one, t.first);
        other = A::multiply(other, t.first);
    }

    /// From derivatives in u, v, w to those in coordinates of which they are powers.
    static void apply_chain_rule(const SchemeView& scheme, Sum& sum, const Letter& u, const Letter& v,
                                 const Letter& w) {
        pure(scheme.powers[0], u, sum.u, sum.uu);
        pure(scheme.powers[1], v, sum.v, sum.vv);
        pure(scheme.powers[2], w, sum.w, sum.ww);
        mixed(scheme.powers[0], u, sum.uv, sum.uw);
        mixed(scheme.powers[1], v, sum.uv, sum.vw);
        mixed(scheme.powers[2], w, sum.uw, sum.vw);
    }
};

} // namespace eliminant::field
