#pragma once

#include "eliminant/algebra/system.hpp"

#include <span>
#include <string>

namespace eliminant::algebra {

// One reader a format; parse_system says what they throw.

System read_eliminant_system(const base::SourceText& source, const SystemOverrides& overrides,
                             base::Run& run);
System read_msolve_system(const base::SourceText& source, const SystemOverrides& overrides, base::Run& run);
System read_singular_system(const base::SourceText& source, const SystemOverrides& overrides, base::Run& run);

/// The order of the overrides on variables of these names, or `otherwise`.
MonomialOrder order_or(const SystemOverrides& overrides, std::span<const std::string> names,
                       MonomialOrder otherwise);

} // namespace eliminant::algebra
