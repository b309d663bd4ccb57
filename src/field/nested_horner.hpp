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
};

/// A polynomial in v and w; see NestedScheme.
struct SchemeRow {
    std::uint32_t first = 0;     ///< line of the highest power
    std::uint32_t count = 0;     ///< lines; 0 is the zero polynomial
    std::uint32_t constants = 0; ///< so many of them come first and have one slot each, which are contiguous
    bool v_before = false;       ///< an earlier row contains v
    bool w_before = false;       ///< an earlier row contains w
};

/// A NestedScheme as kernels see it.
struct SchemeView {
    const SchemeRow* rows;
    const SchemeRow* rows_end;
    const SchemeLine* lines;
    std::uint32_t constants;      ///< so many rows come first and have one slot each, which are contiguous
    std::uint32_t coordinates[3]; ///< which of x, y, z are u, v, w
    std::uint32_t powers[3];      ///< u is a power of that coordinate
    std::uint32_t
        components[jet_size]; ///< JetComponent of f; f_u, f_v, f_w; f_uu, f_uv, f_uw, f_vv, f_vw, f_ww
};

/// All is inlined in each kernel: a call would pass ten registers through memory, which takes as long as a
/// polynomial of degree 2.
template <class A>
class NestedHorner {
  public:
    using Pack = typename A::Pack;
    using Scalar = typename A::Scalar;

    /// Value and derivatives where the coordinates of levels 0, 1, 2 are p, q, r: `store(k, pack)` is called
    /// once for each k, which stands for the JetComponent scheme.components[k].
    template <class Store>
    [[gnu::always_inline]] static void for_each_of_jet(const SchemeView& scheme, const Scalar* coefficients,
                                                       const Pack& p, const Pack& q, const Pack& r,
                                                       const Store& store) {
        const Letter u = letter(scheme.powers[0], p);
        const Letter v = letter(scheme.powers[1], q);
        const Letter w = letter(scheme.powers[2], r);
        Sum sum = polynomial(scheme, coefficients, u.value, v.value, w.value);
        apply_chain_rule(scheme, sum, u, v, w);
        store(0, sum.f);
        store(1, sum.u);
        store(2, sum.v);
        store(3, sum.w);
        store(4, sum.uu);
        store(5, sum.uv);
        store(6, sum.uw);
        store(7, sum.vv);
        store(8, sum.vw);
        store(9, sum.ww);
    }

