#include "scene/star_occlusion.hpp"

#include "scene/clip_rows.hpp"
#include "scene/finite.hpp"

#include "base/vector_unit.hpp"

#include "eliminant/base/error.hpp"

namespace eliminant::scene {

void require_stars(const RayStars& rays, double reach, std::size_t answers) {
    const std::size_t count = rays.directions.size();
    if (answers != count) throw base::DomainError("occlusion: as many answers as rays are expected");
    if (rays.origins.empty() ? count != 0 : count % rays.origins.size() != 0)
        throw base::DomainError("occlusion: as many rays from each point are expected");
    if (!(reach >= 0.0)) throw base::DomainError("occlusion: a reach of at least 0 is expected");
    for (std::size_t k = 0; k < count; ++k) require_ray(rays.ray(k));
}

StarPacket::StarPacket(const RayStars& rays, const ClipRegion& clip, double reach)
    : points_(rays.origins.size()),
      padded_((points_ + field::StarRays::padding - 1) / field::StarRays::padding * field::StarRays::padding),
      rays_(points_ == 0 ? 0 : rays.directions.size() / points_), lower_(rays_ * padded_),
      upper_(rays_ * padded_), states_(rays_ * padded_) {
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double>& origins = origins_[static_cast<std::size_t>(axis)];
        std::vector<double>& directions = directions_[static_cast<std::size_t>(axis)];
        origins.resize(padded_);
        for (std::size_t i = 0; i < points_; ++i) origins[i] = rays.origins[i][axis];
        directions.resize(rays_ * padded_, 1.0);
        for (std::size_t j = 0; j < rays_; ++j)
            for (std::size_t i = 0; i < points_; ++i)
                directions[j * padded_ + i] = rays.directions[j * points_ + i][axis];
    }
    star_clipper(base::best_vector_unit())(
        {.region = RegionParts::of(clip),
         .reach = reach,
         .count = padded_,
         .rays = rays_,
         .origin = {origins_[0].data(), origins_[1].data(), origins_[2].data()},
         .direction = {directions_[0].data(), directions_[1].data(), directions_[2].data()},
         .lower = lower_.data(),
         .upper = upper_.data()});
    for (std::size_t j = 0; j < rays_; ++j)
        for (std::size_t i = points_; i < padded_; ++i) {
            lower_[j * padded_ + i] = 1.0;
            upper_[j * padded_ + i] = -1.0;
        }
}

std::vector<StarPacket::Ray> StarPacket::solve(const field::StarRoots& roots, std::span<std::uint8_t> answers,
                                               base::Run& run) {
    const field::StarRays packet{
        .count = padded_,
        .rays = rays_,
        .origin = {origins_[0].data(), origins_[1].data(), origins_[2].data()},
        .direction = {directions_[0].data(), directions_[1].data(), directions_[2].data()},
        .lower = lower_.data(),
        .upper = upper_.data(),
        .state = states_.data()};
    roots.solve(base::best_vector_unit(), packet, run);
    std::vector<Ray> undecided;
    for (std::size_t j = 0; j < rays_; ++j)
        for (std::size_t i = 0; i < points_; ++i) {
            const std::size_t at = j * padded_ + i;
            const std::size_t index = j * points_ + i;
            if (states_[at] == field::RayState::undecided)
                undecided.push_back({index, {lower_[at], upper_[at]}});
            answers[index] = states_[at] == field::RayState::root ? 1 : 0;
        }
    return undecided;
}

} // namespace eliminant::scene
