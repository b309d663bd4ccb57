// The rank of the differential of a rational map.
#pragma once

#include "eliminant/base/run.hpp"
#include "implicit/verify_map.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace eliminant::implicit {

/// A point of parameter space modulo a prime: a value for each variable of the map's ring.
struct RankPoint {
    std::uint64_t prime;
    std::vector<std::uint32_t> point;
};

/// The differential of the coordinates by the parameters, at a point.
struct DifferentialRank {
    std::size_t rank;
    std::uint32_t pivots; ///< the product of the pivots of the elimination, column by column: a maximal minor
};

/// nullopt where the denominator is zero. A rank over GF(p) at a point is one of the differential over ℚ at
/// least: a minor that is not zero at a point modulo p is not zero as a function. In characteristic 0 its
/// rank is the transcendence degree of the coordinates, the dimension of the image.
std::optional<DifferentialRank> differential_rank(const RationalMap& map, const RankPoint& at,
                                                  base::Run& run);

/// A point at which the rank is as given, if one of a few random ones is.
std::optional<RankPoint> point_of_rank(const RationalMap& map, std::size_t rank, base::Run& run);

} // namespace eliminant::implicit