    /// The same into jet[jet_size].
    static void jet(const SchemeView& scheme, const Scalar* coefficients, const Pack* point, Pack* jet) {
        for_each_of_jet(scheme, coefficients, point[scheme.coordinates[0]], point[scheme.coordinates[1]],
                        point[scheme.coordinates[2]],
                        [&](int k, const Pack& value) { jet[scheme.components[k]] = value; });
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

    [[gnu::always_inline]] static Letter letter(std::uint32_t g, const Pack& x) {
        if (g == 1) return {x, A::zero(), A::zero()};
        if (g == 2) return {A::multiply(x, x), A::add(x, x), A::broadcast(Scalar(2))};
        Pack below = x; // x^(g−2)
        for (std::uint32_t i = 3; i < g; ++i) below = A::multiply(below, x);
        const Pack before = A::multiply(below, x);
        return {A::multiply(before, x), A::multiply(A::broadcast(Scalar(g)), before),
                A::multiply(A::broadcast(Scalar(g) * Scalar(g - 1)), below)};
    }

    /// Of count coefficients in descending powers of w, or of another letter.
    [[gnu::always_inline]] static LineSum line_sum(const Scalar* c, std::uint32_t count, const Pack& w) {
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

    /// Of a row in which v or w occurs.
    [[gnu::always_inline]] static RowSum row_sum(const SchemeView& scheme, const SchemeRow& row,
                                                 const Scalar* coefficients, const Pack& v, const Pack& w) {
        const SchemeLine* lines = scheme.lines + row.first;
        const Pack zero = A::zero();
        RowSum sum{zero, zero, zero, zero, zero, zero};
        std::uint32_t i = row.constants;
        if (i > 0) {
            const LineSum in_v = line_sum(coefficients + lines->first, i, v);
            sum.f = in_v.f;
            sum.v = in_v.w;
            sum.vv = in_v.ww;
        } else {
            const LineSum in_w = line_sum(coefficients + lines->first, lines->count, w);
            sum.f = in_w.f;
            sum.w = in_w.w;
            sum.ww = in_w.ww;
            i = 1;
        }
        for (; i < row.count; ++i) {
            const LineSum add = line_sum(coefficients + lines[i].first, lines[i].count, w);
            sum.vv = A::multiply_add(sum.vv, v, sum.v);
            sum.v = A::multiply_add(sum.v, v, sum.f);
            sum.f = A::multiply_add(sum.f, v, add.f);
            sum.vw = A::multiply_add(sum.vw, v, sum.w);
            sum.w = A::multiply_add(sum.w, v, add.w);
            sum.ww = A::multiply_add(sum.ww, v, add.ww);
        }
        return sum;
    }

    [[gnu::always_inline]] static Sum polynomial(const SchemeView& scheme, const Scalar* coefficients,
                                                 const Pack& u, const Pack& v, const Pack& w) {
        const Pack zero = A::zero();
        Sum sum{zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
        const SchemeRow* r = scheme.rows;
        if (scheme.constants > 0) {
            const LineSum in_u = line_sum(coefficients + scheme.lines[r->first].first, scheme.constants, u);
            sum.f = in_u.f;
            sum.u = in_u.w;
            sum.uu = in_u.ww;
            r += scheme.constants;
        }
        for (; r != scheme.rows_end; ++r) {
            const SchemeRow& row = *r;
            if (r != scheme.rows) step_derivatives(sum, row, u);
            if (row.count > row.constants || row.count > 1) {
                const RowSum add = row_sum(scheme, row, coefficients, v, w);
                sum.f = A::multiply_add(sum.f, u, add.f);
                if (!row.v_before && !row.w_before) { // these are still 0
                    sum.v = add.v;
                    sum.w = add.w;
                    sum.vv = add.vv;
                    sum.vw = add.vw;
                    sum.ww = add.ww;
                    continue;
                }
                sum.v = A::multiply_add(sum.v, u, add.v);
                sum.w = A::multiply_add(sum.w, u, add.w);
                sum.vv = A::multiply_add(sum.vv, u, add.vv);
                sum.vw = A::multiply_add(sum.vw, u, add.vw);
                sum.ww = A::multiply_add(sum.ww, u, add.ww);
                continue;
            }
            sum.f = A::multiply_add(
                sum.f, u, row.count == 0 ? zero : A::broadcast(coefficients[scheme.lines[row.first].first]));
            sum.v = A::multiply(sum.v, u);
            sum.w = A::multiply(sum.w, u);
            sum.vv = A::multiply(sum.vv, u);
            sum.vw = A::multiply(sum.vw, u);
            sum.ww = A::multiply(sum.ww, u);
        }
        return sum;
    }

    /// Horner's step for derivatives in u, before that of what they are derivatives of.
    [[gnu::always_inline]] static void step_derivatives(Sum& sum, const SchemeRow& row, const Pack& u) {
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
    [[gnu::always_inline]] static void apply_chain_rule(const SchemeView& scheme, Sum& sum, const Letter& u,
                                                        const Letter& v, const Letter& w) {
        pure(scheme.powers[0], u, sum.u, sum.uu);
        pure(scheme.powers[1], v, sum.v, sum.vv);
        pure(scheme.powers[2], w, sum.w, sum.ww);
        mixed(scheme.powers[0], u, sum.uv, sum.uw);
        mixed(scheme.powers[1], v, sum.uv, sum.vw);
        mixed(scheme.powers[2], w, sum.uw, sum.vw);
    }
};

} // namespace eliminant::field
