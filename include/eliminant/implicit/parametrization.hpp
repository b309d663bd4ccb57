/// \file
/// Parametric equations: coordinates as rational functions of parameters.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/algebra/rational_function.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/base/source_text.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace eliminant::implicit {

/// Two parameters c, s (as indices of the ring) bound by c² + s² = 1: the cosine and the sine of an angle.
struct Rotation {
    std::size_t cosine;
    std::size_t sine;
};

/// One coordinate as a function of the parameters.
struct Coordinate {
    std::string name;
    algebra::RationalFunction value; ///< in the ring of the parametrization
};

/// A rational map from the zero set of relations in parameter space to the space of the coordinates, over ℚ
/// or, with symbolic constants, over the field ℚ(constants). An immutable value that satisfies what its
/// constructor checks.
class Parametrization {
  public:
    /// \param ring over ℚ; its variables are the parameters and the constants, in any sequence
    /// \param constants indices of the variables that are elements of the field
    /// \param coordinates at least one; at a point where a denominator is zero the map is not defined
    /// \param rotations pairs of parameters, no parameter in two of them
    /// \param relations polynomials of the ring that are zero on the domain
    /// \param warnings what the maker wants the reader of the result to know
    /// \throws DomainError where one of these conditions does not hold, if a coordinate has the name of
    /// another one or of a variable, if it is no identifier, or if a denominator is zero on all rotations;
    /// RingMismatchError
    Parametrization(algebra::Ring ring, std::vector<std::size_t> constants,
                    std::vector<Coordinate> coordinates, std::vector<Rotation> rotations = {},
                    std::vector<algebra::Polynomial> relations = {}, std::vector<std::string> warnings = {});

    const algebra::Ring& ring() const { return ring_; } ///< Of parameters and constants.
    const std::vector<std::size_t>& parameters() const { return parameters_; }       ///< The other variables.
    const std::vector<std::size_t>& constants() const { return constants_; }         ///< As given.
    const std::vector<Coordinate>& coordinates() const { return coordinates_; }      ///< As given.
    const std::vector<Rotation>& rotations() const { return rotations_; }            ///< As given.
    const std::vector<algebra::Polynomial>& relations() const { return relations_; } ///< Without zeros.
    const std::vector<std::string>& warnings() const { return warnings_; }           ///< As given.

    /// c² + s² − 1 for each rotation.
    std::vector<algebra::Polynomial> rotation_relations() const;

  private:
    algebra::Ring ring_;
    std::vector<std::size_t> parameters_;
    std::vector<std::size_t> constants_;
    std::vector<Coordinate> coordinates_;
    std::vector<Rotation> rotations_;
    std::vector<algebra::Polynomial> relations_;
    std::vector<std::string> warnings_;
};

/// Reads a parametrization, a statement a line:
///
///     # the torus                     comments and empty lines
///     parameters u, v                 optional; otherwise every name on a right-hand side that is neither a
///                                     coordinate nor a constant is a parameter
///     constants R, r                  optional; elements of the coefficient field
///     x = (R + r*cos(u))*cos(v)       a coordinate as a rational function
///     relation s^2 + t^3 = 0          a polynomial equation that the parameters satisfy, any number of them
///
/// Statements come in any sequence. `cos` and `sin` take an integer multiple of a parameter; a parameter that
/// also occurs outside of them is an independent variable there, and the result carries a warning.
///
/// The text may be a control net of one piece instead (control_net.hpp), and begin with a line `patch NAME`
/// (batch.hpp).
/// \throws ParseError with the position of the first thing that does not fit; Stopped
Parametrization parse_parametrization(const base::SourceText& source, base::Run& run);

/// The same for statements, not of control nets, given one by one, as on a command line; a text may hold
/// several lines.
Parametrization parse_parametrization(std::span<const base::SourceText> statements, base::Run& run);

} // namespace eliminant::implicit

namespace eliminant {
using implicit::Coordinate;
using implicit::Parametrization;
using implicit::parse_parametrization;
using implicit::Rotation;
} // namespace eliminant
