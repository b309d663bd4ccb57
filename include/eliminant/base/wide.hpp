/// \file
/// 128-bit integers, a compiler extension on every platform that the library supports.
#pragma once

namespace eliminant::base {

__extension__ using Int128 = __int128;           ///< signed, two's complement
__extension__ using UInt128 = unsigned __int128; ///< unsigned

} // namespace eliminant::base
