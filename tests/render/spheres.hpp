/// \file
/// A surface that needs no polynomial: the boundary of a union of balls, with exact answers in closed form.
#pragma once

#include "eliminant/scene/surface.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace eliminant::test {

/// Its function is the distance to the nearest sphere, negative inside. `flipped` changes the sign.
class Spheres : public scene::Surface {
  public:
    explicit Spheres(std::vector<scene::Ball> balls, bool flipped = false)
        : balls_(std::move(balls)), sign_(flipped ? -1 : 1) {}

    std::unique_ptr<scene::GridTracer> tracer(const scene::RayGrid& rays, const scene::ClipRegion& clip,
                                              base::Run&) const override {
        return std::make_unique<Tracer>(*this, rays, clip);
    }

    scene::Hit first_hit(const scene::Ray& ray, scene::Interval interval, base::Run& run) const override {
        const std::vector<scene::Hit> hits = all_hits(ray, interval, run);
        return hits.empty() ? scene::Hit{} : hits.front();
    }

    std::vector<scene::Hit> all_hits(const scene::Ray& ray, scene::Interval interval,
                                     base::Run& /*run*/) const override {
        std::vector<scene::Hit> hits;
        const double a = glm::dot(ray.direction, ray.direction);
        for (const scene::Ball& ball : balls_) {
            const glm::dvec3 to = ray.origin - ball.center;
            const double b = glm::dot(to, ray.direction);
            const double discriminant = b * b - a * (glm::dot(to, to) - ball.radius * ball.radius);
            if (discriminant < 0) continue;
            for (const double root : {-std::sqrt(discriminant), std::sqrt(discriminant)}) {
                const double t = (-b + root) / a;
                if (!interval.contains(t)) continue;
                scene::Hit hit;
                hit.t = t;
                hit.gradient = sign_ * glm::normalize(ray.at(t) - ball.center);
                hit.kind = discriminant > 0 ? scene::HitKind::crossing : scene::HitKind::tangency;
                hit.side = static_cast<std::int8_t>(root < 0 ? sign_ : -sign_);
                hits.push_back(hit);
            }
        }
        std::sort(hits.begin(), hits.end(), [](const auto& p, const auto& q) { return p.t < q.t; });
        return hits;
    }

    int sign(glm::dvec3 point) const override {
        const double f = value(point);
        return f > 0 ? 1 : f < 0 ? -1 : 0;
    }
    double value(glm::dvec3 point) const override { return sign_ * signed_distance(nearest(point), point); }
    glm::dvec3 gradient(glm::dvec3 point) const override {
        return sign_ * glm::normalize(point - nearest(point).center);
    }
    double distance(glm::dvec3 point, field::DistanceLevel) const override {
        return std::abs(signed_distance(nearest(point), point));
    }
    scene::Curvature curvature(glm::dvec3 point) const override {
        const double k = sign_ / nearest(point).radius;
        return {k, k * k, k, k};
    }
    scene::Ball framing_ball(base::Run& /*run*/) const override { return balls_.front(); }

  private:
    class Tracer : public scene::GridTracer {
      public:
        Tracer(const Spheres& surface, const scene::RayGrid& rays, const scene::ClipRegion& clip)
            : surface_(surface), rays_(rays), clip_(clip) {}
        void trace(const scene::Tile& tile, std::span<scene::Hit> hits, base::Run& run) const override {
            for (std::size_t i = 0; i < tile.size(); ++i) {
                const std::size_t column = tile.column + i % tile.width;
                const std::size_t row = tile.row + i / tile.width;
                const scene::Ray ray = rays_.ray(static_cast<double>(column), static_cast<double>(row));
                const scene::Interval inside = clip_.interval(ray);
                hits[i] = inside.empty() ? scene::Hit{} : surface_.first_hit(ray, inside, run);
            }
        }

      private:
        const Spheres& surface_;
        scene::RayGrid rays_;
        const scene::ClipRegion& clip_;
    };

    static double signed_distance(const scene::Ball& ball, glm::dvec3 point) {
        return glm::length(point - ball.center) - ball.radius;
    }
    const scene::Ball& nearest(glm::dvec3 point) const {
        return *std::min_element(balls_.begin(), balls_.end(), [&](const auto& p, const auto& q) {
            return std::abs(signed_distance(p, point)) < std::abs(signed_distance(q, point));
        });
    }

    std::vector<scene::Ball> balls_;
    double sign_;
};

} // namespace eliminant::test
