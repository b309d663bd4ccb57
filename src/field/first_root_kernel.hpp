#pragma once

#include "first_root.hpp"

#include <cstddef>
#include <utility>

// Inlined for each index of an unrolled loop, so that the index is a constant.
#define ELIMINANT_INLINE __attribute__((always_inline))

/// The first root of one polynomial a lane, in lockstep. A Pack is base::Doubles (base/pack.hpp) of some
/// vector unit, or one number of more precision. In an unnamed namespace, so that no instance is shared
/// between instruction sets.
///
/// Every lane walks along its own interval [lower, upper]. On the piece before it, the polynomial is expanded
/// about the middle, changed to the Bernstein basis, and asked for its sign changes (Descartes' rule):
///
///     none         no root there: the next piece is twice as long
///     one          exactly one root, and a simple one: done, up to Newton's method
///     otherwise    half the piece
///
/// A coefficient counts as signed only when it exceeds the error bound, so these statements hold for the
/// exact polynomial. A lane whose pieces become too short is undecided and left to more precise arithmetic.
namespace eliminant::field {
namespace {

/// How far the search goes down in arithmetic of 53 bits.
struct DoubleLimits {
    static constexpr int most_pieces = 48;
    static constexpr double shortest_piece = 0x1p-22;
};

template <class Pack, int fixed_degree, class Limits = DoubleLimits>
class FirstRoot {
    using Mask = typename Pack::Mask;

  public:
    static constexpr int capacity = fixed_degree > 0 ? fixed_degree : static_cast<int>(max_kernel_degree);

    struct Answer {
        Pack root;
        Pack start; ///< a value with the sign that the polynomial has at `lower`, where `known`
        Mask known;
        Mask found;
        Mask undecided;
        int steps;
    };

    /// \param error bounds the sum of the errors of a polynomial's coefficients, and all roundings here
    FirstRoot(int degree, const double* bernstein, double error)
        : FirstRoot(degree, bernstein, Pack::all(error)) {}
    /// The same with a bound for each lane.
    FirstRoot(int degree, const double* bernstein, Pack error)
        : degree_(degree), bernstein_(bernstein), error_(error) {}

    int degree() const { return fixed_degree > 0 ? fixed_degree : degree_; }

    /// body(0), …, body(count − 1), for count ≤ degree() + 1. Unrolled for a fixed degree, where the whole
    /// polynomial then lives in registers.
    template <class Body>
    ELIMINANT_INLINE static void repeat(int count, const Body& body) {
        if constexpr (fixed_degree > 0) {
            [&]<int... i>(std::integer_sequence<int, i...>) ELIMINANT_INLINE {
                ((i < count ? body(i) : void()), ...);
            }
            (std::make_integer_sequence<int, fixed_degree + 1>{});
        } else {
            for (int i = 0; i < count; ++i) body(i);
        }
    }

    ELIMINANT_INLINE void value_and_slope(const Pack* c, Pack x, Pack& value, Pack& slope) const {
        const int n = degree();
        Pack p = c[n];
        Pack dp = Pack::all(0.0);
        repeat(n, [&](int i) ELIMINANT_INLINE {
            dp = fma(dp, x, p);
            p = fma(p, x, c[n - 1 - i]);
        });
        value = p;
        slope = dp;
    }

    /// Lanes with lower > upper have no root.
    Answer find(const Pack* c, Pack lower, Pack upper) const {
        const Pack half = Pack::all(0.5);
        // A radius slightly too large closes the gaps that rounding leaves between neighbouring pieces.
        const Pack overlap = Pack::all(1.0 + 0x1p-50);
        const Pack margin = Pack::all(0x1p-52);
        const Pack shortest = Pack::all(Limits::shortest_piece);
        Mask walking = ~(lower > upper);
        Pack left = lower;
        Pack right = upper;
        Bracket bracket{lower, upper, lower, upper};
        Answer answer{lower, Pack::all(0.0), Pack::nowhere(), Pack::nowhere(), Pack::nowhere(), 0};
        for (; answer.steps < Limits::most_pieces && any(walking); ++answer.steps) {
            const Pack middle = (left + right) * half;
            const Pack radius = fma((right - left) * half, overlap, margin);
            const Signs signs = signs_on(c, middle, radius);
            if (answer.steps == 0) {
                answer.start = signs.first;
                answer.known = abs(signs.first) > error_;
            }
            const Mask isolated = walking & signs.one_change;
            answer.found = answer.found | isolated;
            bracket.left = select(isolated, middle - radius, bracket.left);
            bracket.right = select(isolated, middle + radius, bracket.right);
            bracket.left_value = select(isolated, signs.first, bracket.left_value);
            bracket.right_value = select(isolated, signs.last, bracket.right_value);
            walking = walking & ~isolated;

            const Mask passed = walking & signs.none;
            const Mask finished = passed & ~(upper > right);
            walking = walking & ~finished;
            const Mask halve = walking & ~passed;
            const Mask stuck = halve & (shortest > radius);
            answer.undecided = answer.undecided | stuck;
            walking = walking & ~stuck;
            const Pack next = min(upper, fma(right - left, Pack::all(2.0), right));
            left = select(passed, right, left);
            right = select(passed, next, select(halve, middle, right));
        }
        answer.undecided = answer.undecided | walking;
        if (any(answer.found)) refine(c, bracket, answer);
        return answer;
    }

