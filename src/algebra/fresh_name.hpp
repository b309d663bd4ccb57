#pragma once

#include "eliminant/algebra/ring.hpp"

#include <string>
#include <string_view>

namespace eliminant::algebra {

/// An identifier that is not the name of a variable: `stem`, or `stem` with a number behind it.
std::string fresh_name(const Ring& ring, std::string_view stem);

} // namespace eliminant::algebra
