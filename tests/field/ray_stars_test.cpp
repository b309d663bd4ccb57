// Stars of rays against single rays: what the kernels call certain is so.
#include "field/ray_stars.hpp"

#include "field/surfaces.hpp"

#include "eliminant/field/ray_roots.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace eliminant::field {
namespace {

/// Columns of rays, and what StarRoots says of them.
class Stars {
  public:
    Stars(std::size_t points, std::size_t rays)
        : points_(points), padded_((points + 7) / 8 * 8), rays_(rays), lower_(padded_ * rays, 1.0),
          upper_(padded_ * rays, -1.0), states_(padded_ * rays) {
        for (auto& column : origin_) column.resize(padded_);
        for (auto& column : direction_) column.resize(padded_ * rays);
    }

    void set_origin(std::size_t point, glm::dvec3 origin) {
        for (std::size_t axis = 0; axis < 3; ++axis) origin_.at(axis)[point] = origin[static_cast<int>(axis)];
    }
    void set_ray(std::size_t point, std::size_t ray, glm::dvec3 direction, double lower, double upper) {
        const std::size_t at = ray * padded_ + point;
        for (std::size_t axis = 0; axis < 3; ++axis)
            direction_.at(axis)[at] = direction[static_cast<int>(axis)];
        lower_[at] = lower;
        upper_[at] = upper;
    }
    void solve(base::VectorUnit unit, const StarRoots& roots) {
        base::Run run;
        roots.solve(unit,
                    {.count = padded_,
                     .rays = rays_,
                     .origin = {origin_[0].data(), origin_[1].data(), origin_[2].data()},
                     .direction = {direction_[0].data(), direction_[1].data(), direction_[2].data()},
                     .lower = lower_.data(),
                     .upper = upper_.data(),
                     .state = states_.data()},
                    run);
    }
    RayState state(std::size_t point, std::size_t ray) const { return states_[ray * padded_ + point]; }
    /// What a single ray says.
    bool has_root(const RayRoots& roots, std::size_t point, std::size_t ray) const {
        base::Run run;
        const std::size_t at = ray * padded_ + point;
        const glm::dvec3 origin(origin_[0][point], origin_[1][point], origin_[2][point]);
        const glm::dvec3 direction(direction_[0][at], direction_[1][at], direction_[2][at]);
        return roots.first(origin, direction, lower_[at], upper_[at], run).kind != RayRoot::Kind::none;
    }

    std::size_t points() const { return points_; }
    std::size_t rays() const { return rays_; }

