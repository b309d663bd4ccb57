#include "eliminant/render/sphere_tracer.hpp"

#include "eliminant/base/error.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace eliminant::render {
namespace {

/// A ray on its way:
///
///     ────(·····previous·····)──┬──────(·········)────▶
///                       free ───┘        point t
///
/// Everything up to `free` is known to hold no surface, if the distances are bounds.
struct Walker {
    scene::Ray ray;
    double length = 1; ///< of the direction
    double t = 0;      ///< where it stands
    double upper = 0;  ///< where the region ends
    double free = 0;   ///< edge of the last ball whose step was accepted
    double factor = 1; ///< of the next step: over-relaxation, or 1
    std::size_t pixel = 0;
    std::uint32_t steps = 0;
};

enum class Outcome : unsigned char { goes_on, went_back, left, came_near };

/// Moves a walker on, knowing that the ball of this radius around it is free.
Outcome advance(Walker& walker, double radius, double half_pixel) {
    const double reach = radius / walker.length; // in ray parameters
    // The first step starts with free = t. Later ones may have jumped over the edge of the last ball.
    if (walker.t > walker.free && walker.t - reach > walker.free) {
        walker.t = walker.free;
        walker.factor = 1;
        return Outcome::went_back;
    }
    walker.free = walker.t + reach;
    if (!(radius > half_pixel)) return Outcome::came_near;
    if (walker.free >= walker.upper) return Outcome::left;
    walker.t = std::min(walker.t + walker.factor * reach, walker.upper);
    return Outcome::goes_on;
}

scene::RayGrid checked(const scene::RayGrid& rays, const scene::ClipRegion& clip,
                       const SphereTracing& options) {
    if (!(options.over_relaxation >= 1 && options.over_relaxation < 2))
        throw DomainError("sphere tracing: expected an over-relaxation in [1, 2), found " +
                          std::to_string(options.over_relaxation));
    if (!clip.bounding_ball()) throw DomainError("sphere tracing: expected a bounded clip region");
    return rays;
}

double shorter(const glm::dvec3& a, const glm::dvec3& b) { return std::min(glm::length(a), glm::length(b)); }

} // namespace

/// The rays of a tile, stepped together so that distances are asked for in large batches.
class SphereTracer::Packet {
  public:
    Packet(const SphereTracer& tracer, const scene::Tile& tile, std::span<scene::Hit> hits)
        : tracer_(tracer), hits_(hits) {
        walkers_.reserve(tile.size());
        for (std::size_t i = 0; i < tile.size(); ++i) {
            hits[i] = {};
            const std::size_t rows_above = i / tile.width;
            const scene::Ray ray = tracer.rays_.ray(static_cast<double>(tile.column + i % tile.width),
                                                    static_cast<double>(tile.row + rows_above));
            const scene::Interval inside = tracer.clip_.interval(ray);
            if (inside.empty()) continue;
            walkers_.push_back({ray, glm::length(ray.direction), inside.lower, inside.upper, inside.lower,
                                tracer.options_.over_relaxation, i, 0});
        }
        statistics.rays = walkers_.size();
    }

    bool done() const { return walkers_.empty(); }

    /// One step of every ray that is still on its way.
    void step(base::Run& run) {
        points_.clear();
        for (const Walker& walker : walkers_) points_.push_back(walker.ray.at(walker.t));
        radii_.resize(points_.size());
        constexpr std::size_t batch = 256; // a few milliseconds at degree 18
        for (std::size_t begin = 0; begin < points_.size(); begin += batch) {
            const std::size_t count = std::min(batch, points_.size() - begin);
            run.poll();
            tracer_.surface_.distances(std::span(points_).subspan(begin, count), tracer_.options_.level,
                                       std::span(radii_).subspan(begin, count));
        }
        statistics.steps += points_.size();
        std::size_t kept = 0;
        for (std::size_t i = 0; i < walkers_.size(); ++i)
            if (goes_on(walkers_[i], radii_[i], run)) walkers_[kept++] = walkers_[i];
        walkers_.resize(kept);
    }

    SphereStatistics statistics;

  private:
    bool goes_on(Walker& walker, double radius, base::Run& run) {
        const double half_pixel = tracer_.pixel_at_origin_ + walker.t * tracer_.pixel_growth_;
        ++walker.steps;
        const Outcome outcome = advance(walker, radius, half_pixel);
        if (outcome == Outcome::went_back) ++statistics.back_steps;
        if (outcome == Outcome::left) {
            ++statistics.left;
            hits_[walker.pixel].steps = saturated(walker.steps);
            return false;
        }
        if (outcome == Outcome::came_near) {
            ++statistics.came_near;
            hand_over(walker, walker.t, run);
            return false;
        }
        if (walker.steps < tracer_.options_.most_steps) return true;
        ++statistics.ran_out;
        hand_over(walker, std::min(walker.free, walker.upper), run);
        return false;
    }

    void hand_over(const Walker& walker, double from, base::Run& run) {
        scene::Hit& hit = hits_[walker.pixel];
        hit = tracer_.surface_.first_hit(walker.ray, {from, walker.upper}, run);
        hit.steps = saturated(walker.steps);
    }

    static std::uint8_t saturated(std::uint32_t steps) {
        return static_cast<std::uint8_t>(std::min(steps, std::uint32_t{255}));
    }

    const SphereTracer& tracer_;
    std::span<scene::Hit> hits_;
    std::vector<Walker> walkers_;
    std::vector<glm::dvec3> points_;
    std::vector<double> radii_;
};

SphereTracer::SphereTracer(const scene::Surface& surface, const scene::RayGrid& rays,
                           const scene::ClipRegion& clip, const SphereTracing& options)
    : surface_(surface), rays_(checked(rays, clip, options)), clip_(clip), options_(options),
      pixel_at_origin_(shorter(rays.origin_dx, rays.origin_dy) / 2),
      pixel_growth_(shorter(rays.direction_dx, rays.direction_dy) / 2) {}

void SphereTracer::trace(const scene::Tile& tile, std::span<scene::Hit> hits, base::Run& run) const {
    if (hits.size() != tile.size() || tile.width > rays_.width || tile.height > rays_.height ||
        tile.column > rays_.width - tile.width || tile.row > rays_.height - tile.height)
        throw DomainError("sphere tracing: a tile does not lie in its grid");
    Packet packet(*this, tile, hits);
    while (!packet.done()) packet.step(run);
    const SphereStatistics& seen = packet.statistics;
    const auto add = [](std::atomic<std::uint64_t>& counter, std::uint64_t count) {
        counter.fetch_add(count, std::memory_order_relaxed);
    };
    add(counters_.rays, seen.rays);
    add(counters_.steps, seen.steps);
    add(counters_.back_steps, seen.back_steps);
    add(counters_.left, seen.left);
    add(counters_.came_near, seen.came_near);
    add(counters_.ran_out, seen.ran_out);
}

SphereStatistics SphereTracer::statistics() const {
    return {counters_.rays, counters_.steps,     counters_.back_steps,
            counters_.left, counters_.came_near, counters_.ran_out};
}

} // namespace eliminant::render
