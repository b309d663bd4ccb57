/// \file
/// The operand SURFACE of the commands that look at one.
#pragma once

#include "option_set.hpp"
#include "session.hpp"

#include "eliminant/algebra/polynomial.hpp"

#include <gmpxx.h>

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

/// The polynomial whose zeros are the surface, in a ring QQ[x, y, z] exactly. The operands are a polynomial
/// or an equation in x, y, z (text, a file or `-`), or a parametrization of two or three coordinates (a file,
/// `-`, or several statements), which is implicitized; its coordinates in their sequence become x, y, z.
///
/// A text is a parametrization if a line of it begins with `parameters`, `constants` or `relation`, or if
/// several lines have an equals sign. \throws UsageError for a constant without a value, a value for what
/// does not occur, an image that is no
///   hypersurface; FileError, ParseError, Stopped
Polynomial read_surface(std::span<const std::string> operands, const ConstantValues& constants,
                        Session& session);

} // namespace eliminant::app
