#include "eliminant/scene/algebraic_surface.hpp"

#include "scene/finite.hpp"
#include "scene/framing.hpp"
#include "scene/grid_tracer.hpp"
#include "scene/star_occlusion.hpp"

#include "field/ray_stars.hpp"

#include "eliminant/algebra/gcd.hpp"
#include "eliminant/field/compiled_polynomial.hpp"
#include "eliminant/field/distance.hpp"
#include "eliminant/field/ray_roots.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace eliminant::scene {
namespace {

Hit contained_at(double t) {
    Hit hit;
    hit.t = t;
    hit.kind = HitKind::contained;
    hit.decision = Decision::exact;
    return hit;
}

void require_interval(Interval interval) {
    if (std::isnan(interval.lower) || std::isnan(interval.upper) || std::isinf(interval.lower))
        throw base::DomainError("ray: the interval must start at a finite number and end at a number");
}

/// Goldman, Curvature formulas for implicit curves and surfaces (CAGD 22 (2005) 632–658), with the sign that
/// makes a sphere positive.
Curvature curvature_of(const field::Jet& jet) {
    const glm::dvec3 g = jet.gradient;
    const double squared = glm::dot(g, g);
    if (!(squared > 0.0)) return {};
    const field::SymmetricMatrix& h = jet.hessian;
    const glm::dmat3 hessian = h.matrix();
    const glm::dmat3 adjugate(h.yy * h.zz - h.yz * h.yz, h.xz * h.yz - h.xy * h.zz, h.xy * h.yz - h.xz * h.yy,
                              h.xz * h.yz - h.xy * h.zz, h.xx * h.zz - h.xz * h.xz, h.xy * h.xz - h.xx * h.yz,
                              h.xy * h.yz - h.xz * h.yy, h.xy * h.xz - h.xx * h.yz,
                              h.xx * h.yy - h.xy * h.xy);
    Curvature result;
    result.mean = (squared * h.trace() - glm::dot(g, hessian * g)) / (2.0 * squared * std::sqrt(squared));
    result.gaussian = glm::dot(g, adjugate * g) / (squared * squared);
    const double half_gap = std::sqrt(std::max(result.mean * result.mean - result.gaussian, 0.0));
    result.minimum = result.mean - half_gap;
    result.maximum = result.mean + half_gap;
    return result;
}

/// f = 0 for a squarefree f that is not constant.
class AlgebraicSurface final : public Surface {
  public:
    explicit AlgebraicSurface(algebra::Polynomial f)
        : f_(std::move(f)), distances_(f_), compiled_(distances_.polynomial()), roots_(f_),
          stars_(distances_) {}

    std::unique_ptr<GridTracer> tracer(const RayGrid& rays, const ClipRegion& clip,
                                       base::Run& run) const override {
        return make_grid_tracer(f_, compiled_, roots_, *this, rays, clip, run);
    }

    Hit first_hit(const Ray& ray, Interval interval, base::Run& run) const override {
        require_ray(ray);
        require_interval(interval);
        if (interval.empty()) return {};
        return hit_at(ray, roots_.first(ray.origin, ray.direction, interval.lower, interval.upper, run));
    }

    std::vector<Hit> all_hits(const Ray& ray, Interval interval, base::Run& run) const override {
        require_ray(ray);
        require_interval(interval);
        std::vector<Hit> hits;
        for (const field::RayRoot& root :
             roots_.all(ray.origin, ray.direction, interval.lower, interval.upper, run))
            hits.push_back(hit_at(ray, root));
        return hits;
    }

    bool occluded(const Ray& ray, Interval interval, base::Run& run) const override {
        require_ray(ray);
        require_interval(interval);
        return roots_.first(ray.origin, ray.direction, interval.lower, interval.upper, run).kind !=
               field::RayRoot::Kind::none;
    }

    void occluded(const RayStars& rays, const ClipRegion& clip, double reach, std::span<std::uint8_t> answers,
                  base::Run& run) const override {
        if (!stars_.is_possible()) return Surface::occluded(rays, clip, reach, answers, run);
        require_stars(rays, reach, answers.size());
        StarPacket packet(rays, clip, reach);
        for (const StarPacket::Ray& rest : packet.solve(stars_, answers, run))
            answers[rest.index] = occluded(rays.ray(rest.index), rest.interval, run) ? 1 : 0;
    }

