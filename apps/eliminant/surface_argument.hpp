/// \file
/// The operand SURFACE of the commands that look at one.
#pragma once

#include "option_set.hpp"
#include "parameter_image.hpp"
#include "session.hpp"

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/implicit/parametrization.hpp"

#include <gmpxx.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace eliminant::app {

/// `--set r=2`: the values of constants.
class ConstantValues {
  public:
    struct Value {
        std::string name;
        mpq_class value;
    };

    /// Adds the option. `*this` must outlive `options`.
    void declare(OptionSet& options);
    const std::vector<Value>& values() const { return values_; }

  private:
    void set(std::string_view text);
    std::vector<Value> values_;
};

/// What SURFACE means, for `--help`.
extern const std::string_view surface_help;

/// What SURFACE says.
struct SurfaceArgument {
    Polynomial polynomial;                         ///< its zeros are the surface; in the ring QQ[x, y, z]
    std::optional<Parametrization> map = {};       ///< where it came from, with numbers for constants
    ParameterRange range = ParameterRange::chosen; ///< of the map's parameters
};

/// Reads the operand. The operands are a polynomial
/// or an equation in x, y, z (text, a file or `-`), or a parametrization of two or three coordinates (a file,
/// `-`, or several statements), which is implicitized; its coordinates in their sequence become x, y, z.
///
/// A text is a parametrization if a line of it begins with `parameters`, `constants`, `relation` or the word
/// of a control net, or if several lines have an equals sign. \throws UsageError for a constant without a
/// value, a value for what does not occur, an image that is no
///   hypersurface; FileError, ParseError, Stopped
SurfaceArgument read_surface(std::span<const std::string> operands, const ConstantValues& constants,
                             Session& session);

} // namespace eliminant::app
