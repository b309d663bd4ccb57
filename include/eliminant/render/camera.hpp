/// \file
/// From a pixel to its ray.
#pragma once

#include "eliminant/render/image.hpp"
#include "eliminant/scene/ray.hpp"

#include <glm/vec3.hpp>

namespace eliminant::render {

/// Where a camera stands and how it is held.
struct Viewpoint {
    glm::dvec3 origin{0, 0, 1};  ///< the eye; for an orthographic camera a point of its image plane
    glm::dvec3 look_at{0, 0, 0}; ///< seen in the middle of the picture
    glm::dvec3 up{0, 1, 0};      ///< seen upright; of any length, not parallel to the line of sight
};

/// A pinhole or a parallel projection, right-handed: with the forward direction F, right is R = F × up and
/// the picture's up U = R × F, both of length 1.
///
/// In a picture of W × H pixels, the ray through the centre of the pixel in column c and row r (from the top
/// left) has x = (2c + 1 − W) / H and y = (H − 1 − 2r) / H, and
///
///     perspective:   origin + t · (F + T x R + T y U)       T = tan(vertical field of view / 2)
///     orthographic:  (origin + T x R + T y U) + t · F       T = half the height of what is seen
class Camera {
  public:
    /// \param viewpoint where it stands
    /// \param vertical_degrees the field of view from the top to the bottom of the picture, in (0, 180)
    /// \throws DomainError if a number is not finite or the field of view out of range, if `look_at` is the
    ///   origin, or `up` is 0 or parallel to the line of sight
    static Camera perspective(const Viewpoint& viewpoint, double vertical_degrees);
    /// \param viewpoint where it stands
    /// \param height of what is seen, in units of the scene, above 0
    /// \throws DomainError as perspective()
    static Camera orthographic(const Viewpoint& viewpoint, double height);

    bool is_perspective() const { return is_perspective_; }
    const glm::dvec3& origin() const { return origin_; }
    const glm::dvec3& forward() const { return forward_; } ///< F, of length 1
    const glm::dvec3& right() const { return right_; }     ///< R, of length 1
    const glm::dvec3& up() const { return up_; }           ///< U, of length 1
    double half_height() const { return half_height_; }    ///< T

    /// The rays through the centres of the pixels, column 0 and row 0 at the top left.
    scene::RayGrid rays(ImageSize size) const;
    /// The part of rays(size) that begins `border` pixels further up and left and ends as much further down
    /// and right.
    scene::RayGrid rays(ImageSize size, std::uint32_t border) const;

  private:
    Camera(const Viewpoint& viewpoint, bool is_perspective, double half_height);

    glm::dvec3 origin_;
    glm::dvec3 forward_{};
    glm::dvec3 right_{};
    glm::dvec3 up_{};
    bool is_perspective_;
    double half_height_;
};

} // namespace eliminant::render

namespace eliminant {
using render::Camera;
using render::Viewpoint;
} // namespace eliminant
