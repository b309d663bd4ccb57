/// \file
/// Floating point of 256 bits.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gmpxx.h>

#include <cstdint>

namespace eliminant::field {

/// 256 bits; exponents of 31 bits hold every product of doubles that a polynomial of degree 1000 takes.
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<256, boost::multiprecision::digit_base_2, void, std::int32_t>,
    boost::multiprecision::et_off>;

/// Relative error of one operation, with room to spare.
inline constexpr double wide_unit = 0x1p-254;

/// Within wide_unit.
Wide to_wide(const mpq_class& value);

/// To nearest; ±infinity or 0 where it is out of the range of doubles.
double to_double(const Wide& value);

} // namespace eliminant::field
