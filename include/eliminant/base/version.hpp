/// \file
/// The version of the library; CMake reads it from here.
#pragma once

#include <string_view>

namespace eliminant {

/// Version of the library and of the program, `major.minor.patch`.
inline constexpr std::string_view version_string = "0.1.0";

} // namespace eliminant
