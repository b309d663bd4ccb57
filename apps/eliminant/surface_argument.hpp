/// \file
/// The operand SURFACE of the commands that look at one.
#pragma once

#include "constant_values.hpp"
#include "parameter_image.hpp"
#include "session.hpp"

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/implicit/parametrization.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace eliminant::app {

/// What SURFACE means, for `--help`.
extern const std::string_view surface_help;

/// What SURFACE says.
struct SurfaceArgument {
    Polynomial polynomial;                         ///< its zeros are the surface; in the ring QQ[x, y, z]
    std::optional<Parametrization> map = {};       ///< where it came from, with numbers for constants
    ParameterRange range = ParameterRange::chosen; ///< of the map's parameters
    std::string formula = {}; ///< the polynomial as written, if it is a text without constants
};

/// Reads the operand. The operands are a polynomial or an equation in x, y, z (text, a file or `-`), or a
/// parametrization of two or three coordinates (a file,
/// `-`, or several statements), which is implicitized; its coordinates in their sequence become x, y, z.
///
/// A text is a parametrization if a line of it begins with `parameters`, `constants`, `relation` or the word
/// of a control net, or if several lines have an equals sign.
/// \throws UsageError for a constant without a value, a value for what does not occur, an image that is no
/// hypersurface; FileError, ParseError, Stopped
SurfaceArgument read_surface(std::span<const std::string> operands, const ConstantValues& constants,
                             Session& session);

} // namespace eliminant::app
