// How many parameter values have the same image.
#pragma once

#include "implicit/verify_map.hpp"

#include <cstdint>
#include <optional>

namespace eliminant::implicit {

/// The greatest degree of a map whose fibres are counted: restricted to a line it is written densely.
constexpr std::int64_t max_counted_degree = 20000;

/// The degree of numerators and denominator in the variables.
std::int64_t degree_of(const RationalMap& map);

/// The number of points, over the algebraic closure, of the fibre over a general point of the image; nullopt
/// if it is infinite, if fibres do not agree, or if the degree of the map is beyond `max_counted_degree`.
///
/// Fibres are counted over the images of random points modulo two primes: for one parameter as roots of a
/// gcd, otherwise as the dimension of a residue class ring. Outside a hypersurface of points and a finite set
/// of primes the number is that of a general point, and the fibre is reduced (generic smoothness); nothing
/// bounds that set, so two fibres have to agree.
std::optional<std::uint64_t> map_degree(const RationalMap& map, base::Run& run);

} // namespace eliminant::implicit
