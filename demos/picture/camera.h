#pragma once

#include <span>

#include <hooke/vec3.h>
#include <Eigen/Core>

namespace hooke::picture {

/// Where a scene is seen from: a perspective camera that orbits its target.
struct Camera {
  Vec3 target = Vec3::Zero();  ///< [m]
  Vec3 up{0.0, 1.0, 0.0};      ///< unit length
  double azimuth = 0.45;       ///< [rad] around `up`, from the front
  double elevation = 0.2;      ///< [rad] above the plane across `up`, in (-pi/2, pi/2)
  double distance = 1.0;       ///< [m] of the eye from the target, > 0
  double field_of_view = 0.6;  ///< [rad] from the lowest to the highest pixel

  Vec3 eye() const;      ///< [m]
  Vec3 forward() const;  ///< unit length, from the eye to the target
  Vec3 right() const;    ///< unit length, to the right in the picture
  Vec3 over() const;     ///< unit length, upwards in the picture

  Eigen::Matrix4f view() const;
  /// For pictures `aspect` = width / height; everything from near to far [m] > 0 is seen.
  Eigen::Matrix4f projection(double aspect, double near, double far) const;

  /// Where a point is seen: from (-1, -1) at the lower left to (1, 1) at the upper right of the picture; the
  /// third is its depth [m] along `forward`, negative behind the eye.
  Vec3 project(const Vec3& point, double aspect) const;

  /// Unit vector from the eye through a place of the picture, given as by project().
  Vec3 ray(double x, double y, double aspect) const;
};

/// `camera`, looking in the same direction, moved to where all points [m] (x, y, z of each) are seen and fill
/// the picture up to a margin, as a share of its size [1].
Camera fitted(Camera camera, std::span<const float> points, double aspect, double margin = 0.06);

}  // namespace hooke::picture
