/// \file
/// Control nets: curves and surfaces in Bernstein and B-spline form, as modellers store them.
#pragma once

#include "eliminant/implicit/parametrization.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <string>
#include <vector>

namespace eliminant::implicit {

/// A Bézier or B-spline curve (one direction) or tensor product surface (two directions), or a triangular
/// Bézier patch, exact.
struct ControlNet {
    /// Degrees and knots in one parameter. Without knots a Bernstein basis: degree + 1 control points.
    /// Otherwise there are knots.size() − degree − 1 of them.
    struct Direction {
        std::size_t degree;
        std::vector<mpq_class> knots = {};

        bool is_spline() const { return !knots.empty(); }
        std::size_t point_count() const { return is_spline() ? knots.size() - degree - 1 : degree + 1; }
    };

    /// One or two; a triangular patch has one, of its degree and without knots.
    std::vector<Direction> directions;
    std::vector<std::string> coordinates; ///< their names
    /// Whether each point ends with a weight w: the shape is Σ wᵢBᵢPᵢ / Σ wᵢBᵢ, with points as they are seen,
    /// not multiplied by their weights.
    bool is_rational = false;
    /// One row a control point, in the sequence of the last direction first: P₀₀, P₀₁, …, P₁₀, …. Of a
    /// triangular patch of degree n those with i + j ≤ n: it is Σ n!/(i! j! k!)·sⁱ·tʲ·(1−s−t)ᵏ·Pᵢⱼ over i +
    /// j + k = n, for s, t, 1−s−t ≥ 0, with the corners P₀₀, P₀ₙ and Pₙ₀.
    std::vector<std::vector<mpq_class>> points;
    bool is_triangular = false;

    std::size_t point_count() const; ///< How many points there must be.
};

/// One polynomial or rational piece of a net.
struct NetPiece {
    /// Which of the nonempty knot spans it is, counted from 0, one number a direction that has knots.
    std::vector<std::size_t> span;
    /// Of a parameter t, or of s and t, that run from 0 to 1 over the span, or over the triangle s + t ≤ 1.
    Parametrization parametrization;
};

/// The pieces of a net, in the sequence of the last direction first: one for a Bézier net or triangle,
/// otherwise one a nonempty knot span, whose Bézier points are values of the polar form (Ramshaw, Blossoms
/// are polar forms, CAGD 6 (1989)).
///
/// \throws DomainError if numbers of points, knots or coordinates do not fit each other, if a degree is 0,
/// knots decrease or leave no span, or the weights of a piece are all 0; Stopped
std::vector<NetPiece> net_pieces(const ControlNet& net, base::Run& run);

/// Reads a control net:
///
///     rational bezier 3 2      or bezier, bspline, nurbs; degrees, one for a curve and two for a surface;
///                              or triangle 3, rational triangle 3: a triangular patch of that degree
///     coordinates x, y, z      optional; otherwise x, y or x, y, z by the numbers of a point
///     knots 0 0 0 1 2 2 2      for bspline and nurbs, one line a degree
///     1/2 0 1.25 1             a control point a line, those of the last degree first; `rational` and
///     `nurbs` …                        points end with their weight
///
/// Numbers are exact: integers, fractions and decimals, separated by blanks or commas. Comments begin with
/// `#`. \throws ParseError with the position of the first thing that does not fit; Stopped
ControlNet parse_control_net(const base::SourceText& source, base::Run& run);

} // namespace eliminant::implicit

namespace eliminant {
using implicit::ControlNet;
using implicit::net_pieces;
using implicit::NetPiece;
using implicit::parse_control_net;
} // namespace eliminant