    int sign(glm::dvec3 point) const override {
        if (!is_finite(point)) throw base::DomainError("sign: the point must be finite");
        return compiled_.sign(point);
    }
    double value(glm::dvec3 point) const override { return compiled_.value(point); }
    glm::dvec3 gradient(glm::dvec3 point) const override { return compiled_.jet(point).gradient; }
    double distance(glm::dvec3 point, field::DistanceLevel level) const override {
        if (!is_finite(point)) throw base::DomainError("distance: the point must be finite");
        return field::distance(distances_, point, level).value;
    }
    Curvature curvature(glm::dvec3 point) const override { return curvature_of(compiled_.jet(point)); }
    Ball framing_ball(base::Run& run) const override { return frame(*this, f_, run); }

  private:
    Hit hit_at(const Ray& ray, const field::RayRoot& root) const {
        Hit hit;
        hit.side = static_cast<std::int8_t>(root.side);
        hit.steps = static_cast<std::uint8_t>(std::min(root.steps, 255));
        hit.decision = root.precision == field::Precision::doubles ? Decision::vector
                       : root.precision == field::Precision::wide  ? Decision::wide
                                                                   : Decision::exact;
        if (root.kind == field::RayRoot::Kind::none) return hit;
        hit.t = root.t;
        hit.kind = root.kind == field::RayRoot::Kind::crossing   ? HitKind::crossing
                   : root.kind == field::RayRoot::Kind::tangency ? HitKind::tangency
                                                                 : HitKind::contained;
        hit.gradient = compiled_.jet(ray.at(root.t)).gradient;
        return hit;
    }

    algebra::Polynomial f_;
    field::DistanceField distances_;
    field::CompiledPolynomial compiled_;
    field::RayRoots roots_;
    field::StarRoots stars_;
};

/// f = c for a number c: everywhere or nowhere.
class ConstantSurface final : public Surface {
  public:
    explicit ConstantSurface(int sign) : sign_(sign) {}

    std::unique_ptr<GridTracer> tracer(const RayGrid& rays, const ClipRegion& clip,
                                       base::Run& /*run*/) const override {
        return make_ray_by_ray_tracer(*this, rays, clip);
    }
    Hit first_hit(const Ray& ray, Interval interval, base::Run& /*run*/) const override {
        require_ray(ray);
        require_interval(interval);
        if (interval.empty()) return {};
        if (sign_ == 0) return contained_at(interval.lower);
        Hit miss;
        miss.side = static_cast<std::int8_t>(sign_);
        return miss;
    }
    std::vector<Hit> all_hits(const Ray& ray, Interval interval, base::Run& run) const override {
        const Hit hit = first_hit(ray, interval, run);
        return hit ? std::vector{hit} : std::vector<Hit>{};
    }
    int sign(glm::dvec3 /*point*/) const override { return sign_; }
    double value(glm::dvec3 /*point*/) const override { return sign_; }
    glm::dvec3 gradient(glm::dvec3 /*point*/) const override { return glm::dvec3(0.0); }
    double distance(glm::dvec3 /*point*/, field::DistanceLevel /*level*/) const override {
        return sign_ == 0 ? 0.0 : std::numeric_limits<double>::infinity();
    }
    Curvature curvature(glm::dvec3 /*point*/) const override { return {}; }
    Ball framing_ball(base::Run& /*run*/) const override { return {}; }

  private:
    int sign_;
};

} // namespace

std::unique_ptr<Surface> algebraic_surface(const algebra::Polynomial& f, base::Run& run) {
    if (!f.ring().field().is_rationals())
        throw base::DomainError("surface: a polynomial over the rationals is expected");
    if (f.ring().variable_count() > 3)
        throw base::DomainError("surface: a polynomial in at most three variables is expected");
    if (f.is_zero()) return std::make_unique<ConstantSurface>(0);
    if (f.is_constant()) return std::make_unique<ConstantSurface>(sgn(f.coefficient(0)));
    // Normalised to a positive leading coefficient; the sign of f is that of the surface.
    algebra::Polynomial g = squarefree_part(f, run);
    if (sgn(f.leading_coefficient()) < 0) g = -g;
    return std::make_unique<AlgebraicSurface>(std::move(g));
}

} // namespace eliminant::scene