    struct Existence {
        Mask found;     ///< there is a root
        Mask undecided; ///< of the others
    };

    /// Whether there is any root: over as soon as the values at the ends of a piece have different signs.
    ///
    /// Pieces end up to 2^-49 beyond the interval. A root out there is not taken for one inside if the error
    /// bound covers by how much the value may change on the way: `overhang(degree)` times the sum of the
    /// coefficients' absolute values.
    Existence exists(const Pack* c, Pack lower, Pack upper) const {
        const Pack half = Pack::all(0.5);
        const Pack overlap = Pack::all(1.0 + 0x1p-50);
        const Pack margin = Pack::all(0x1p-52);
        const Pack shortest = Pack::all(Limits::shortest_piece);
        Mask walking = ~(lower > upper);
        Pack left = lower;
        Pack right = upper;
        Existence answer{Pack::nowhere(), Pack::nowhere()};
        for (int steps = 0; steps < Limits::most_pieces && any(walking); ++steps) {
            const Pack middle = (left + right) * half;
            const Pack radius = fma((right - left) * half, overlap, margin);
            const Signs signs = signs_on(c, middle, radius);
            const Mask differ = (abs(signs.first) > error_) & (abs(signs.last) > error_) &
                                Pack::opposite(signs.first, signs.last);
            answer.found = answer.found | (walking & differ);
            walking = walking & ~differ;
            const Mask passed = walking & signs.none;
            walking = walking & ~(passed & ~(upper > right));
            const Mask halve = walking & ~passed;
            // No shorter piece makes a value certain that is not so where the piece begins.
            const Mask stuck = halve & ((shortest > radius) | ~(abs(signs.first) > error_));
            answer.undecided = answer.undecided | stuck;
            walking = walking & ~stuck;
            const Pack next = min(upper, fma(right - left, Pack::all(2.0), right));
            left = select(passed, right, left);
            right = select(passed, next, select(halve, middle, right));
        }
        answer.undecided = answer.undecided | walking;
        return answer;
    }
    static double overhang(int degree) { return degree * 0x1p-48; }

  private:
    struct Bracket {
        Pack left, right;             ///< ends of a piece with one root
        Pack left_value, right_value; ///< of opposite signs
    };
    struct Signs {
        Mask none;       ///< all certain and equal
        Mask one_change; ///< all certain, one change
        Pack first, last;
    };

