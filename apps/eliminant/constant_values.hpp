/// \file
/// Numbers in the place of symbolic constants.
#pragma once

#include "option_set.hpp"

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/implicit/parametrization.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace eliminant::app {

/// `--set r=2`: the values of constants.
class ConstantValues {
  public:
    /// Adds the option. `*this` must outlive `options`.
    void declare(OptionSet& options);

    /// The values of variables of a ring, in their sequence. \param owner whose constants they are, for
    /// messages, as `the surface`
    /// \throws UsageError for a constant without a value, or a value for what is not among them
    std::vector<mpq_class> of(const Ring& ring, std::span<const std::size_t> constants,
                              std::string_view owner) const;

    /// The parametrization with numbers for all of its constants, in a ring of the parameters alone, as it
    /// would have been read with the numbers in their place: coordinates are in lowest terms.
    /// \throws UsageError as above; DomainError if a denominator becomes zero; Stopped
    Parametrization put_into(const Parametrization& parametrization, std::string_view owner, Run& run) const;

  private:
    struct Value {
        std::string name;
        mpq_class value;
    };
    void set(std::string_view text);
    std::vector<Value> values_;
};

} // namespace eliminant::app
