#pragma once

#include "eliminant/algebra/ring.hpp"
#include "eliminant/export/formats.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace eliminant::exporting {

/// Names for the ring's variables that can be used in a system: as they are where possible, otherwise without
/// what is not allowed, and with a letter appended until they are free. Distinct; none is one of the names
/// that declarations use.
std::vector<std::string> legal_names(const algebra::Ring& ring, Format format);

/// A name in math mode: `x_{12}` for x12 and x_12, `\alpha_{1}`, `\mathrm{speed}`.
std::string latex_name(std::string_view name);

/// The names of all variables in math mode, distinct: where two would look alike they are spelled out.
std::vector<std::string> latex_names(const algebra::Ring& ring);

} // namespace eliminant::exporting
