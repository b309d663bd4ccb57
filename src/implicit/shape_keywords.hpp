// How the lines begin that tell control nets from formulas.
#pragma once

#include "eliminant/base/source_text.hpp"

namespace eliminant::implicit {

/// Whether a line is the first one of a control net: `bezier`, `triangle`, `rational`, `bspline` or `nurbs`,
/// and not the equation of a coordinate with such a name.
bool begins_control_net(const base::SourceText& line);

} // namespace eliminant::implicit
