// The rank of the differential of a rational map.
#pragma once

#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/implicit/certificate.hpp"
#include "implicit/verify_map.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace eliminant::implicit {

/// The differential of the coordinates by the parameters, at a point.
struct DifferentialRank {
    std::size_t rank;
    std::uint32_t minor; ///< the product of the pivots of the elimination, column by column: a maximal minor
};

/// \param point a value for each variable of the map's ring
///
/// nullopt where the denominator is zero. A rank over GF(p) at a point is one of the differential over ℚ at
/// least: a minor that is not zero at a point modulo p is not zero as a function. In characteristic 0 its
/// rank is the transcendence degree of the coordinates, the dimension of the image.
std::optional<DifferentialRank> differential_rank(const RationalMap& map, const algebra::PrimeField& field,
                                                  std::span<const std::uint32_t> point, base::Run& run);

/// The greatest rank at a few random points, if that is `rank` at least.
std::optional<RankClaim> rank_claim(const RationalMap& map, std::uint64_t rank, base::Run& run);

/// Whether the rank at the point is the one claimed, by the same elimination.
bool holds(const RationalMap& map, const RankClaim& claim, base::Run& run);

} // namespace eliminant::implicit