    /// Of the polynomial on middle ± radius, the signs of the Bernstein coefficients.
    Signs signs_on(const Pack* c, Pack middle, Pack radius) const {
        const int n = degree();
        Pack q[capacity + 1];
        repeat(n + 1, [&](int i) ELIMINANT_INLINE { q[i] = c[i]; });
        repeat(n, [&](int i) ELIMINANT_INLINE {
            repeat(n - i,
                   [&](int j) ELIMINANT_INLINE { q[n - 1 - j] = fma(q[n - j], middle, q[n - 1 - j]); });
        });
        Pack power = radius;
        repeat(n, [&](int i) ELIMINANT_INLINE {
            q[i + 1] = q[i + 1] * power;
            power = power * radius;
        });
        // b[j] is the coefficient of B_j times binomial(n, j). Even and odd powers apart: they contribute to
        // B_j and B_(n−j) alike, but for the sign.
        Pack b[capacity + 1];
        repeat(n / 2 + 1, [&](int j) ELIMINANT_INLINE {
            const double* const matrix = bernstein_ + j;
            const std::ptrdiff_t row = n + 1;
            Pack even = q[0] * Pack::all(matrix[0]);
            Pack odd = n > 0 ? q[1] * Pack::all(matrix[row]) : Pack::all(0.0);
            repeat(n / 2, [&](int i) ELIMINANT_INLINE {
                even = fma(q[2 * i + 2], Pack::all(matrix[(2 * i + 2) * row]), even);
            });
            repeat((n - 1) / 2, [&](int i) ELIMINANT_INLINE {
                odd = fma(q[2 * i + 3], Pack::all(matrix[(2 * i + 3) * row]), odd);
            });
            b[n - j] = even - odd;
            b[j] = even + odd;
        });
        Mask certain = abs(b[0]) > error_;
        Mask changed = Pack::nowhere();
        Mask changed_twice = Pack::nowhere();
        repeat(n, [&](int j) ELIMINANT_INLINE {
            certain = certain & (abs(b[j + 1]) > error_ * Pack::all(bernstein_[j + 1])); // row 0: binomials
            const Mask change = Pack::opposite(b[j], b[j + 1]);
            changed_twice = changed_twice | (changed & change);
            changed = changed | change;
        });
        return {certain & ~changed, certain & changed & ~changed_twice, b[0], b[n]};
    }

    /// Newton's method, kept in the bracket by bisection. A lane without certain sign change close to its
    /// result becomes undecided.
    void refine(const Pack* c, const Bracket& bracket, Answer& answer) const {
        Pack left = bracket.left;
        Pack right = bracket.right;
        const Pack left_value = bracket.left_value;
        Pack x = left - (right - left) * (left_value / (bracket.right_value - left_value));
        const Pack half = Pack::all(0.5);
        const Pack small = Pack::all(0x1p-46);
        Pack value = left_value;
        Pack slope = left_value;
        Mask moving = answer.found;
        constexpr int most_steps = 60; // bisection alone needs fewer
        for (int i = 0; i < most_steps && any(moving); ++i, ++answer.steps) {
            const Mask outside = moving & ~((x > left) & (right > x));
            x = select(outside, (left + right) * half, x);
            value_and_slope(c, x, value, slope);
            const Mask before = ~Pack::opposite(value, left_value);
            left = select(before, x, left);
            right = select(before, right, x);
            const Pack step = value / slope;
            moving = moving & (abs(step) > small) & ((right - left) > small);
            x = select(moving, x - step, x);
        }
        value_and_slope(c, x, value, slope);
        x = select(slope == Pack::all(0.0), x, x - value / slope);
        const Pack reach = fma(error_ / abs(slope), Pack::all(4.0), Pack::all(0x1p-49));
        Pack ahead = value;
        Pack behind = value;
        value_and_slope(c, x - reach, behind, slope);
        value_and_slope(c, x + reach, ahead, slope);
        const Mask sure = (abs(behind) > error_) & (abs(ahead) > error_) & Pack::opposite(behind, ahead) &
                          ~Pack::opposite(behind, left_value) & (Pack::all(root_precision) > reach) &
                          ~(bracket.left > x) & ~(x > bracket.right);
        answer.undecided = answer.undecided | (answer.found & ~sure);
        answer.found = answer.found & sure;
        answer.root = x;
    }

    int degree_;
    const double* bernstein_;
    Pack error_;
};

/// visit(std::integral_constant<int, n>) for the degrees that are unrolled, and n = 0 for all others.
template <class Visitor>
void with_fixed_degree(std::size_t degree, const Visitor& visit) {
    switch (degree) {
    case 1:
        return visit(std::integral_constant<int, 1>{});
    case 2:
        return visit(std::integral_constant<int, 2>{});
    case 3:
        return visit(std::integral_constant<int, 3>{});
    case 4:
        return visit(std::integral_constant<int, 4>{});
    case 5:
        return visit(std::integral_constant<int, 5>{});
    case 6:
        return visit(std::integral_constant<int, 6>{});
    case 7:
        return visit(std::integral_constant<int, 7>{});
    case 8:
        return visit(std::integral_constant<int, 8>{});
    default:
        return visit(std::integral_constant<int, 0>{});
    }
}

} // namespace
} // namespace eliminant::field