  private:
    std::size_t points_;
    std::size_t padded_;
    std::size_t rays_;
    std::array<std::vector<double>, 3> origin_;
    std::array<std::vector<double>, 3> direction_;
    std::vector<double> lower_;
    std::vector<double> upper_;
    std::vector<RayState> states_;
};

glm::dvec3 random_vector(std::mt19937_64& random) {
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    return {number(random), number(random), number(random)};
}

TEST(RayStars, AgreeWithSingleRaysOnEverySurface) {
    const unsigned seed = 41;
    for (const auto& [name, f] : test::surfaces()) {
        const StarRoots stars{DistanceField(f)};
        const RayRoots single(f);
        ASSERT_TRUE(stars.is_possible()) << name;
        for (const base::VectorUnit unit : base::available_vector_units()) {
            std::mt19937_64 random(seed);
            base::Run run;
            Stars rays(21, 5);
            for (std::size_t point = 0; point < rays.points(); ++point) {
                // Half of the points just beside the surface, as those that shadows are asked for.
                glm::dvec3 origin = 1.5 * random_vector(random);
                const glm::dvec3 towards = random_vector(random);
                const RayRoot hit = single.first(origin, towards, 0.0, 4.0, run);
                if (point % 2 == 0 && hit.kind == RayRoot::Kind::crossing) origin += (hit.t - 1e-6) * towards;
                rays.set_origin(point, origin);
                for (std::size_t ray = 0; ray < rays.rays(); ++ray)
                    rays.set_ray(point, ray, random_vector(random), ray == 3 ? 0.1 : 0.0,
                                 ray == 4 ? 0.5 : 3.0);
            }
            rays.solve(unit, stars);
            std::size_t undecided = 0;
            for (std::size_t point = 0; point < rays.points(); ++point)
                for (std::size_t ray = 0; ray < rays.rays(); ++ray) {
                    const RayState state = rays.state(point, ray);
                    if (state == RayState::undecided) {
                        ++undecided;
                        continue;
                    }
                    EXPECT_EQ(state == RayState::root, rays.has_root(single, point, ray))
                        << name << ", " << base::name(unit) << ", seed " << seed << ", ray " << ray
                        << " of point " << point;
                }
            EXPECT_LE(undecided, rays.points() * rays.rays() / 20) << name << ", " << base::name(unit);
        }
    }
}

TEST(RayStars, ClosedIntervalsEmptyOnesAndTangents) {
    const Polynomial sphere = test::polynomial("x^2+y^2+z^2-1");
    const StarRoots stars{DistanceField(sphere)};
    for (const base::VectorUnit unit : base::available_vector_units()) {
        Stars rays(3, 4);
        for (std::size_t point = 0; point < 3; ++point) rays.set_origin(point, {0.0, 0.0, 3.0});
        const glm::dvec3 down(0.0, 0.0, -1.0);
        rays.set_ray(0, 0, down, 0.0, 1.999999);
        rays.set_ray(0, 1, down, 0.0, 2.000001);
        rays.set_ray(0, 2, down, 2.000001, 3.999999);
        rays.set_ray(0, 3, down, 2.000001, 4.000001);
        rays.set_ray(1, 0, down, 1.0, 0.0);
        rays.set_ray(1, 1, -down, 0.0, 1e6);
        rays.set_ray(1, 2, down, 0.0, std::numeric_limits<double>::infinity());
        rays.set_ray(1, 3, down, 0.0, 0.0);
        rays.set_ray(2, 0, {0.3535533905932738, 0.0, -1.0}, 0.0, 10.0); // nearly a tangent
        rays.solve(unit, stars);
        EXPECT_EQ(rays.state(0, 0), RayState::no_root);
        EXPECT_EQ(rays.state(0, 1), RayState::root);
        EXPECT_EQ(rays.state(0, 2), RayState::no_root);
        EXPECT_EQ(rays.state(0, 3), RayState::root);
        EXPECT_EQ(rays.state(1, 0), RayState::no_root);
        EXPECT_EQ(rays.state(1, 1), RayState::no_root);
        EXPECT_EQ(rays.state(1, 2), RayState::undecided);
        EXPECT_NE(rays.state(1, 3), RayState::root);
        EXPECT_EQ(rays.state(2, 0), RayState::undecided);
        EXPECT_EQ(rays.state(2, 1), RayState::no_root) << "a ray that was not set is empty";
    }
}

/// An interval that ends within the kernel's overhang of a root has none.
TEST(RayStars, RootsJustBeyondTheEndAreNotTaken) {
    const Polynomial plane = test::polynomial("x-1");
    const StarRoots stars{DistanceField(plane)};
    const RayRoots single(plane);
    std::mt19937_64 random(5);
    for (const base::VectorUnit unit : base::available_vector_units()) {
        Stars rays(8, 8);
        for (std::size_t point = 0; point < 8; ++point) {
            rays.set_origin(point, {0.0, 0.25, 0.125});
            for (std::size_t ray = 0; ray < 8; ++ray) {
                const double beside = static_cast<double>(random() % 64) * 0x1p-53;
                rays.set_ray(point, ray, {1.0, 0.0, 0.0}, 0.0, 1.0 - beside);
            }
        }
        rays.solve(unit, stars);
        for (std::size_t point = 0; point < 8; ++point)
            for (std::size_t ray = 0; ray < 8; ++ray)
                if (rays.state(point, ray) != RayState::undecided) {
                    EXPECT_EQ(rays.state(point, ray) == RayState::root, rays.has_root(single, point, ray));
                }
    }
}

TEST(RayStars, NotForConstantsNorHighDegrees) {
    const StarRoots constant{DistanceField(test::polynomial("3"))};
    EXPECT_FALSE(constant.is_possible());
    const StarRoots high{DistanceField(test::polynomial("x^57+y-1"))};
    EXPECT_FALSE(high.is_possible());
}

} // namespace
} // namespace eliminant::field
